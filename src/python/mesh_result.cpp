// SPDX-License-Identifier: MIT
#include "python/mesh_result.h"

#include <pybind11/stl.h>

#include <array>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace py = pybind11;

namespace tessera::python
{
namespace
{

static_assert(sizeof(Vec2) == 2 * sizeof(double) && std::is_standard_layout_v<Vec2>);

/// An (n, columns) array over memory that owner keeps alive; (n) if columns is 0.
template<class Scalar>
py::array view(const void* data, std::size_t rows, std::size_t columns, const py::object& owner)
{
    std::vector<py::ssize_t> shape {static_cast<py::ssize_t>(rows)};
    if (columns > 0) {
        shape.push_back(static_cast<py::ssize_t>(columns));
    }
    py::array result(py::dtype::of<Scalar>(), shape, static_cast<const Scalar*>(data), owner);
    result.attr("setflags")(py::arg("write") = false);
    return result;
}

template<std::size_t N>
py::array view(const std::vector<std::array<std::uint32_t, N>>& rows, const py::object& owner)
{
    return view<std::uint32_t>(rows.data(), rows.size(), N, owner);
}

py::array view(const std::vector<std::uint32_t>& values, const py::object& owner)
{
    return view<std::uint32_t>(values.data(), values.size(), 0, owner);
}

const Mesh& meshOf(const py::object& self)
{
    return self.cast<const MeshHolder&>().result.mesh;
}

const char* kindName(GroupKind kind)
{
    switch (kind) {
        case GroupKind::Triangles:
            return "triangles";
        case GroupKind::Edges:
            return "edges";
        case GroupKind::Nodes:
            return "nodes";
    }
    return "";
}

py::list groupsOf(const py::object& self)
{
    py::list groups;
    for (const Group& group : meshOf(self).groups) {
        groups.append(
            py::make_tuple(group.name, kindName(group.kind), view(group.members, self)));
    }
    return groups;
}

py::list regionsOf(const py::object& self)
{
    py::list regions;
    const MeshHolder& holder = self.cast<const MeshHolder&>();
    for (const Mesh::MeshRegion& region : holder.result.mesh.regions) {
        py::list operands;
        for (const OperandId operand : region.operands) {
            operands.append(operand.value);
        }
        regions.append(py::make_tuple(region.area, region.attribute, operands));
    }
    return regions;
}

py::list operandNames(const MeshHolder& holder)
{
    py::list names;
    for (const Operand& operand : holder.network.operands) {
        names.append(operand.name);
    }
    return names;
}

py::array frameMatrix(const MeshHolder& holder)
{
    const std::array<double, 16> matrix = holder.frame.matrix();
    return py::array(py::dtype::of<double>(), {4, 4}, matrix.data());
}

} // namespace

void defineMesh(py::module_& module)
{
    py::class_<MeshHolder, std::shared_ptr<MeshHolder>>(module, "MeshData")
        .def_property_readonly("nodes",
                               [](const py::object& self) {
                                   const auto& nodes = meshOf(self).nodes;
                                   return view<double>(nodes.data(), nodes.size(), 2, self);
                               })
        .def_property_readonly("node_origins",
                               [](const py::object& self) {
                                   const auto& origins = meshOf(self).nodeOrigin;
                                   return view<std::uint8_t>(origins.data(), origins.size(), 0,
                                                             self);
                               })
        .def_property_readonly("triangles",
                               [](const py::object& self) {
                                   return view(meshOf(self).triangles, self);
                               })
        .def_property_readonly("triangle_regions",
                               [](const py::object& self) {
                                   return view(meshOf(self).triangleRegion, self);
                               })
        .def_property_readonly("triangle_mid_nodes",
                               [](const py::object& self) {
                                   return view(meshOf(self).triangleMidNodes, self);
                               })
        .def_property_readonly("edges",
                               [](const py::object& self) {
                                   return view(meshOf(self).edges, self);
                               })
        .def_property_readonly("edge_mid_nodes",
                               [](const py::object& self) {
                                   return view(meshOf(self).edgeMidNodes, self);
                               })
        .def_property_readonly("groups", &groupsOf)
        .def_property_readonly("regions", &regionsOf)
        .def_property_readonly("operands", &operandNames)
        .def_property_readonly("matrix", &frameMatrix)
        .def_property_readonly("order",
                               [](const MeshHolder& holder) { return holder.result.mesh.order(); })
        .def_readonly("report", &MeshHolder::report);
}

} // namespace tessera::python
