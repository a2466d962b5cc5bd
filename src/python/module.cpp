// SPDX-License-Identifier: MIT
// The native half of the Python package: what needs C++. Users import tessera, which checks their
// arguments and gives the results a Python face.
#include "curve/curve_network.h"
#include "python/imprint_result.h"
#include "python/local_sizes.h"
#include "python/mesh_result.h"
#include "python/network_input.h"
#include "python/overlay_result.h"
#include "python/python_error.h"
#include "python/run.h"
#include "recover/recover.h"
#include "vtk/mesh_file.h"

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <exception>
#include <string>

namespace py = pybind11;
using namespace tessera;
using namespace tessera::python;

namespace
{

void defineEnums(py::module_& module)
{
    py::enum_<Role>(module, "Role")
        .value("boundary", Role::Boundary)
        .value("constraint", Role::Constraint)
        .value("ignored", Role::Ignored);
    py::enum_<LooseEdges>(module, "LooseEdges")
        .value("by_chain", LooseEdges::ByChain)
        .value("boundary", LooseEdges::Boundary)
        .value("constraint", LooseEdges::Constraint)
        .value("ignored", LooseEdges::Ignored);
    py::enum_<FillRule>(module, "FillRule")
        .value("even_odd", FillRule::EvenOdd)
        .value("nonzero", FillRule::NonZero)
        .value("positive", FillRule::Positive)
        .value("negative", FillRule::Negative)
        .value("all", FillRule::All)
        .value("hull", FillRule::Hull);
    py::enum_<RecoveryStrategy>(module, "Recovery")
        .value("steiner", RecoveryStrategy::Steiner)
        .value("cavity", RecoveryStrategy::Cavity);
}

void defineInput(py::module_& module)
{
    py::class_<Shape>(module, "Shape")
        .def(py::init<>())
        .def_readwrite("brep", &Shape::brep)
        .def_readwrite("name", &Shape::name)
        .def_readwrite("edge_names", &Shape::edgeNames)
        .def_readwrite("vertex_names", &Shape::vertexNames)
        .def_readwrite("elements", &Shape::elements)
        .def_readwrite("roles", &Shape::roles)
        .def_readwrite("loose_edges", &Shape::looseEdges);
    py::class_<NetworkInput>(module, "NetworkInput")
        .def(py::init<>())
        .def("add_shapes", &NetworkInput::addShapes, py::arg("shapes"), py::arg("flat"))
        .def("add_segments", &NetworkInput::addSegments, py::arg("points"), py::arg("segments"),
             py::arg("markers"), py::arg("name"), py::arg("roles"))
        .def("add_polygon", &NetworkInput::addPolygon, py::arg("rings"), py::arg("name"),
             py::arg("role"))
        .def("join_operands", &NetworkInput::joinOperands)
        .def("curves_of", &NetworkInput::curvesOf, py::arg("source"), py::arg("number"))
        .def("operands_of", &NetworkInput::operandsOf, py::arg("source"))
        .def("to_plane", &NetworkInput::toPlane, py::arg("point"))
        .def_property_readonly("curve_count",
                               [](const NetworkInput& i) { return i.network().curves.size(); })
        .def_property_readonly("default_weld", &NetworkInput::defaultWeld);
}

void defineErrors(py::module_& module)
{
    // An exception that is raised here has no traceback.
    module.def(
        "raising",
        [](const py::function& function) {
            return py::cpp_function([function](const py::args& arguments) {
                py::object result = function(*arguments);
                if (PyExceptionInstance_Check(result.ptr())) {
                    PyErr_SetObject(PyExceptionInstance_Class(result.ptr()), result.ptr());
                    throw py::error_already_set();
                }
                return result;
            });
        },
        py::arg("function"));
}

void defineFiles(py::module_& module)
{
    module.def(
        "write",
        [](const MeshHolder& mesh, const std::string& path) {
            writeMesh(mesh.result.mesh, path, &mesh.network);
        },
        py::arg("mesh"), py::arg("path"), py::call_guard<py::gil_scoped_release>());
    // For readers that complain about each edge.
    module.def(
        "write_triangles",
        [](const MeshHolder& holder, const std::string& path) {
            Mesh mesh;
            mesh.nodes = holder.result.mesh.nodes;
            mesh.nodeOrigin = holder.result.mesh.nodeOrigin;
            mesh.triangles = holder.result.mesh.triangles;
            mesh.triangleRegion = holder.result.mesh.triangleRegion;
            mesh.triangleMidNodes = holder.result.mesh.triangleMidNodes;
            mesh.regions = holder.result.mesh.regions;
            mesh.edgeCurveStart = {0};
            writeMesh(mesh, path);
        },
        py::arg("mesh"), py::arg("path"), py::call_guard<py::gil_scoped_release>());
    module.def("mesh_extensions", &meshExtensions);
}

} // namespace

PYBIND11_MODULE(_tessera, module)
{
    module.attr("version") = TESSERA_VERSION;
    defineEnums(module);
    defineInput(module);
    defineMesh(module);
    defineLocalSizes(module);
    defineRun(module);
    defineErrors(module);
    defineOverlay(module);
    defineImprint(module);
    defineFiles(module);
    // Errors outside a run (writing a file): no names to give.
    py::register_exception_translator([](std::exception_ptr pointer) {
        try {
            std::rethrow_exception(pointer);
        }
        catch (const Error& error) {
            try {
                python::raise(error, {}, {});
            }
            catch (py::error_already_set& raised) {
                raised.restore();
            }
        }
    });
}
