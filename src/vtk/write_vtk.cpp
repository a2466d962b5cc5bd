// SPDX-License-Identifier: MIT
#include "vtk/vtk_mesh.h"

#include "base/error.h"
#include "io/atomic_file.h"
#include "io/read_network.h"
#include "vtk/error_listener.h"

#include <fmt/format.h>

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkErrorCode.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkTypeInt32Array.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkUnstructuredGridWriter.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <cerrno>
#include <cstring>

namespace tessera
{

namespace
{

template<class Array>
vtkSmartPointer<Array> makeArray(const char* name, std::size_t size)
{
    auto array = vtkSmartPointer<Array>::New();
    array->SetName(name);
    array->SetNumberOfValues(static_cast<vtkIdType>(size));
    return array;
}

vtkSmartPointer<vtkPoints> makePoints(const Mesh& mesh)
{
    vtkNew<vtkDoubleArray> coordinates;
    coordinates->SetNumberOfComponents(3);
    coordinates->SetNumberOfTuples(static_cast<vtkIdType>(mesh.nodes.size()));
    double* to = coordinates->GetPointer(0);
    for (Vec2 p : mesh.nodes) {
        *to++ = p.x;
        *to++ = p.y;
        *to++ = 0.0;
    }
    auto points = vtkSmartPointer<vtkPoints>::New();
    points->SetDataTypeToDouble();
    points->SetData(coordinates);
    return points;
}

/// Triangles, then edges.
void setCells(vtkUnstructuredGrid& grid, const Mesh& mesh)
{
    const bool second = mesh.order() == 2;
    const std::size_t perTriangle = second ? 6 : 3;
    const std::size_t perEdge = second ? 3 : 2;
    const std::size_t triangles = mesh.triangles.size();
    const std::size_t count = triangles + mesh.edges.size();
    auto offsets = makeArray<vtkTypeInt32Array>("offsets", count + 1);
    auto nodes = makeArray<vtkTypeInt32Array>("connectivity", triangles * perTriangle +
                                                                  mesh.edges.size() * perEdge);
    auto types = makeArray<vtkUnsignedCharArray>("types", count);
    vtkTypeInt32* offset = offsets->GetPointer(0);
    vtkTypeInt32* node = nodes->GetPointer(0);
    const vtkTypeInt32* first = node;
    const auto put = [&node](std::uint32_t n) { *node++ = static_cast<vtkTypeInt32>(n); };
    for (std::size_t t = 0; t < triangles; ++t) {
        *offset++ = static_cast<vtkTypeInt32>(node - first);
        for (std::uint32_t n : mesh.triangles[t]) {
            put(n);
        }
        for (std::size_t i = 0; second && i < 3; ++i) {
            put(mesh.triangleMidNodes[t][(i + 2) % 3]);
        }
    }
    for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
        *offset++ = static_cast<vtkTypeInt32>(node - first);
        put(mesh.edges[e][0]);
        put(mesh.edges[e][1]);
        if (second) {
            put(mesh.edgeMidNodes[e]);
        }
    }
    *offset = static_cast<vtkTypeInt32>(node - first);
    unsigned char* type = types->GetPointer(0);
    std::fill_n(type, triangles, second ? VTK_QUADRATIC_TRIANGLE : VTK_TRIANGLE);
    std::fill_n(type + triangles, mesh.edges.size(), second ? VTK_QUADRATIC_EDGE : VTK_LINE);
    vtkNew<vtkCellArray> cells;
    cells->SetData(offsets, nodes);
    grid.SetCells(types, cells);
}

void addCellData(vtkUnstructuredGrid& grid, const Mesh& mesh)
{
    const std::size_t triangles = mesh.triangles.size();
    const std::size_t count = triangles + mesh.edges.size();
    auto region = makeArray<vtkTypeInt32Array>("region", count);
    auto group = makeArray<vtkTypeInt32Array>("group", count);
    auto curve = makeArray<vtkTypeInt32Array>("curve", count);
    for (const auto& array : {region, group, curve}) {
        array->FillValue(-1);
    }
    for (std::size_t t = 0; t < triangles; ++t) {
        region->SetValue(static_cast<vtkIdType>(t), static_cast<int>(mesh.triangleRegion[t]));
    }
    for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
        const std::uint32_t first = mesh.edgeCurveStart[e];
        if (first < mesh.edgeCurveStart[e + 1]) {
            curve->SetValue(static_cast<vtkIdType>(triangles + e),
                            static_cast<int>(mesh.edgeCurves[first].value));
        }
    }
    for (std::size_t g = mesh.groups.size(); g-- > 0;) {
        if (mesh.groups[g].kind == GroupKind::Nodes) {
            continue;
        }
        const std::size_t base = mesh.groups[g].kind == GroupKind::Edges ? triangles : 0;
        for (std::uint32_t member : mesh.groups[g].members) {
            group->SetValue(static_cast<vtkIdType>(base + member), static_cast<int>(g));
        }
    }
    grid.GetCellData()->AddArray(region);
    grid.GetCellData()->AddArray(group);
    grid.GetCellData()->AddArray(curve);
}

void addGroupData(vtkUnstructuredGrid& grid, const Mesh& mesh)
{
    std::size_t total = 0;
    for (const Group& group : mesh.groups) {
        total += group.members.size();
    }
    vtkNew<vtkStringArray> names;
    names->SetName("group_names");
    auto kinds = makeArray<vtkTypeInt32Array>("group_kinds", mesh.groups.size());
    auto offsets = makeArray<vtkTypeInt32Array>("group_offsets", mesh.groups.size() + 1);
    auto members = makeArray<vtkTypeInt32Array>("group_members", total);
    vtkTypeInt32* to = members->GetPointer(0);
    const vtkTypeInt32* first = to;
    for (std::size_t g = 0; g < mesh.groups.size(); ++g) {
        const Group& group = mesh.groups[g];
        names->InsertNextValue(group.name);
        kinds->SetValue(static_cast<vtkIdType>(g), static_cast<int>(group.kind));
        offsets->SetValue(static_cast<vtkIdType>(g), static_cast<vtkTypeInt32>(to - first));
        const std::size_t base = group.kind == GroupKind::Edges ? mesh.triangles.size() : 0;
        for (std::uint32_t member : group.members) {
            *to++ = static_cast<vtkTypeInt32>(base + member);
        }
    }
    offsets->SetValue(static_cast<vtkIdType>(mesh.groups.size()),
                      static_cast<vtkTypeInt32>(to - first));
    grid.GetFieldData()->AddArray(names);
    grid.GetFieldData()->AddArray(kinds);
    grid.GetFieldData()->AddArray(offsets);
    grid.GetFieldData()->AddArray(members);
}

vtkSmartPointer<vtkUnstructuredGrid> makeGrid(const Mesh& mesh)
{
    auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
    grid->SetPoints(makePoints(mesh));
    setCells(*grid, mesh);
    addCellData(*grid, mesh);
    if (!mesh.groups.empty()) {
        addGroupData(*grid, mesh);
    }
    auto origin = makeArray<vtkUnsignedCharArray>("origin", mesh.nodes.size());
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
        origin->SetValue(static_cast<vtkIdType>(i), static_cast<unsigned char>(mesh.nodeOrigin[i]));
    }
    grid->GetPointData()->AddArray(origin);
    return grid;
}

/// Writes to file; path is what messages call it.
template<class Writer>
void runWriter(Writer& writer, vtkUnstructuredGrid& grid, const AtomicFile& file,
               const std::filesystem::path& path)
{
    vtkNew<ErrorListener> listener;
    for (vtkObject* source : {static_cast<vtkObject*>(&writer),
                              static_cast<vtkObject*>(writer.GetExecutive())}) {
        source->AddObserver(vtkCommand::ErrorEvent, listener);
        source->AddObserver(vtkCommand::WarningEvent, listener);
    }
    writer.SetFileName(file.temporary().c_str());
    writer.SetInputData(&grid);
    if (writer.Write() == 0 || writer.GetErrorCode() != vtkErrorCode::NoError
        || listener->failed()) {
        const unsigned long code = writer.GetErrorCode();
        throw Error(ErrorKind::Unwritable,
                    fmt::format("{}: cannot be written: {}.", path.string(),
                                code == vtkErrorCode::OutOfDiskSpaceError
                                    ? std::strerror(ENOSPC)
                                    : vtkErrorCode::GetStringFromErrorCode(code)));
    }
}

} // namespace

void writeVtk(const Mesh& mesh, const std::filesystem::path& path)
{
    AtomicFile file(path);
    const auto grid = makeGrid(mesh);
    if (extensionOf(path) == ".vtk") {
        vtkNew<vtkUnstructuredGridWriter> writer;
        writer->SetFileTypeToBinary();
        runWriter(*writer, *grid, file, path);
    }
    else {
        vtkNew<vtkXMLUnstructuredGridWriter> writer;
        writer->SetDataModeToAppended();
        writer->EncodeAppendedDataOff();
        writer->SetCompressorTypeToNone();
        writer->SetHeaderTypeToUInt64();
        runWriter(*writer, *grid, file, path);
    }
    file.commit();
}

} // namespace tessera
