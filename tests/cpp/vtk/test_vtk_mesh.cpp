// SPDX-License-Identifier: MIT
// VTK, not our code, judges what we write.
#include "io/check_mesh.h"
#include "io/expect_error.h"
#include "io/sample_meshes.h"
#include "pipeline.h"
#include "vtk/mesh_file.h"
#include "vtk/vtk_mesh.h"

#include <gtest/gtest.h>

#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkCellSizeFilter.h>
#include <vtkCellValidator.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkUnstructuredGridReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace tessera
{
namespace
{

using samples::PlateMesh;
using samples::secondOrderPlate;
using testing::expectError;
using testing::TemporaryFolder;

vtkSmartPointer<vtkUnstructuredGrid> readWithVtk(const std::filesystem::path& path)
{
    if (path.extension() == ".vtk") {
        vtkNew<vtkUnstructuredGridReader> reader;
        reader->SetFileName(path.c_str());
        reader->Update();
        return reader->GetOutput();
    }
    vtkNew<vtkXMLUnstructuredGridReader> reader;
    reader->SetFileName(path.c_str());
    reader->Update();
    return reader->GetOutput();
}

/// What VTK says about a grid of triangles and lines.
struct Proof
{
    std::size_t triangles = 0;
    std::size_t lines = 0;
    std::size_t invalid = 0;      ///< cells that vtkCellValidator finds fault with
    double area = 0.0;            ///< of the triangles, by vtkCellSizeFilter
    double outlineLength = 0.0;   ///< of the sides that one triangle has
    std::size_t sidesOfMany = 0;  ///< sides of three triangles and more
    std::size_t linesBeside = 0;  ///< lines that are no triangle's side
};

Proof prove(vtkUnstructuredGrid& grid)
{
    Proof proof;
    vtkNew<vtkCellValidator> validator;
    validator->SetInputData(&grid);
    validator->Update();
    vtkDataArray* states =
        validator->GetOutput()->GetCellData()->GetArray("ValidityState");
    vtkNew<vtkCellSizeFilter> sizes;
    sizes->SetInputData(&grid);
    sizes->Update();
    vtkDataArray* areas =
        vtkDataSet::SafeDownCast(sizes->GetOutput())->GetCellData()->GetArray("Area");

    std::map<std::pair<vtkIdType, vtkIdType>, int> uses;
    std::vector<std::pair<vtkIdType, vtkIdType>> lines;
    for (vtkIdType c = 0; c < grid.GetNumberOfCells(); ++c) {
        vtkCell* cell = grid.GetCell(c);
        proof.invalid += states->GetComponent(c, 0) != 0.0 ? 1 : 0;
        if (cell->GetCellDimension() == 1) {
            ++proof.lines;
            lines.push_back(std::minmax(cell->GetPointId(0), cell->GetPointId(1)));
            continue;
        }
        ++proof.triangles;
        proof.area += areas->GetComponent(c, 0);
        for (int side = 0; side < cell->GetNumberOfEdges(); ++side) {
            vtkCell* edge = cell->GetEdge(side);
            ++uses[std::minmax(edge->GetPointId(0), edge->GetPointId(1))];
        }
    }
    for (const auto& [side, count] : uses) {
        if (count == 1) {
            double a[3];
            double b[3];
            grid.GetPoint(side.first, a);
            grid.GetPoint(side.second, b);
            proof.outlineLength += std::hypot(b[0] - a[0], b[1] - a[1]);
        }
        proof.sidesOfMany += count > 2 ? 1 : 0;
    }
    for (const auto& line : lines) {
        proof.linesBeside += uses.contains(line) ? 0 : 1;
    }
    return proof;
}

class VtkFiles: public ::testing::TestWithParam<const char*>
{
protected:
    TemporaryFolder folder_;
    std::filesystem::path path_ = folder_ / (std::string("mesh") + GetParam());
};
INSTANTIATE_TEST_SUITE_P(Formats, VtkFiles, ::testing::Values(".vtu", ".vtk"),
                         [](const auto& info) { return std::string(info.param).substr(1); });

TEST_P(VtkFiles, VtkFindsAllCellsValid)
{
    const PlateMesh plate(12);
    writeVtk(plate.mesh, path_);
    const auto grid = readWithVtk(path_);
    const Proof proof = prove(*grid);
    EXPECT_EQ(proof.triangles, plate.mesh.triangles.size());
    EXPECT_EQ(proof.lines, plate.mesh.edges.size());
    EXPECT_EQ(proof.invalid, 0U);
    EXPECT_NEAR(proof.area, plate.area(), 1e-12 * plate.area());
    EXPECT_NEAR(proof.outlineLength, plate.outlineLength(), 1e-12 * plate.outlineLength());
    EXPECT_EQ(proof.sidesOfMany, 0U);
    EXPECT_EQ(proof.linesBeside, 0U);
    EXPECT_EQ(grid->GetPoints()->GetDataType(), VTK_DOUBLE);
}

TEST_P(VtkFiles, CoordinatesAreExactAndTrianglesFirst)
{
    const Mesh mesh = PlateMesh(9).mesh;
    writeVtk(mesh, path_);
    const auto grid = readWithVtk(path_);
    ASSERT_EQ(grid->GetNumberOfPoints(), static_cast<vtkIdType>(mesh.nodes.size()));
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
        double p[3];
        grid->GetPoint(static_cast<vtkIdType>(i), p);
        EXPECT_EQ((Vec2 {p[0], p[1]}), mesh.nodes[i]);
        EXPECT_EQ(p[2], 0.0);
    }
    for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c) {
        const bool triangle = c < static_cast<vtkIdType>(mesh.triangles.size());
        EXPECT_EQ(grid->GetCellType(c), triangle ? VTK_TRIANGLE : VTK_LINE);
    }
}

TEST_P(VtkFiles, RegionsGroupsAndCurves)
{
    const Mesh mesh = PlateMesh(9).mesh;
    writeVtk(mesh, path_);
    const auto grid = readWithVtk(path_);
    vtkDataArray* region = grid->GetCellData()->GetArray("region");
    vtkDataArray* group = grid->GetCellData()->GetArray("group");
    vtkDataArray* curve = grid->GetCellData()->GetArray("curve");
    ASSERT_NE(region, nullptr);
    ASSERT_NE(group, nullptr);
    ASSERT_NE(curve, nullptr);
    const auto triangles = static_cast<vtkIdType>(mesh.triangles.size());
    for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c) {
        const auto i = static_cast<std::size_t>(c);
        if (c < triangles) {
            EXPECT_EQ(region->GetComponent(c, 0), mesh.triangleRegion[i]);
            EXPECT_EQ(group->GetComponent(c, 0), mesh.triangleRegion[i]);
            EXPECT_EQ(curve->GetComponent(c, 0), -1.0);
        }
        else {
            const double expected = mesh.edgeCurves[i - mesh.triangles.size()].value;
            EXPECT_EQ(region->GetComponent(c, 0), -1.0);
            EXPECT_EQ(group->GetComponent(c, 0), 3.0 + expected);
            EXPECT_EQ(curve->GetComponent(c, 0), expected);
        }
    }
    vtkFieldData* field = grid->GetFieldData();
    auto* names = vtkStringArray::SafeDownCast(field->GetAbstractArray("group_names"));
    ASSERT_NE(names, nullptr);
    ASSERT_EQ(names->GetNumberOfValues(), 7);
    EXPECT_EQ(names->GetValue(2), "Plate");
    vtkDataArray* offsets = field->GetArray("group_offsets");
    vtkDataArray* members = field->GetArray("group_members");
    EXPECT_EQ(offsets->GetComponent(3, 0) - offsets->GetComponent(2, 0),
              static_cast<double>(mesh.triangles.size()));
    const auto firstOfBorder = static_cast<vtkIdType>(offsets->GetComponent(3, 0));
    EXPECT_EQ(members->GetComponent(firstOfBorder, 0),
              static_cast<double>(mesh.triangles.size() + mesh.groups[3].members[0]));
    EXPECT_NE(grid->GetPointData()->GetArray("origin"), nullptr);
}

TEST_P(VtkFiles, OrderTwo)
{
    const PlateMesh plate(12);
    const Mesh mesh = secondOrderPlate(12);
    writeVtk(mesh, path_);
    const auto grid = readWithVtk(path_);
    const Proof proof = prove(*grid);
    EXPECT_EQ(proof.invalid, 0U);
    EXPECT_EQ(proof.triangles, mesh.triangles.size());
    EXPECT_NEAR(proof.outlineLength, plate.outlineLength(), 1e-12 * plate.outlineLength());
    EXPECT_EQ(grid->GetCellType(0), VTK_QUADRATIC_TRIANGLE);
    // VTK's own shape functions: the node at parameters (1/2, 0) is the one between corners 0, 1.
    for (vtkIdType c = 0; c < 20; ++c) {
        vtkCell* cell = grid->GetCell(c);
        const double middle[] = {0.5, 0.0, 0.0};
        double at[3];
        double weights[8];
        int sub = 0;
        cell->EvaluateLocation(sub, middle, at, weights);
        const auto node = mesh.triangleMidNodes[static_cast<std::size_t>(c)][2];
        EXPECT_NEAR(at[0], mesh.nodes[node].x, 1e-14);
        EXPECT_NEAR(at[1], mesh.nodes[node].y, 1e-14);
    }
}

TEST_P(VtkFiles, MeshWithoutAnything)
{
    writeVtk(Mesh(), path_);
    EXPECT_EQ(readWithVtk(path_)->GetNumberOfCells(), 0);
}

TEST(VtkFile, SaysWhatIsWrong)
{
    const TemporaryFolder folder;
    expectError(ErrorKind::Unreadable, "none.vtu: cannot be read: No such file",
                [&] { readMesh(folder / "none.vtu"); });
    expectError(ErrorKind::Unwritable, "cannot be written: there is no folder",
                [&] { writeVtk(Mesh(), folder / "no-folder/a.vtu"); });
    expectError(ErrorKind::Unwritable, "cannot be written: Is a directory", [&] {
        std::filesystem::create_directory(folder / "dir.vtu");
        writeVtk(Mesh(), folder / "dir.vtu");
    });
    expectError(ErrorKind::Unwritable, "meshes are written as .vtu, .vtk",
                [&] { writeMesh(Mesh(), folder / "a.obj"); });
    expectError(ErrorKind::Unreadable, "meshes are read from", [&] { readMesh(folder / "a.obj"); });
}

TEST(VtkFile, NeverHalfWritten)
{
    const TemporaryFolder folder;
    const auto path = folder / "mesh.vtu";
    testing::writeAll(path, "what was there before");
    const Mesh mesh = PlateMesh(3).mesh;
    writeMesh(mesh, path);
    EXPECT_EQ(folder.fileCount(), 1U); // nothing left beside
    EXPECT_TRUE(checkMesh(readMesh(path)).valid());
}

/// The whole path, judged by VTK: a square with a round hole and a line through it.
TEST(VtkFile, MeshOfThePipelineIsValid)
{
    CurveNetwork network;
    network.operands.emplace_back();
    const auto add = [&network](PointId a, PointId b, Role role) {
        NetworkCurve curve;
        curve.start = a;
        curve.end = b;
        curve.operand = OperandId(0U);
        curve.role = role;
        network.curves.push_back(curve);
    };
    const auto loop = [&](const std::vector<Vec2>& points) {
        const std::size_t first = network.points.size();
        for (Vec2 p : points) {
            network.addPoint(p);
        }
        for (std::size_t i = 0; i < points.size(); ++i) {
            add(PointId(first + i), PointId(first + (i + 1) % points.size()), Role::Boundary);
        }
    };
    loop({{0, 0}, {10, 0}, {10, 10}, {0, 10}});
    std::vector<Vec2> circle;
    const int sides = 24;
    for (int i = 0; i < sides; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / sides;
        circle.push_back({4.0 + 2.0 * std::cos(angle), 5.0 + 2.0 * std::sin(angle)});
    }
    loop(circle);
    add(network.addPoint({7, -1}), network.addPoint({9, 11}), Role::Constraint);

    MeshOptions options;
    options.size = 0.5;
    Execution execution;
    const MeshResult result = meshNetwork(network, options, execution);
    const TemporaryFolder folder;
    writeMesh(result.mesh, folder / "mesh.vtu");
    const Proof proof = prove(*readWithVtk(folder / "mesh.vtu"));
    const double hole = 0.5 * sides * 4.0 * std::sin(2.0 * std::numbers::pi / sides);
    const double outline = 40.0 + sides * 4.0 * std::sin(std::numbers::pi / sides);
    EXPECT_EQ(proof.invalid, 0U);
    EXPECT_NEAR(proof.area, 100.0 - hole, 1e-9);
    EXPECT_NEAR(proof.outlineLength, outline, 1e-9);
    EXPECT_EQ(proof.sidesOfMany, 0U);
    EXPECT_EQ(proof.linesBeside, 0U);
    EXPECT_EQ(proof.triangles, result.mesh.triangles.size());
}

} // namespace
} // namespace tessera
