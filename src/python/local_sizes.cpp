// SPDX-License-Identifier: MIT
#include "python/local_sizes.h"

#include "expression/expression_source.h"
#include "python/network_input.h"
#include "sizing/background_size.h"
#include "sizing/local_sizes.h"
#include "vtk/background_file.h"

#include <pybind11/stl.h>

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace py = pybind11;

namespace tessera::python
{
namespace
{

/// size, radius, far size, far radius.
using Law = std::array<double, 4>;

SizeLaw lawOf(const Law& law)
{
    return {law[0], law[1], law[2], law[3]};
}

/// nodes (n, 2), triangles (m, 3) and sizes (n); Python has checked the shapes.
AreaSource backgroundOf(const Coordinates& nodes, const Indices& triangles,
                        const Coordinates& sizes)
{
    BackgroundMesh mesh;
    mesh.name = "The mesh of size_from";
    mesh.sizes.assign(sizes.data(), sizes.data() + sizes.size());
    for (py::ssize_t i = 0; i + 1 < nodes.size(); i += 2) {
        mesh.nodes.push_back({nodes.data()[i], nodes.data()[i + 1]});
    }
    constexpr std::int64_t kMost = 0xffffffff;
    for (py::ssize_t i = 0; i + 2 < triangles.size(); i += 3) {
        auto& triangle = mesh.triangles.emplace_back();
        for (py::ssize_t k = 0; k < 3; ++k) {
            const std::int64_t node = triangles.data()[i + k];
            // What does not fit is no node of any mesh.
            triangle[static_cast<std::size_t>(k)] =
                static_cast<std::uint32_t>(node < 0 || node > kMost ? kMost : node);
        }
    }
    return backgroundSource(std::move(mesh));
}

} // namespace

void defineLocalSizes(py::module_& module)
{
    py::class_<LocalSizes>(module, "LocalSizes")
        .def(py::init<>())
        .def_readwrite("curvature", &LocalSizes::piecesPerTurn)
        .def_readwrite("chord_error", &LocalSizes::chordError)
        .def_readwrite("gap", &LocalSizes::gap)
        .def("add_point",
             [](LocalSizes& s, double x, double y, const Law& law) {
                 s.points.push_back({{x, y}, lawOf(law)});
             })
        .def("add_curves",
             [](LocalSizes& s, const std::vector<std::uint32_t>& curves, const Law& law) {
                 CurveSize size {{}, lawOf(law)};
                 for (const std::uint32_t curve : curves) {
                     size.curves.emplace_back(curve);
                 }
                 s.curves.push_back(std::move(size));
             })
        .def("add_operand",
             [](LocalSizes& s, std::uint32_t operand, double size) {
                 s.regions.push_back({OperandId(operand), {}, size});
             })
        .def("add_region",
             [](LocalSizes& s, double x, double y, double size) {
                 s.regions.push_back({{}, {x, y}, size});
             })
        .def("add_expression",
             [](LocalSizes& s, const std::string& expression) {
                 s.areas.push_back(expressionSource(expression));
             })
        .def("add_background",
             [](LocalSizes& s, const Coordinates& nodes, const Indices& triangles,
                const Coordinates& sizes) {
                 s.areas.push_back(backgroundOf(nodes, triangles, sizes));
             })
        .def("add_file", [](LocalSizes& s, const std::string& fileAndArray) {
            s.areas.push_back(backgroundSource(readBackground(fileAndArray)));
        });
}

} // namespace tessera::python
