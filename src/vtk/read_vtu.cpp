// SPDX-License-Identifier: MIT
// VTK's own reader believes what a file says and can crash on a damaged one, so this one reads the
// arrays that are needed (points, connectivity, offsets, types; one of the point data if asked) and
// checks all of them.
#include "base/error.h"
#include "io/text_file.h"
#include "vtk/vtk_mesh.h"
#include "vtk/vtu_data.h"
#include "vtk/xml_scanner.h"

#include <fmt/format.h>

#include <vtkCellType.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>

namespace tessera
{

namespace
{

/// A DataArray as its tag describes it.
struct ArrayTag
{
    VtuType type = VtuType::None;
    std::string format;
    std::string_view content;     ///< between its tags
    std::int64_t offset = -1;     ///< in the appended data
    std::int64_t components = 1;
};

struct PieceTag
{
    std::size_t points = 0;
    std::size_t cells = 0;
    std::optional<ArrayTag> positions;
    std::optional<ArrayTag> connectivity;
    std::optional<ArrayTag> offsets;
    std::optional<ArrayTag> types;
    std::optional<ArrayTag> wanted; ///< point data of the name that is looked for
};

/// What becomes of a cell type: a kind, or left out; none if it is refused.
struct CellUse
{
    std::optional<CellKind> kind;
};
std::optional<CellUse> useOf(int type)
{
    switch (type) {
        case VTK_LINE:
            return CellUse {CellKind::Edge2};
        case VTK_QUADRATIC_EDGE:
            return CellUse {CellKind::Edge3};
        case VTK_TRIANGLE:
            return CellUse {CellKind::Triangle3};
        case VTK_QUADRATIC_TRIANGLE:
            return CellUse {CellKind::Triangle6};
        case VTK_QUAD:
            return CellUse {CellKind::Quad4};
        case VTK_QUADRATIC_QUAD:
            return CellUse {CellKind::Quad8};
        case VTK_EMPTY_CELL:
        case VTK_VERTEX:
        case VTK_POLY_VERTEX:
            return CellUse {};
        default:
            return std::nullopt;
    }
}

class VtuReader
{
public:
    VtuReader(std::string_view text, std::string name)
        : text_(text)
        , name_(std::move(name))
    {}

    RawMesh run()
    {
        requireEnd();
        readTags();
        for (const PieceTag& piece : pieces_) {
            addPiece(piece);
        }
        return std::move(mesh_);
    }

    NodalField run(const std::string& array)
    {
        wanted_ = array;
        NodalField field {run(), {}};
        for (const PieceTag& piece : pieces_) {
            if (!piece.wanted && piece.points > 0) {
                fail(fmt::format("there is no point data called {}; there is {}.", inQuotes(array),
                                 pointArrays_.empty() ? "none" : pointArrays_));
            }
            if (piece.wanted && piece.wanted->components != 1) {
                fail(fmt::format("the point data {} has {} numbers a point; sizes have one.",
                                 inQuotes(array), piece.wanted->components));
            }
            const auto values = valuesOf(piece.wanted, "sizes", piece.points);
            field.values.insert(field.values.end(), values.begin(), values.end());
        }
        return field;
    }

private:
    [[noreturn]] void fail(const std::string& what) const
    {
        throw Error(ErrorKind::Unreadable, fmt::format("{}: {}", name_, what));
    }

    void requireEnd() const
    {
        std::string_view rest = text_;
        while (!rest.empty() &&
               (rest.back() == ' ' || (rest.back() >= '\t' && rest.back() <= '\r'))) {
            rest.remove_suffix(1);
        }
        if (text_.substr(0, 4096).find("<VTKFile") == std::string_view::npos) {
            fail("this is no VTK XML file.");
        }
        if (!rest.ends_with("</VTKFile>")) {
            fail("the file is cut off: it does not end with </VTKFile>.");
        }
    }

    std::size_t countOf(std::string_view text) const
    {
        std::int64_t value = 0;
        constexpr std::int64_t kMost = 0xfffffffe;
        if (!parseNumber(text, value) || value < 0 || value > kMost) {
            fail(fmt::format("{} is not a number of points or cells.", inQuotes(text)));
        }
        return static_cast<std::size_t>(value);
    }

    void readHeader(const XmlScanner& tag)
    {
        if (tag.attribute("type") != "UnstructuredGrid") {
            fail(fmt::format("this is a VTK file of type {}; an UnstructuredGrid is needed.",
                             inQuotes(tag.attribute("type"))));
        }
        const bool bigEndian = tag.attribute("byte_order") == "BigEndian";
        encoding_.swapBytes = bigEndian != (std::endian::native == std::endian::big);
        encoding_.headerBytes = tag.attribute("header_type") == "UInt64" ? 8 : 4;
        encoding_.compressor = std::string(tag.attribute("compressor"));
    }

    void readTags()
    {
        XmlScanner tag(text_);
        std::string_view section;
        while (tag.next()) {
            if (tag.name() == "AppendedData" && tag.isStart()) {
                appended_ = tag.position();
                appendedIsBase64_ = tag.attribute("encoding") == "base64";
                return;
            }
            if (!tag.isStart()) {
                section = {};
                continue;
            }
            if (tag.name() == "VTKFile") {
                readHeader(tag);
            }
            else if (tag.name() == "Piece") {
                pieces_.emplace_back();
                pieces_.back().points = countOf(tag.attribute("NumberOfPoints"));
                pieces_.back().cells = countOf(tag.attribute("NumberOfCells"));
            }
            else if (tag.name() == "Points" || tag.name() == "Cells"
                     || tag.name() == "PointData") {
                section = tag.name();
            }
            else if (tag.name() == "DataArray" && !pieces_.empty()) {
                takeArray(tag, section);
                skipToEnd(tag);
            }
        }
        if (tag.failed()) {
            fail("the file is damaged: its tags cannot be read.");
        }
    }

    /// Past what VTK writes into an array besides its data, to its end tag.
    void skipToEnd(XmlScanner& tag) const
    {
        while (!(tag.name() == "DataArray" && tag.isEnd())) {
            if (!tag.next()) {
                fail("a DataArray has no end.");
            }
        }
    }

    void takeArray(const XmlScanner& tag, std::string_view section)
    {
        PieceTag& piece = pieces_.back();
        const std::string_view name = tag.attribute("Name");
        std::optional<ArrayTag>* place = nullptr;
        if (section == "Points") {
            place = &piece.positions;
        }
        else if (section == "Cells") {
            place = name == "connectivity" ? &piece.connectivity
                : name == "offsets"        ? &piece.offsets
                : name == "types"          ? &piece.types
                                           : nullptr;
        }
        else if (section == "PointData") {
            if (pieces_.size() == 1) {
                pointArrays_ += (pointArrays_.empty() ? "" : ", ") + std::string(name);
            }
            place = name == wanted_ ? &piece.wanted : nullptr;
        }
        if (place == nullptr) {
            return;
        }
        ArrayTag array;
        array.type = vtuType(tag.attribute("type"));
        array.format = std::string(tag.attribute("format"));
        array.content = tag.isEnd() ? std::string_view() : tag.content();
        if (!tag.attribute("offset").empty() &&
            !parseNumber(tag.attribute("offset"), array.offset)) {
            fail("the offset of a DataArray is not a number.");
        }
        if (!tag.attribute("NumberOfComponents").empty()
            && !parseNumber(tag.attribute("NumberOfComponents"), array.components)) {
            fail("the number of components of a DataArray is not a number.");
        }
        *place = array;
    }

    std::vector<double> valuesOf(const std::optional<ArrayTag>& array, const char* name,
                                 std::size_t count) const
    {
        if (!array) {
            if (count == 0) {
                return {};
            }
            fail(fmt::format("the array of the {} is missing.", name));
        }
        try {
            if (array->format == "appended") {
                return decodeAppended(*array, count);
            }
            if (array->format == "binary") {
                VtuEncoding encoding = encoding_;
                encoding.base64 = true;
                return decodeBinary(array->content, encoding, array->type, count);
            }
            return decodeText(array->content, count);
        }
        catch (const std::string& reason) {
            fail(fmt::format("the array of the {} cannot be read: {}.", name, reason));
        }
    }

    std::vector<double> decodeAppended(const ArrayTag& array, std::size_t count) const
    {
        const std::size_t mark = text_.find('_', std::min(appended_, text_.size()));
        if (appended_ == 0 || mark == std::string_view::npos || array.offset < 0
            || static_cast<std::uint64_t>(array.offset) >= text_.size() - mark) {
            throw std::string("its offset leads out of the file");
        }
        VtuEncoding encoding = encoding_;
        encoding.base64 = appendedIsBase64_;
        return decodeBinary(text_.substr(mark + 1 + static_cast<std::size_t>(array.offset)),
                            encoding, array.type, count);
    }

    void addPiece(const PieceTag& piece)
    {
        const std::size_t firstNode = mesh_.nodes.size();
        if (piece.positions && piece.positions->components != 3) {
            fail("the points have not three coordinates.");
        }
        const auto positions = valuesOf(piece.positions, "points", 3 * piece.points);
        for (std::size_t i = 0; i < piece.points; ++i) {
            mesh_.nodes.push_back({positions[3 * i], positions[3 * i + 1], positions[3 * i + 2]});
            mesh_.nodeNumber.push_back(static_cast<std::int64_t>(mesh_.nodeNumber.size()));
        }
        const auto types = valuesOf(piece.types, "cell types", piece.cells);
        const auto offsets = valuesOf(piece.offsets, "cell offsets", piece.cells);
        const double last = offsets.empty() ? 0.0 : offsets.back();
        constexpr double kMost = 4294967294.0;
        if (!(last >= 0.0 && last <= kMost)) {
            fail("the offsets of the cells are damaged.");
        }
        const auto nodes =
            valuesOf(piece.connectivity, "cells' nodes", static_cast<std::size_t>(last));
        double begin = 0.0;
        for (std::size_t c = 0; c < piece.cells; ++c) {
            addCell(types[c], begin, offsets[c], nodes, firstNode, piece.points);
            begin = offsets[c];
        }
    }

    void addCell(double type, double begin, double end, const std::vector<double>& nodes,
                 std::size_t firstNode, std::size_t points)
    {
        const std::int64_t number = cellNumber_++;
        const bool inRange = type >= 0.0 && type <= 255.0;
        const std::optional<CellUse> use =
            inRange ? useOf(static_cast<int>(type)) : std::nullopt;
        if (!use) {
            fail(fmt::format("cell {} has VTK type {}; a plane mesh has lines, triangles and "
                             "quadrangles of order 1 or 2.",
                             number, type));
        }
        if (!(begin <= end) || !(end <= static_cast<double>(nodes.size()))) {
            fail("the offsets of the cells are damaged.");
        }
        if (!use->kind) {
            return;
        }
        if (end - begin != static_cast<double>(nodesOf(*use->kind))) {
            fail(fmt::format("cell {} has not as many nodes as its type.", number));
        }
        mesh_.cells.push_back(
            {*use->kind, static_cast<std::uint32_t>(mesh_.cellNodes.size()), number});
        for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) {
            if (!(nodes[i] >= 0.0 && nodes[i] < static_cast<double>(points))) {
                fail(fmt::format("cell {} has a node {}; there are {} nodes, numbered from 0.",
                                 number, nodes[i], points));
            }
            mesh_.cellNodes.push_back(
                static_cast<std::uint32_t>(firstNode + static_cast<std::size_t>(nodes[i])));
        }
    }

    std::string_view text_;
    std::string name_;
    VtuEncoding encoding_;
    std::size_t appended_ = 0; ///< where the appended data begins; 0: there is none
    bool appendedIsBase64_ = false;
    std::vector<PieceTag> pieces_;
    std::string wanted_;      ///< name of point data; empty: none
    std::string pointArrays_; ///< names of the first piece's point data
    RawMesh mesh_;
    std::int64_t cellNumber_ = 0;
};

} // namespace

RawMesh parseVtu(std::string_view text, const std::string& name)
{
    return VtuReader(text, name).run();
}

NodalField parseVtu(std::string_view text, const std::string& name, const std::string& array)
{
    return VtuReader(text, name).run(array);
}

} // namespace tessera
