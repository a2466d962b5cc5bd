// SPDX-License-Identifier: MIT
// Files that VTK's own writer makes in every encoding, then damaged.
#include "io/check_mesh.h"
#include "io/expect_error.h"
#include "io/sample_meshes.h"
#include "vtk/mesh_file.h"
#include "vtk/vtk_mesh.h"

#include <gtest/gtest.h>

#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <ostream>
#include <random>
#include <string>

namespace tessera
{
namespace
{

using samples::PlateMesh;
using samples::secondOrderPlate;
using testing::expectError;
using testing::TemporaryFolder;

struct Variant
{
    const char* name;
    int mode; ///< vtkXMLWriter: 0 ASCII, 1 binary, 2 appended
    bool base64;
    int compressor; ///< vtkXMLWriter: 0 none, 1 zlib, 2 LZ4, 3 LZMA
    bool longHeader;
    bool bigEndian;
};

void PrintTo(const Variant& variant, std::ostream* out)
{
    *out << variant.name;
}

const Variant kVariants[] = {
    {"ascii", 0, false, 0, false, false},
    {"binary", 1, true, 0, false, false},
    {"binaryZlib", 1, true, 1, true, false},
    {"appendedRaw", 2, false, 0, true, false},
    {"appendedBase64", 2, true, 0, false, false},
    {"appendedZlib", 2, false, 1, false, false},
    {"appendedBase64Lz4", 2, true, 2, true, false},
    {"appendedLzma", 2, false, 3, true, false},
    {"bigEndian", 2, false, 0, true, true},
    {"bigEndianZlib", 1, true, 1, false, true},
};

/// The mesh as VTK writes it.
std::string fileOf(const Mesh& mesh, const Variant& variant)
{
    const TemporaryFolder folder;
    writeVtk(mesh, folder / "ours.vtu");
    vtkNew<vtkXMLUnstructuredGridReader> reader;
    reader->SetFileName((folder / "ours.vtu").c_str());
    vtkNew<vtkXMLUnstructuredGridWriter> writer;
    writer->SetInputConnection(reader->GetOutputPort());
    writer->SetFileName((folder / "theirs.vtu").c_str());
    writer->SetDataMode(variant.mode);
    writer->SetEncodeAppendedData(variant.base64);
    writer->SetCompressorType(variant.compressor);
    writer->SetBlockSize(256);
    variant.longHeader ? writer->SetHeaderTypeToUInt64() : writer->SetHeaderTypeToUInt32();
    variant.bigEndian ? writer->SetByteOrderToBigEndian() : writer->SetByteOrderToLittleEndian();
    EXPECT_EQ(writer->Write(), 1);
    return testing::readAll(folder / "theirs.vtu");
}

class VtuVariants: public ::testing::TestWithParam<Variant>
{};
INSTANTIATE_TEST_SUITE_P(Encodings, VtuVariants, ::testing::ValuesIn(kVariants),
                         [](const auto& info) { return std::string(info.param.name); });

TEST_P(VtuVariants, IsReadExactly)
{
    for (const bool second : {false, true}) {
        const Mesh mesh = second ? secondOrderPlate(9) : PlateMesh(9).mesh;
        const RawMesh raw = parseVtu(fileOf(mesh, GetParam()), "a.vtu");
        ASSERT_EQ(raw.nodes.size(), mesh.nodes.size());
        const bool exact = GetParam().mode != 0; // VTK's ASCII has 11 digits
        for (std::size_t i = 0; i < raw.nodes.size(); ++i) {
            EXPECT_NEAR(raw.nodes[i][0], mesh.nodes[i].x, exact ? 0.0 : 1e-8);
            EXPECT_NEAR(raw.nodes[i][1], mesh.nodes[i].y, exact ? 0.0 : 1e-8);
        }
        ASSERT_EQ(raw.cells.size(), mesh.triangles.size() + mesh.edges.size());
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
            const auto nodes = raw.nodesOfCell(raw.cells[t]);
            EXPECT_TRUE(std::equal(mesh.triangles[t].begin(), mesh.triangles[t].end(),
                                   nodes.begin()));
            EXPECT_EQ(raw.cells[t].kind, second ? CellKind::Triangle6 : CellKind::Triangle3);
        }
        if (exact) {
            EXPECT_EQ(checkMesh(raw).problems, std::vector<std::string> {});
        }
    }
}

TEST_P(VtuVariants, TruncatedAnywhereIsRefused)
{
    const std::string text = fileOf(PlateMesh(3).mesh, GetParam());
    ASSERT_TRUE(testing::succeedsOrIsRefused([&] { parseVtu(text, "whole.vtu"); }));
    for (std::size_t length = 0; length < text.size() - 1; ++length) {
        EXPECT_FALSE(testing::succeedsOrIsRefused(
            [&] { parseVtu(std::string_view(text).substr(0, length), "cut.vtu"); }))
            << length;
    }
}

TEST_P(VtuVariants, DamagedBytesAreRefusedOrRead)
{
    const std::string text = fileOf(PlateMesh(3).mesh, GetParam());
    std::mt19937 random(5);
    for (int round = 0; round < 3000; ++round) {
        std::string bad = text;
        const int changes = 1 + round % 4;
        for (int i = 0; i < changes; ++i) {
            bad[random() % bad.size()] = static_cast<char>(random());
        }
        testing::succeedsOrIsRefused([&] { checkMesh(parseVtu(bad, "bad.vtu")); });
    }
}

TEST_P(VtuVariants, DamagedHeadersAreRefusedOrRead)
{
    const std::string text = fileOf(PlateMesh(3).mesh, GetParam());
    // Digits of counts, offsets and sizes in the tags.
    for (std::size_t at = 0; at < text.size() && text.compare(at, 13, "<AppendedData") != 0; ++at) {
        if (text[at] >= '0' && text[at] <= '9') {
            for (const char* digits : {"9", "0", "999999999", "-1", "99999999999999999999", "x"}) {
                std::string bad = text;
                bad.replace(at, 1, digits);
                testing::succeedsOrIsRefused([&] { checkMesh(parseVtu(bad, "bad.vtu")); });
            }
        }
        if (GetParam().mode == 0 && at > 4000) {
            break;
        }
    }
}

TEST(ReadVtu, SeveralPiecesPointsAndEmptyPieces)
{
    const std::string piece =
        "<Piece NumberOfPoints='3' NumberOfCells=\"2\"><Points><DataArray type=\"Float32\" "
        "NumberOfComponents=\"3\" format=\"ascii\"> 0 0 0 1 0 0 0 1 0 </DataArray></Points>"
        "<Cells><DataArray type=\"Int32\" Name=\"connectivity\" format=\"ascii\">0 0 1 "
        "2</DataArray>"
        "<DataArray type=\"Int32\" Name=\"offsets\" format=\"ascii\">1 4</DataArray>"
        "<DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">1 5</DataArray></Cells></Piece>";
    const RawMesh raw = parseVtu(
        "<?xml version=\"1.0\"?><!-- a > comment --><VTKFile type=\"UnstructuredGrid\">"
        "<UnstructuredGrid>" + piece + "<Piece NumberOfPoints=\"0\" NumberOfCells=\"0\"><Points/>"
        "<Cells></Cells></Piece>" + piece + "</UnstructuredGrid>\n</VTKFile>\n",
        "a.vtu");
    EXPECT_EQ(raw.nodes.size(), 6U);
    ASSERT_EQ(raw.cells.size(), 2U);
    EXPECT_EQ(raw.cells[1].number, 3);
    EXPECT_EQ(raw.nodesOfCell(raw.cells[1])[0], 3U);
}

TEST(ReadVtu, SaysWhatIsWrong)
{
    const auto refuse = [](const std::string& text, const std::string& expected) {
        expectError(ErrorKind::Unreadable, expected, [&] { parseVtu(text, "bad.vtu"); });
    };
    const auto file = [](const std::string& cells,
                         const std::string& points = "0 0 0 1 0 0 0 1 0") {
        return "<VTKFile type=\"UnstructuredGrid\"><UnstructuredGrid><Piece NumberOfPoints=\"3\" "
               "NumberOfCells=\"1\"><Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" "
               "format=\"ascii\">" + points + "</DataArray></Points><Cells>" + cells
            + "</Cells></Piece></UnstructuredGrid></VTKFile>";
    };
    const auto array = [](const std::string& name, const std::string& values) {
        return "<DataArray type=\"Int64\" Name=\"" + name + "\" format=\"ascii\">" + values
            + "</DataArray>";
    };
    const auto cells = [&](const std::string& nodes, const std::string& offset,
                           const std::string& type) {
        return array("connectivity", nodes) + array("offsets", offset) + array("types", type);
    };
    EXPECT_TRUE(checkMesh(parseVtu(file(cells("0 1 2", "3", "5")), "good.vtu")).valid());
    refuse("", "bad.vtu: this is no VTK XML file");
    refuse("<VTKFile type=\"PolyData\"></VTKFile>", "of type 'PolyData'; an UnstructuredGrid");
    refuse("<VTKFile type=\"UnstructuredGrid\">", "does not end with </VTKFile>");
    refuse("<VTKFile type=\"UnstructuredGrid><</VTKFile>", "its tags cannot be read");
    refuse(file(cells("0 1 3", "3", "5")), "cell 0 has a node 3; there are 3 nodes");
    refuse(file(cells("0 1 2", "4", "5")), "the array of the cells' nodes cannot be read");
    refuse(file(cells("0 1", "2", "5")), "cell 0 has not as many nodes as its type");
    refuse(file(cells("0 1 2", "3", "10")), "cell 0 has VTK type 10");
    refuse(file(cells("0 1 2", "-3", "5")), "the offsets of the cells are damaged");
    refuse(file(array("offsets", "3") + array("types", "5")), "cells' nodes is missing");
    refuse(file(cells("0 1 2", "3", "5"), "0 0 0"), "the array of the points cannot be read");
    refuse(file(cells("0 1 2", "3", "5"), "0 0 0 1 0 0 0 nan 0"), "not a finite number");
}

} // namespace
} // namespace tessera
