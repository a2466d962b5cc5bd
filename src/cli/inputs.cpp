// SPDX-License-Identifier: MIT
#include "cli/inputs.h"

#include "base/error.h"
#include "io/append_network.h"
#include "io/read_network.h"
#include "occt/read_cad.h"
#include "occt/read_shape.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <set>
#include <string_view>

namespace tessera::cli
{

namespace
{

enum class InputKind
{
    Poly,
    Wkt,
    Cad,
};

InputKind kindOf(const std::string& path)
{
    constexpr std::array<std::pair<std::string_view, InputKind>, 6> kKinds {{
        {".poly", InputKind::Poly},
        {".wkt", InputKind::Wkt},
        {".brep", InputKind::Cad},
        {".brp", InputKind::Cad},
        {".step", InputKind::Cad},
        {".stp", InputKind::Cad},
    }};
    const std::string extension = extensionOf(path);
    for (const auto& [known, kind] : kKinds) {
        if (known == extension) {
            return kind;
        }
    }
    throw Error(ErrorKind::Unreadable,
                fmt::format("{}: files of this kind cannot be read; give .poly, .wkt, .brep or "
                            ".step files.",
                            path));
}

void prefixNames(CurveNetwork& network, const std::string& prefix)
{
    for (Operand& operand : network.operands) {
        operand.name = prefix + operand.name;
    }
    for (std::string& name : network.curveNames) {
        name = prefix + name;
    }
    for (EmbeddedPoint& embedded : network.embedded) {
        embedded.name = prefix + embedded.name;
    }
}

/// A file of an imprint and its side.
using SidedFile = std::pair<std::string, ImprintSide>;

std::string stemOf(const std::string& path)
{
    return std::filesystem::path(path).stem().string();
}

ImprintInput readFlatImprint(const std::vector<SidedFile>& files,
                             const std::optional<Vec3>& direction)
{
    ImprintInput input;
    if (direction) { // polygons in one plane lie where they lie, whatever it is
        unitDirection(*direction, input.frame.z);
    }
    for (const auto& [path, side] : files) {
        CurveNetwork network = readNetwork(path);
        if (kindOf(path) == InputKind::Wkt) {
            prefixNames(network, stemOf(path) + "_");
        }
        input.side.insert(input.side.end(), network.operands.size(), side);
        appendNetwork(input.network, std::move(network));
    }
    input.origins.resize(input.side.size());
    return input;
}

ImprintInput readCadImprint(const std::vector<SidedFile>& files,
                            const std::optional<Vec3>& direction)
{
    std::vector<ImprintShape> shapes;
    for (const auto& [path, side] : files) {
        ImprintShape shape {shapeFromFile(path), side};
        shape.options.name = stemOf(path);
        shapes.push_back(std::move(shape));
    }
    try {
        return projectShapes(shapes, direction);
    }
    catch (const CadError& error) {
        throw Error(error.kind(), files[error.shape()].first + ": " + error.what());
    }
}

class InputReader
{
public:
    InputReader(const RoleLists& roles, bool several)
        : roles_(roles)
        , several_(several)
    {}

    void read(const std::string& path)
    {
        const InputKind kind = kindOf(path);
        CurveNetwork network = kind == InputKind::Cad ? readCadFile(path)
                                                      : readNetwork(path, roles_);
        for (const NetworkCurve& curve : network.curves) {
            const std::int64_t number =
                kind == InputKind::Poly ? curve.marker : static_cast<std::int64_t>(curve.source);
            numbers_.insert(number);
            inputs_.numberOfCurve.push_back(number);
        }
        if (kind == InputKind::Wkt && several_) {
            prefixNames(network, stemOf(path) + "_");
        }
        appendNetwork(inputs_.network, std::move(network));
    }

    Inputs finish()
    {
        for (const std::int32_t number : roles_.all()) {
            if (!numbers_.contains(number)) {
                throw Error(ErrorKind::InvalidOption,
                            fmt::format("No segment has the marker, line or edge number {} that "
                                        "--boundary, --constraint or --ignore lists.",
                                        number));
            }
        }
        inputs_.frame = plane_.value_or(PlaneFrame {});
        return std::move(inputs_);
    }

private:
    CurveNetwork readCadFile(const std::string& path)
    {
        CadOptions options;
        options.plane = plane_;
        if (several_) {
            options.name = stemOf(path);
        }
        if (!several_) { // of several files not each must have an edge of that number
            addEdgeRoles(options, roles_.boundary, Role::Boundary);
            addEdgeRoles(options, roles_.constraint, Role::Constraint);
            addEdgeRoles(options, roles_.ignored, Role::Ignored);
        }
        CadInput input = readCad(path, options);
        for (NetworkCurve& curve : input.network.curves) {
            roles_.apply(curve, curve.source);
        }
        plane_ = input.frame;
        inputs_.defaultWeld = std::max(inputs_.defaultWeld, input.defaultWeld);
        return std::move(input.network);
    }

    static void addEdgeRoles(CadOptions& options, const std::vector<std::int32_t>& edges,
                             Role role)
    {
        for (const std::int32_t edge : edges) {
            if (edge > 0) {
                options.edgeRoles.emplace_back(static_cast<std::uint32_t>(edge), role);
            }
        }
    }

    const RoleLists& roles_;
    bool several_;
    Inputs inputs_;
    std::optional<PlaneFrame> plane_;
    std::set<std::int64_t> numbers_; ///< markers, lines and edges that there are
};

} // namespace

Inputs readInputs(const std::vector<std::string>& paths, const RoleLists& roles)
{
    InputReader reader(roles, paths.size() > 1);
    for (const std::string& path : paths) {
        reader.read(path);
    }
    return reader.finish();
}

ImprintInput readImprint(const std::vector<std::string>& sources,
                         const std::vector<std::string>& targets,
                         const std::optional<Vec3>& direction)
{
    std::vector<SidedFile> files;
    for (const std::string& path : sources) {
        files.emplace_back(path, ImprintSide::Source);
    }
    for (const std::string& path : targets) {
        files.emplace_back(path, ImprintSide::Target);
    }
    const bool cad = kindOf(files.front().first) == InputKind::Cad;
    for (const auto& [path, side] : files) {
        if ((kindOf(path) == InputKind::Cad) != cad) {
            throw Error(ErrorKind::InvalidOption,
                        fmt::format("{} and {} cannot be imprinted together; give CAD files only, "
                                    "or .wkt and .poly only.",
                                    files.front().first, path));
        }
    }
    return cad ? readCadImprint(files, direction) : readFlatImprint(files, direction);
}

} // namespace tessera::cli
