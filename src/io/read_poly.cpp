// SPDX-License-Identifier: MIT
#include "io/read_poly.h"

#include "curve/default_roles.h"
#include "io/text_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace tessera
{

namespace
{

class PolyReader
{
public:
    PolyReader(std::string_view text, const std::string& name, std::filesystem::path nodePath)
        : lines_(text, name)
        , nodePath_(std::move(nodePath))
    {
        network_.operands.emplace_back().name = std::filesystem::path(name).stem().string();
    }

    CurveNetwork run(const RoleLists& roles)
    {
        readPointSection();
        readSegments();
        embedPoints();
        readHoles();
        readRegions();
        for (NetworkCurve& curve : network_.curves) {
            roles.apply(curve, curve.marker);
        }
        assignPolyRoles(network_, OperandId(0U), roles.all());
        if (lines_.next()) {
            lines_.fail("the file should end here; delete what follows the regions.");
        }
        return std::move(network_);
    }

private:
    void readPointSection()
    {
        lines_.need("the number of points");
        const std::size_t count = lines_.count("number of points");
        if (count > 0 || nodePath_.empty()) {
            readPoints(lines_, count);
            return;
        }
        std::error_code ignored;
        if (!std::filesystem::exists(nodePath_, ignored)) {
            lines_.fail(fmt::format("there are no points here, and no file {} beside.",
                                    nodePath_.filename().string()));
        }
        const std::string text = readTextFile(nodePath_);
        LineReader nodes(text, nodePath_.string());
        nodes.need("the number of points");
        readPoints(nodes, nodes.count("number of points"));
        if (nodes.next()) {
            nodes.fail("more points than the first line announced.");
        }
    }

    /// The reader stands behind the count.
    void readPoints(LineReader& lines, std::size_t count)
    {
        const std::size_t dimension = lines.atEnd() ? 2 : lines.count("dimension");
        if (dimension != 2) {
            lines.fail(fmt::format("the dimension is {}; it must be 2.", dimension));
        }
        const std::size_t attributes = lines.atEnd() ? 0 : lines.count("number of attributes");
        const bool marked = !lines.atEnd() && lines.count("number of boundary markers") > 0;
        const std::size_t reserve = std::min(count, lines.bytesLeft() / 6 + 1);
        network_.points.reserve(reserve);
        for (std::size_t i = 0; i < count; ++i) {
            lines.need(fmt::format("point {} of {}", i + 1, count));
            const std::int64_t number = lines.integer("point number");
            if (i == 0) {
                firstNumber_ = number;
            }
            if (number != firstNumber_ + static_cast<std::int64_t>(i)) {
                lines.fail(fmt::format("point {} stands where {} was expected; number the points "
                                       "one after the other.",
                                       number, firstNumber_ + static_cast<std::int64_t>(i)));
            }
            const double x = lines.number("x coordinate");
            const double y = lines.number("y coordinate");
            network_.addPoint({x, y});
            for (std::size_t k = 0; k < attributes && !lines.atEnd(); ++k) {
                lines.number("attribute");
            }
            if (marked) {
                pointMarkers_.push_back(readMarker(lines));
            }
        }
    }

    static std::int32_t readMarker(LineReader& lines)
    {
        const std::int64_t marker = lines.atEnd() ? 0 : lines.integer("boundary marker");
        if (marker < std::numeric_limits<std::int32_t>::min()
            || marker > std::numeric_limits<std::int32_t>::max()) {
            lines.fail(fmt::format("the boundary marker {} does not fit into 32 bits.", marker));
        }
        return static_cast<std::int32_t>(marker);
    }

    void readSegments()
    {
        lines_.need("the number of segments");
        const std::size_t count = lines_.count("number of segments");
        const bool marked = !lines_.atEnd() && lines_.count("number of boundary markers") > 0;
        network_.curves.reserve(std::min(count, lines_.bytesLeft() / 6 + 1));
        for (std::size_t i = 0; i < count; ++i) {
            lines_.need(fmt::format("segment {} of {}", i + 1, count));
            const std::int64_t number = lines_.integer("segment number");
            NetworkCurve curve;
            curve.start = readPointNumber();
            curve.end = readPointNumber();
            curve.operand = OperandId(0U);
            curve.marker = marked ? readMarker(lines_) : 0;
            curve.source = static_cast<std::uint32_t>(number);
            network_.curves.push_back(std::move(curve));
        }
    }

    PointId readPointNumber()
    {
        const std::int64_t number = lines_.integer("point number");
        const std::int64_t last =
            firstNumber_ + static_cast<std::int64_t>(network_.points.size()) - 1;
        if (number < firstNumber_ || number > last) {
            lines_.fail(fmt::format("there is no point {}; the points are {} to {}.", number,
                                    firstNumber_, last));
        }
        return PointId(static_cast<std::size_t>(number - firstNumber_));
    }

    void embedPoints()
    {
        std::vector<std::uint8_t> used(network_.points.size(), 0);
        for (const NetworkCurve& curve : network_.curves) {
            used[curve.start.index()] = 1;
            used[curve.end.index()] = 1;
        }
        for (std::size_t i = 0; i < used.size(); ++i) {
            const std::int32_t marker = pointMarkers_.empty() ? 0 : pointMarkers_[i];
            if (used[i] == 0 || marker != 0) {
                network_.embedded.push_back(
                    {PointId(i), OperandId(0U),
                     marker != 0 ? "PointMarker" + std::to_string(marker) : std::string()});
            }
        }
    }

    void readHoles()
    {
        lines_.need("the number of holes (a line '0' if there are none)");
        const std::size_t count = lines_.count("number of holes");
        for (std::size_t i = 0; i < count; ++i) {
            lines_.need(fmt::format("hole {} of {}", i + 1, count));
            lines_.integer("hole number");
            const double x = lines_.number("x coordinate");
            const double y = lines_.number("y coordinate");
            network_.holes.push_back({{x, y}, OperandId(0U)});
        }
    }

    void readRegions()
    {
        if (!lines_.next()) {
            return;
        }
        const std::size_t count = lines_.count("number of regions");
        for (std::size_t i = 0; i < count; ++i) {
            lines_.need(fmt::format("region {} of {}", i + 1, count));
            lines_.integer("region number");
            RegionPoint region;
            region.operand = OperandId(0U);
            region.position.x = lines_.number("x coordinate");
            region.position.y = lines_.number("y coordinate");
            region.attribute = lines_.atEnd() ? 0.0 : lines_.number("region attribute");
            region.maxArea = lines_.atEnd() ? 0.0 : std::max(0.0, lines_.number("largest area"));
            network_.regions.push_back(region);
        }
    }

    LineReader lines_;
    std::filesystem::path nodePath_;
    std::int64_t firstNumber_ = 1;
    std::vector<std::int32_t> pointMarkers_; ///< empty if the file has none
    CurveNetwork network_;
};

} // namespace

CurveNetwork parsePoly(std::string_view text, const std::string& name,
                       const std::filesystem::path& nodePath, const RoleLists& roles)
{
    return PolyReader(text, name, nodePath).run(roles);
}

CurveNetwork readPoly(const std::filesystem::path& path, const RoleLists& roles)
{
    std::filesystem::path nodePath = path;
    nodePath.replace_extension(".node");
    return parsePoly(readTextFile(path), path.string(), nodePath, roles);
}

} // namespace tessera
