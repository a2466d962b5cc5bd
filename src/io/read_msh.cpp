// SPDX-License-Identifier: MIT
#include "io/raw_mesh_builder.h"
#include "io/read_text_mesh.h"

#include <algorithm>
#include <array>
#include <optional>

namespace tessera
{

namespace
{

struct GmshType
{
    std::int64_t number;
    std::optional<CellKind> kind; ///< none: points, which are left out
    std::size_t nodes;            ///< in the file; what a cell does not have is read over
};
constexpr std::array<GmshType, 8> kTypes {{
    {1, CellKind::Edge2, 2},
    {2, CellKind::Triangle3, 3},
    {3, CellKind::Quad4, 4},
    {8, CellKind::Edge3, 3},
    {9, CellKind::Triangle6, 6},
    {10, CellKind::Quad8, 9},
    {15, std::nullopt, 1},
    {16, CellKind::Quad8, 8},
}};

class MshReader
{
public:
    MshReader(std::string_view text, const std::string& name)
        : lines_(text, name, '\0')
        , builder_(lines_)
    {}

    RawMesh run()
    {
        readFormat();
        bool nodes = false;
        bool elements = false;
        while (lines_.next()) {
            const std::string section(lines_.restOfLine());
            if (section == "$Nodes" && !nodes) {
                version4_ ? readNodes4() : readNodes2();
                nodes = true;
            }
            else if (section == "$Elements" && nodes && !elements) {
                version4_ ? readElements4() : readElements2();
                elements = true;
            }
            else if (section == "$Nodes" || section == "$Elements") {
                lines_.fail(section + " is repeated or in the wrong place.");
            }
            else if (section.starts_with('$')) {
                skipSection(section);
                continue;
            }
            else {
                lines_.fail(fmt::format("a section such as $Nodes was expected, not {}.",
                                        inQuotes(section)));
            }
            requireEnd("$End" + section.substr(1));
        }
        if (!elements) {
            lines_.fail("the file has no $Elements; it may be cut off.");
        }
        return builder_.take();
    }

private:
    void readFormat()
    {
        if (!lines_.next() || lines_.restOfLine() != "$MeshFormat") {
            lines_.fail("this is no MSH file: it does not start with $MeshFormat.");
        }
        lines_.need("the format version");
        const std::string version(lines_.word());
        if (version != "2.2" && version != "4.1") {
            lines_.fail(fmt::format("MSH version {} is not supported; save as 4.1 or 2.2.",
                                    inQuotes(version)));
        }
        version4_ = version == "4.1";
        if (lines_.integer("file type") != 0) {
            lines_.fail("binary MSH files are not supported; save as ASCII.");
        }
        requireEnd("$EndMeshFormat");
    }

    void requireEnd(const std::string& keyword)
    {
        lines_.need(keyword);
        const std::string_view found = lines_.restOfLine();
        if (found != keyword) {
            lines_.fail(fmt::format("{} was expected, not {}.", keyword, inQuotes(found)));
        }
    }

    void skipSection(const std::string& section)
    {
        const std::string end = "$End" + section.substr(1);
        do {
            lines_.need(end);
        } while (lines_.restOfLine() != end);
    }

    std::array<double, 3> readPosition()
    {
        const double x = lines_.number("x coordinate");
        const double y = lines_.number("y coordinate");
        return {x, y, lines_.number("z coordinate")};
    }

    void readNodes2()
    {
        lines_.need("the number of nodes");
        const std::size_t count = lines_.count("number of nodes");
        for (std::size_t i = 0; i < count; ++i) {
            lines_.need(fmt::format("node {} of {}", i + 1, count));
            const std::int64_t number = lines_.integer("node number");
            builder_.addNode(number, readPosition());
        }
    }

    void readNodes4()
    {
        lines_.need("the number of node blocks");
        const std::size_t blocks = lines_.count("number of node blocks");
        const std::size_t count = lines_.count("number of nodes");
        for (std::size_t b = 0; b < blocks; ++b) {
            lines_.need(fmt::format("node block {} of {}", b + 1, blocks));
            lines_.integer("entity dimension");
            lines_.integer("entity tag");
            lines_.integer("parametric flag");
            const std::size_t inBlock = lines_.count("number of nodes");
            std::vector<std::int64_t> numbers;
            for (std::size_t i = 0; i < inBlock; ++i) {
                lines_.need(fmt::format("node number {} of {}", i + 1, inBlock));
                numbers.push_back(lines_.integer("node number"));
            }
            for (std::size_t i = 0; i < inBlock; ++i) {
                lines_.need(fmt::format("node {} of {}", i + 1, inBlock));
                builder_.addNode(numbers[i], readPosition());
            }
        }
        if (builder_.mesh().nodes.size() != count) {
            lines_.fail(fmt::format("{} nodes were announced, {} are there.", count,
                                    builder_.mesh().nodes.size()));
        }
    }

    const GmshType& typeOf(std::int64_t number) const
    {
        const auto found = std::ranges::find(kTypes, number, &GmshType::number);
        if (found == kTypes.end()) {
            lines_.fail(fmt::format("element type {} is not supported; a plane mesh has lines, "
                                    "triangles and quadrangles of order 1 or 2.",
                                    number));
        }
        return *found;
    }

    void readCell(const GmshType& type, std::int64_t number)
    {
        if (type.kind) {
            builder_.beginCell(*type.kind, number);
        }
        for (std::size_t i = 0; i < type.nodes; ++i) {
            const std::int64_t node = lines_.integer("node number");
            if (type.kind && i < nodesOf(*type.kind)) {
                builder_.addCellNode(node);
            }
        }
    }

    void readElements2()
    {
        lines_.need("the number of elements");
        const std::size_t count = lines_.count("number of elements");
        for (std::size_t i = 0; i < count; ++i) {
            lines_.need(fmt::format("element {} of {}", i + 1, count));
            const std::int64_t number = lines_.integer("element number");
            const GmshType& type = typeOf(lines_.integer("element type"));
            const std::size_t tags = lines_.count("number of tags");
            for (std::size_t k = 0; k < tags; ++k) {
                lines_.integer("tag");
            }
            readCell(type, number);
        }
    }

    void readElements4()
    {
        lines_.need("the number of element blocks");
        const std::size_t blocks = lines_.count("number of element blocks");
        const std::size_t count = lines_.count("number of elements");
        std::size_t read = 0;
        for (std::size_t b = 0; b < blocks; ++b) {
            lines_.need(fmt::format("element block {} of {}", b + 1, blocks));
            lines_.integer("entity dimension");
            lines_.integer("entity tag");
            const GmshType& type = typeOf(lines_.integer("element type"));
            const std::size_t inBlock = lines_.count("number of elements");
            for (std::size_t i = 0; i < inBlock; ++i) {
                lines_.need(fmt::format("element {} of {}", i + 1, inBlock));
                const std::int64_t number = lines_.integer("element number");
                readCell(type, number);
            }
            read += inBlock;
        }
        if (read != count) {
            lines_.fail(fmt::format("{} elements were announced, {} are there.", count, read));
        }
    }

    LineReader lines_;
    RawMeshBuilder builder_;
    bool version4_ = false;
};

} // namespace

RawMesh parseMsh(std::string_view text, const std::string& name)
{
    return MshReader(text, name).run();
}

} // namespace tessera
