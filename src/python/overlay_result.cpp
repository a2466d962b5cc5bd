// SPDX-License-Identifier: MIT
#include "python/overlay_result.h"

#include "imprint/overlay.h"
#include "io/overlay_files.h"
#include "io/overlay_report.h"
#include "io/read_network.h"
#include "occt/overlay_faces.h"
#include "python/network_input.h"
#include "python/progress_bridge.h"
#include "vtk/overlay_file.h"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <memory>
#include <string>
#include <vector>

namespace py = pybind11;

namespace tessera::python
{
namespace
{

/// A finished overlay as Python holds it.
struct OverlayHolder
{
    OverlayResult result;
    BooleanOperation operation;
    PlaneFrame frame;
    std::string report; ///< JSON, as the command line writes it
};

std::shared_ptr<OverlayHolder> runOverlay(const NetworkInput& input, OverlayOptions options,
                                          Execution& execution, const py::object& progress)
{
    if (options.weld < 0.0) {
        options.weld = input.defaultWeld();
    }
    auto holder = std::make_shared<OverlayHolder>();
    holder->operation = options.operation;
    holder->frame = input.frame();
    CurveNetwork network = input.network();
    ProgressBridge bridge(progress, execution);
    try {
        const py::gil_scoped_release release;
        holder->result = overlayNetwork(std::move(network), options, execution);
        StageSeconds& seconds = holder->result.report.seconds;
        seconds.read = input.secondsToRead();
        seconds.total += seconds.read;
        holder->report = formatReport(holder->result, options.operation);
        bridge.tell(1.0, "done");
    }
    catch (const Error& error) {
        bridge.rethrow();
        input.raise(error);
    }
    bridge.rethrow();
    return holder;
}

/// The loop's corners as an (n, 2) array.
py::array_t<double> corners(const OverlayResult& result, std::span<const std::uint32_t> loop)
{
    py::array_t<double> array({static_cast<py::ssize_t>(loop.size()), py::ssize_t {2}});
    auto row = array.mutable_unchecked<2>();
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Vec2 p = result.point(loop[i]);
        row(static_cast<py::ssize_t>(i), 0) = p.x;
        row(static_cast<py::ssize_t>(i), 1) = p.y;
    }
    return array;
}

std::vector<std::uint32_t> numbersOf(const std::vector<CurveId>& curves)
{
    std::vector<std::uint32_t> numbers;
    for (const CurveId curve : curves) {
        numbers.push_back(curve.value);
    }
    return numbers;
}

/// (area, operands, [corners of each loop]) of a part.
py::tuple partOf(const OverlayHolder& holder, std::size_t part)
{
    const OverlayResult& result = holder.result;
    const BooleanPart& found = result.parts.parts.at(part);
    py::list operands;
    result.parts.sets.forEach(found.operands,
                              [&operands](OperandId operand) { operands.append(operand.value); });
    py::list loops;
    for (std::size_t i = 0; i < result.polygons.loopCount(part); ++i) {
        loops.append(corners(result, result.polygons.loop(part, i)));
    }
    return py::make_tuple(found.area, operands, loops);
}

/// By loop and edge of a part: the numbers of the curves that the edge lies on.
py::list curvesOf(const OverlayHolder& holder, std::size_t part)
{
    const OverlayResult& result = holder.result;
    py::list loops;
    for (std::size_t i = 0; i < result.polygons.loopCount(part); ++i) {
        const auto loop = result.polygons.loop(part, i);
        py::list edges;
        for (std::size_t k = 0; k < loop.size(); ++k) {
            edges.append(numbersOf(result.curvesOn(loop[k], loop[(k + 1) % loop.size()])));
        }
        loops.append(edges);
    }
    return loops;
}

void write(const OverlayHolder& holder, const std::string& path)
{
    const std::string extension = extensionOf(path);
    if (extension == ".brep" || extension == ".brp" || extension == ".step"
        || extension == ".stp") {
        writeFaces(holder.result, holder.frame, path);
        return;
    }
    writeOverlay(holder.result, holder.operation, path);
}

} // namespace

void defineOverlay(py::module_& module)
{
    py::enum_<BooleanOperation>(module, "BooleanOperation")
        .value("union", BooleanOperation::Union)
        .value("intersection", BooleanOperation::Intersection)
        .value("difference", BooleanOperation::Difference)
        .value("xor", BooleanOperation::SymmetricDifference)
        .value("cells", BooleanOperation::Cells);
    py::enum_<Priority>(module, "Priority")
        .value("none", Priority::None)
        .value("first", Priority::First)
        .value("last", Priority::Last);
    py::class_<OverlayOptions>(module, "OverlayOptions")
        .def(py::init<>())
        .def_readwrite("operation", &OverlayOptions::operation)
        .def_readwrite("priority", &OverlayOptions::priority)
        .def_readwrite("fill", &OverlayOptions::fill)
        .def_readwrite("weld", &OverlayOptions::weld)
        .def_readwrite("recovery", &OverlayOptions::recovery)
        .def_readwrite("chord_error", &OverlayOptions::chordError);
    py::class_<OverlayHolder, std::shared_ptr<OverlayHolder>>(module, "OverlayData")
        .def("__len__",
             [](const OverlayHolder& holder) { return holder.result.parts.parts.size(); })
        .def("part", &partOf, py::arg("index"))
        .def("curves", &curvesOf, py::arg("index"))
        .def("write", &write, py::arg("path"), py::call_guard<py::gil_scoped_release>())
        .def("brep",
             [](const OverlayHolder& holder) {
                 const py::gil_scoped_release release;
                 return brepOf(facesOf(holder.result, holder.frame));
             })
        .def_property_readonly("wkt",
                               [](const OverlayHolder& holder) {
                                   return formatWkt(holder.result, holder.operation);
                               })
        .def_property_readonly("matrix",
                               [](const OverlayHolder& holder) {
                                   const auto matrix = holder.frame.matrix();
                                   return py::array(py::dtype::of<double>(), {4, 4},
                                                    matrix.data());
                               })
        .def_readonly("report", &OverlayHolder::report);
    module.def("overlay", &runOverlay, py::arg("input"), py::arg("options"), py::arg("execution"),
               py::arg("progress"));
}

} // namespace tessera::python
