// SPDX-License-Identifier: MIT
#include "vtk/vtk_mesh.h"

#include "base/error.h"
#include "io/read_network.h"
#include "io/text_file.h"
#include "vtk/silence.h"

#include <fmt/format.h>

#include <vtkCellArray.h>
#include <vtkCellType.h>
#include <vtkDataArray.h>
#include <vtkErrorCode.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkUnstructuredGridReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <optional>

namespace tessera
{

namespace
{

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& what)
{
    throw Error(ErrorKind::Unreadable, fmt::format("{}: {}", path.string(), what));
}

enum class Use
{
    Taken,
    LeftOut,
    Refused,
};

/// What becomes of a cell type; points are left out.
Use kindOf(int type, CellKind& kind)
{
    switch (type) {
        case VTK_LINE:
            kind = CellKind::Edge2;
            return Use::Taken;
        case VTK_QUADRATIC_EDGE:
            kind = CellKind::Edge3;
            return Use::Taken;
        case VTK_TRIANGLE:
            kind = CellKind::Triangle3;
            return Use::Taken;
        case VTK_QUADRATIC_TRIANGLE:
            kind = CellKind::Triangle6;
            return Use::Taken;
        case VTK_QUAD:
            kind = CellKind::Quad4;
            return Use::Taken;
        case VTK_QUADRATIC_QUAD:
            kind = CellKind::Quad8;
            return Use::Taken;
        case VTK_EMPTY_CELL:
        case VTK_VERTEX:
        case VTK_POLY_VERTEX:
            return Use::LeftOut;
        default:
            return Use::Refused;
    }
}

/// Nothing of the file is believed: counts, offsets and node numbers are all checked.
RawMesh convert(vtkUnstructuredGrid& grid, const std::filesystem::path& path)
{
    RawMesh mesh;
    vtkPoints* points = grid.GetPoints();
    const vtkIdType nodeCount = points == nullptr ? 0 : points->GetNumberOfPoints();
    mesh.nodes.resize(static_cast<std::size_t>(nodeCount));
    for (vtkIdType i = 0; i < nodeCount; ++i) {
        points->GetPoint(i, mesh.nodes[static_cast<std::size_t>(i)].data());
        mesh.nodeNumber.push_back(i);
    }
    vtkCellArray* cells = grid.GetCells();
    if (cells == nullptr || cells->GetNumberOfCells() == 0) {
        return mesh;
    }
    vtkUnsignedCharArray* types = grid.GetCellTypesArray();
    if (types == nullptr || types->GetNumberOfValues() != cells->GetNumberOfCells()) {
        fail(path, "the numbers of cells and of cell types differ; the file is damaged.");
    }
    vtkDataArray* offsets = cells->GetOffsetsArray();
    vtkDataArray* connectivity = cells->GetConnectivityArray();
    const auto entry = [](vtkDataArray* array, vtkIdType i) {
        return static_cast<vtkIdType>(array->GetComponent(i, 0));
    };
    const vtkIdType entries = connectivity->GetNumberOfTuples();
    for (vtkIdType c = 0; c < cells->GetNumberOfCells(); ++c) {
        CellKind kind {};
        const Use use = kindOf(types->GetValue(c), kind);
        if (use == Use::Refused) {
            fail(path, fmt::format("cell {} has VTK type {}; a plane mesh has lines, triangles and "
                                   "quadrangles of order 1 or 2.",
                                   c, types->GetValue(c)));
        }
        if (use == Use::LeftOut) {
            continue;
        }
        const vtkIdType begin = entry(offsets, c);
        const vtkIdType end = entry(offsets, c + 1);
        if (begin < 0 || end > entries || end - begin != static_cast<vtkIdType>(nodesOf(kind))) {
            fail(path, fmt::format("cell {} has not as many nodes as its type; the file is "
                                   "damaged.",
                                   c));
        }
        mesh.cells.push_back({kind, static_cast<std::uint32_t>(mesh.cellNodes.size()), c});
        for (vtkIdType i = begin; i < end; ++i) {
            const vtkIdType node = entry(connectivity, i);
            if (node < 0 || node >= nodeCount) {
                fail(path, fmt::format("cell {} has a node {}; there are {} nodes, numbered from "
                                       "0.",
                                       c, node, nodeCount));
            }
            mesh.cellNodes.push_back(static_cast<std::uint32_t>(node));
        }
    }
    return mesh;
}

template<class Reader>
RawMesh runReader(Reader& reader, const std::filesystem::path& path)
{
    const VtkSilence silence;
    reader.SetFileName(path.c_str());
    reader.Update();
    if (reader.GetErrorCode() != vtkErrorCode::NoError || reader.GetOutput() == nullptr) {
        fail(path, "this is no complete file of a VTK unstructured grid.");
    }
    return convert(*reader.GetOutput(), path);
}

} // namespace

RawMesh readVtk(const std::filesystem::path& path)
{
    requireReadable(path);
    if (extensionOf(path) == ".vtk") {
        vtkNew<vtkUnstructuredGridReader> reader;
        return runReader(*reader, path);
    }
    vtkNew<vtkXMLUnstructuredGridReader> reader;
    return runReader(*reader, path);
}

} // namespace tessera
