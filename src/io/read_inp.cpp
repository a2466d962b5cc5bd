// SPDX-License-Identifier: MIT
#include "io/inp_sets.h"
#include "io/raw_mesh_builder.h"
#include "io/read_text_mesh.h"

#include <array>
#include <optional>

namespace tessera
{

namespace
{

std::string inCapitals(std::string_view text)
{
    std::string result;
    for (char c : text) {
        if (c != ' ' && c != '\t') {
            result += c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
        }
    }
    return result;
}

/// The kind of an element type such as S3, CPS6, CPE4R, S8R5 or T3D2; none if it is not known.
std::optional<CellKind> kindOf(std::string_view type)
{
    struct Family
    {
        std::string_view prefix;
        bool isEdge;
    };
    // The longer prefixes first; what follows is the number of nodes and letters of variants.
    constexpr std::array<Family, 13> kFamilies {{
        {"STRI6", false}, // STRI65: 6 nodes, 5 degrees of freedom
        {"STRI", false},
        {"CPEG", false},
        {"CPE", false},
        {"CPS", false},
        {"CAX", false},
        {"M3D", false},
        {"DS", false},
        {"S", false},
        {"T2D", true},
        {"T3D", true},
        {"B2", true},
        {"B3", true},
    }};
    for (const Family& family : kFamilies) {
        if (!type.starts_with(family.prefix) || type.size() == family.prefix.size()) {
            continue;
        }
        if (family.prefix == "STRI6") {
            return CellKind::Triangle6;
        }
        const char count = type[family.prefix.size()];
        if (family.isEdge) {
            // B21, B22, B31, B32 count the order, T2D2, T3D3 the nodes.
            const bool beam = family.prefix.starts_with('B');
            const char first = beam ? '1' : '2';
            return count == first                        ? std::optional(CellKind::Edge2)
                : count == static_cast<char>(first + 1) ? std::optional(CellKind::Edge3)
                                                        : std::nullopt;
        }
        switch (count) {
            case '3':
                return CellKind::Triangle3;
            case '4':
                return CellKind::Quad4;
            case '6':
                return CellKind::Triangle6;
            case '8':
                return CellKind::Quad8;
            default:
                return std::nullopt;
        }
    }
    return std::nullopt;
}

class InpReader
{
public:
    InpReader(std::string_view text, const std::string& name)
        : lines_(text, name, '\0', ',')
        , builder_(lines_)
    {}

    RawMesh run()
    {
        Section section = Section::Other;
        while (lines_.next()) {
            const std::string_view line = lines_.peekRest();
            if (line.starts_with("**")) {
                continue;
            }
            if (line.starts_with('*')) {
                section = readKeyword(inCapitals(line));
            }
            else if (section == Section::Nodes) {
                readNode();
            }
            else if (section == Section::Elements) {
                readElement();
            }
            else if (section == Section::Set) {
                sets_.readMembers(lines_);
            }
        }
        if (builder_.mesh().nodes.empty()) {
            lines_.fail("the file has no *NODE; it is no input deck or cut off.");
        }
        sets_.requireMembers(builder_, lines_.file());
        return builder_.take();
    }

private:
    enum class Section
    {
        Nodes,
        Elements,
        Set,
        Other,
    };

    /// The line in capitals and without blanks.
    Section readKeyword(const std::string& line)
    {
        const std::string keyword = line.substr(0, line.find(','));
        if (keyword == "*NODE" || keyword == "*ELEMENT" || keyword == "*NSET"
            || keyword == "*ELSET") {
            sets_.define(line);
        }
        if (keyword == "*NODE") {
            return Section::Nodes;
        }
        if (keyword == "*NSET" || keyword == "*ELSET") {
            return Section::Set;
        }
        if (keyword == "*INCLUDE") {
            lines_.fail("*INCLUDE is not supported; give the file that has the mesh.");
        }
        if (keyword != "*ELEMENT") {
            return Section::Other;
        }
        const std::size_t at = line.find(",TYPE=");
        if (at == std::string::npos) {
            lines_.fail("*ELEMENT has no TYPE.");
        }
        const std::size_t begin = at + 6;
        type_ = line.substr(begin, line.find(',', begin) - begin);
        const std::optional<CellKind> kind = kindOf(type_);
        if (!kind) {
            lines_.fail(fmt::format("element type {} is not supported; a plane mesh has shell, "
                                    "plane or membrane elements with 3, 4, 6 or 8 nodes.",
                                    inQuotes(type_)));
        }
        kind_ = *kind;
        return Section::Elements;
    }

    void readNode()
    {
        const std::int64_t number = lines_.integer("node number");
        const double x = lines_.number("x coordinate");
        const double y = lines_.number("y coordinate");
        const double z = lines_.atEnd() ? 0.0 : lines_.number("z coordinate");
        builder_.addNode(number, {x, y, z});
    }

    /// An element may run on over several lines.
    void readElement()
    {
        builder_.beginCell(kind_, lines_.integer("element number"));
        std::array<std::int64_t, 8> nodes {};
        const std::size_t count = nodesOf(kind_);
        for (std::size_t i = 0; i < count; ++i) {
            if (lines_.atEnd()) {
                lines_.need("the rest of an element");
            }
            nodes[i] = lines_.integer("node number");
        }
        // Beams may have a node for their direction.
        if (!lines_.atEnd() && !isEdge(kind_)) {
            lines_.fail(fmt::format("element type {} has {} nodes; more are given.", type_, count));
        }
        if (kind_ == CellKind::Edge3) {
            std::swap(nodes[1], nodes[2]); // in a deck the mid node stands in the middle
        }
        for (std::size_t i = 0; i < count; ++i) {
            builder_.addCellNode(nodes[i]);
        }
    }

    LineReader lines_;
    RawMeshBuilder builder_;
    InpSets sets_;
    std::string type_;
    CellKind kind_ = CellKind::Triangle3;
};

} // namespace

RawMesh parseInp(std::string_view text, const std::string& name)
{
    return InpReader(text, name).run();
}

} // namespace tessera
