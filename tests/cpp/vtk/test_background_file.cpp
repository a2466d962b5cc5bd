// SPDX-License-Identifier: MIT
#include "io/expect_error.h"
#include "io/sample_meshes.h"
#include "vtk/background_file.h"
#include "vtk/vtk_mesh.h"

#include <gtest/gtest.h>

#include <vtkNew.h>
#include <vtkXMLUnstructuredGridReader.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <random>
#include <string>

namespace tessera
{
namespace
{

using samples::PlateMesh;
using testing::expectError;
using testing::TemporaryFolder;

std::string fileOf(const std::string& data, const std::string& cells = "0 1 2 3",
                   const std::string& type = "9")
{
    const auto array = [](const std::string& name, const std::string& values) {
        return "<DataArray type=\"Float64\" Name=\"" + name + "\" format=\"ascii\">" + values
            + "</DataArray>";
    };
    return "<VTKFile type=\"UnstructuredGrid\"><UnstructuredGrid><Piece NumberOfPoints=\"4\" "
           "NumberOfCells=\"1\"><PointData>" + data + "</PointData><Points><DataArray "
           "type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">0 0 5 1 0 5 1 1 5 0 1 5"
           "</DataArray></Points><Cells>" + array("connectivity", cells)
        + array("offsets", std::to_string((cells.size() + 1) / 2)) + array("types", type)
        + "</Cells></Piece></UnstructuredGrid></VTKFile>";
}

const std::string kSizes = "<DataArray type=\"Float64\" Name=\"other\" format=\"ascii\">9 9 9 9"
                           "</DataArray><DataArray type=\"Float32\" Name=\"h\" format=\"ascii\">"
                           "1 2 3 4</DataArray>";

TEST(BackgroundFile, NodalDataOfWhatVtkWrites)
{
    const Mesh mesh = PlateMesh(9).mesh;
    const TemporaryFolder folder;
    writeVtk(mesh, folder / "ours.vtu");
    for (const int mode : {0, 1, 2}) {
        vtkNew<vtkXMLUnstructuredGridReader> reader;
        reader->SetFileName((folder / "ours.vtu").c_str());
        vtkNew<vtkXMLUnstructuredGridWriter> writer;
        writer->SetInputConnection(reader->GetOutputPort());
        writer->SetFileName((folder / "theirs.vtu").c_str());
        writer->SetDataMode(mode);
        ASSERT_EQ(writer->Write(), 1);
        const NodalField field =
            parseVtu(testing::readAll(folder / "theirs.vtu"), "theirs.vtu", "origin");
        ASSERT_EQ(field.values.size(), mesh.nodes.size());
        for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
            EXPECT_EQ(field.values[i], static_cast<double>(mesh.nodeOrigin[i]));
        }
        const BackgroundMesh background =
            readBackground((folder / "theirs.vtu").string() + ":origin");
        EXPECT_EQ(background.triangles.size(), mesh.triangles.size());
    }
}

TEST(BackgroundFile, QuadranglesBecomeTriangles)
{
    const TemporaryFolder folder;
    testing::writeAll(folder / "a.vtu", fileOf(kSizes));
    const BackgroundMesh mesh = readBackground((folder / "a.vtu").string() + ":h");
    ASSERT_EQ(mesh.triangles.size(), 2U);
    EXPECT_EQ(mesh.sizes, (std::vector<double> {1, 2, 3, 4}));
    const AreaSource source = backgroundSource(mesh);
    EXPECT_NEAR(source.size({0.5, 0.5}), 2.0, 1e-12);
    EXPECT_NEAR(source.size({1.0, 1.0}), 3.0, 1e-12);
}

TEST(BackgroundFile, SaysWhatIsWrong)
{
    const TemporaryFolder folder;
    const auto refuse = [&](ErrorKind kind, const std::string& text, const std::string& spec,
                            const std::string& expected) {
        testing::writeAll(folder / "a.vtu", text);
        expectError(kind, expected,
                    [&] { readBackground((folder / "a.vtu").string() + spec); });
    };
    refuse(ErrorKind::InvalidOption, fileOf(kSizes), "", "not of that form");
    refuse(ErrorKind::InvalidOption, fileOf(kSizes), ":", "not of that form");
    refuse(ErrorKind::Unreadable, fileOf(kSizes), ":size",
           "no point data called 'size'; there is other, h");
    refuse(ErrorKind::Unreadable, fileOf(""), ":h", "there is none");
    refuse(ErrorKind::Unreadable,
           fileOf("<DataArray type=\"Float64\" Name=\"h\" NumberOfComponents=\"2\" "
                  "format=\"ascii\">1 2 3 4 5 6 7 8</DataArray>"),
           ":h", "has 2 numbers a point");
    refuse(ErrorKind::Unreadable,
           fileOf("<DataArray type=\"Float64\" Name=\"h\" format=\"ascii\">1 2</DataArray>"), ":h",
           "the array of the sizes cannot be read");
    expectError(ErrorKind::Unreadable, "none.vtu",
                [&] { readBackground((folder / "none.vtu").string() + ":h"); });
    expectError(ErrorKind::Unreadable, "from .vtu files", [&] { readBackground("a.msh:h"); });
}

TEST(BackgroundFile, DamagedFilesAreRefusedOrRead)
{
    const std::string text = fileOf(kSizes);
    std::mt19937 random(5);
    for (int round = 0; round < 3000; ++round) {
        std::string bad = text;
        for (int i = 0; i <= round % 4; ++i) {
            bad[random() % bad.size()] = static_cast<char>(random());
        }
        testing::succeedsOrIsRefused([&] { parseVtu(bad, "bad.vtu", "h"); });
    }
}

} // namespace
} // namespace tessera
