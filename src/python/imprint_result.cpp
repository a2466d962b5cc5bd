// SPDX-License-Identifier: MIT
#include "python/imprint_result.h"

#include "imprint/imprint.h"
#include "io/append_network.h"
#include "io/imprint_report.h"
#include "io/overlay_files.h"
#include "io/read_network.h"
#include "occt/imprint_faces.h"
#include "occt/overlay_faces.h"
#include "occt/read_shape.h"
#include "python/network_input.h"
#include "python/progress_bridge.h"
#include "vtk/overlay_file.h"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace py = pybind11;

namespace tessera::python
{
namespace
{

bool isCadFile(const std::string& path)
{
    const std::string extension = extensionOf(path);
    return extension == ".brep" || extension == ".brp" || extension == ".step"
        || extension == ".stp";
}

/// Collects sources and targets, one item at a time: shapes in space, or networks in one plane.
class ImprintCollector
{
public:
    void addShape(const Shape& shape, ImprintSide side)
    {
        ImprintShape added {shapeFromBrep(shape.brep, shape.name), side};
        added.options.name = shape.name;
        added.options.looseEdges = shape.looseEdges;
        shapes_.push_back(std::move(added));
    }
    void addNetwork(const NetworkInput& network, ImprintSide side)
    {
        flat_.emplace_back(network.network(), side);
    }
    /// True: a CAD file.
    bool addFile(const std::string& path, ImprintSide side)
    {
        const std::string stem = std::filesystem::path(path).stem().string();
        if (!isCadFile(path)) {
            flat_.emplace_back(readNetwork(path), side);
            return false;
        }
        ImprintShape added {shapeFromFile(path), side};
        added.options.name = stem;
        shapes_.push_back(std::move(added));
        return true;
    }

    void project(const std::optional<Vec3>& direction)
    {
        if (!shapes_.empty()) {
            projectAll(direction);
            return;
        }
        if (direction) { // polygons in one plane lie where they lie, whatever it is
            try {
                unitDirection(*direction, input_.frame.z);
            }
            catch (const Error& error) {
                python::raise(error, {}, {});
            }
        }
        for (std::size_t i = 0; i < flat_.size(); ++i) {
            auto& [network, side] = flat_[i];
            const std::size_t count = network.operands.size();
            input_.side.insert(input_.side.end(), count, side);
            ImprintOrigin origin;
            origin.shape = i;
            input_.origins.insert(input_.origins.end(), count, origin);
            appendNetwork(input_.network, std::move(network));
        }
    }

    const ImprintInput& input() const { return input_; }

    /// Curves are told by the face that they belong to.
    [[noreturn]] void raise(const Error& error) const
    {
        std::vector<PlaceName> names;
        for (const ErrorPlace& place : error.places()) {
            PlaceName name;
            if (place.curve < input_.network.curves.size()) {
                const OperandId operand = input_.network.curves[place.curve].operand;
                const ImprintOrigin& origin = input_.origins[operand.index()];
                name.source = static_cast<std::int64_t>(origin.shape);
                name.element = origin.face == 0 ? "" : "Face" + std::to_string(origin.face);
            }
            names.push_back(std::move(name));
        }
        python::raise(error, names, input_.frame);
    }

private:
    void projectAll(const std::optional<Vec3>& direction)
    {
        try {
            const py::gil_scoped_release release;
            input_ = projectShapes(shapes_, direction);
        }
        catch (const CadError& error) {
            const std::vector<CadPlace> where =
                error.where().empty() ? std::vector<CadPlace>(1) : error.where();
            std::vector<PlaceName> names;
            for (const CadPlace& place : where) {
                PlaceName name;
                name.source = static_cast<std::int64_t>(error.shape());
                name.element = error.face() == 0 ? "" : "Face" + std::to_string(error.face());
                name.point = place.point;
                names.push_back(std::move(name));
            }
            python::raise(CadError(error.kind(), error.what(), where), names, {});
        }
        catch (const Error& error) {
            python::raise(error, {}, {});
        }
    }

    std::vector<ImprintShape> shapes_;
    std::vector<std::pair<CurveNetwork, ImprintSide>> flat_;
    ImprintInput input_;
};

/// A finished imprint as Python holds it.
struct ImprintHolder
{
    ImprintInput input;
    ImprintResult result;
    std::string report; ///< JSON, as the command line writes it
};

/// tolerance below 0: that of the shapes.
std::shared_ptr<ImprintHolder> runImprint(const ImprintCollector& collector,
                                          ImprintOptions options, Execution& execution,
                                          const py::object& progress)
{
    auto holder = std::make_shared<ImprintHolder>();
    holder->input = collector.input();
    options.weld = holder->input.defaultWeld;
    if (options.tolerance < 0.0) {
        options.tolerance = options.weld;
    }
    ProgressBridge bridge(progress, execution);
    try {
        const py::gil_scoped_release release;
        const ImprintInput& input = holder->input;
        holder->result = imprintNetwork(input.network, input.side, options, execution);
        holder->report = formatReport(
            holder->result, {input.side, [&](Vec2 p) { return input.frame.toSpace(p); }});
        bridge.tell(1.0, "done");
    }
    catch (const Error& error) {
        bridge.rethrow();
        collector.raise(error);
    }
    bridge.rethrow();
    return holder;
}

/// Corners of each loop of a cell, in the common plane.
py::list ringsOf(const ImprintHolder& holder, std::size_t cell)
{
    const OverlayResult& overlay = holder.result.overlay;
    py::list loops;
    for (std::size_t i = 0; i < overlay.polygons.loopCount(cell); ++i) {
        const auto loop = overlay.polygons.loop(cell, i);
        py::array_t<double> array({static_cast<py::ssize_t>(loop.size()), py::ssize_t {2}});
        auto row = array.mutable_unchecked<2>();
        for (std::size_t k = 0; k < loop.size(); ++k) {
            const Vec2 p = overlay.point(loop[k]);
            row(static_cast<py::ssize_t>(k), 0) = p.x;
            row(static_cast<py::ssize_t>(k), 1) = p.y;
        }
        loops.append(array);
    }
    return loops;
}

/// By operand: (is a target, number of its item among all, number of its face or 0).
std::vector<std::tuple<bool, std::size_t, std::uint32_t>> originsOf(const ImprintHolder& holder)
{
    std::vector<std::tuple<bool, std::size_t, std::uint32_t>> origins;
    for (std::size_t o = 0; o < holder.input.origins.size(); ++o) {
        const ImprintOrigin& origin = holder.input.origins[o];
        origins.emplace_back(holder.input.side[o] == ImprintSide::Target, origin.shape,
                             origin.face);
    }
    return origins;
}

void write(const ImprintHolder& holder, const std::string& path)
{
    if (isCadFile(path)) {
        writeImprint(holder.result, holder.input, path);
        return;
    }
    writeOverlay(holder.result.overlay, BooleanOperation::Cells, path);
}

} // namespace

void defineImprint(py::module_& module)
{
    py::enum_<ImprintSide>(module, "ImprintSide")
        .value("source", ImprintSide::Source)
        .value("target", ImprintSide::Target);
    py::class_<ImprintOptions>(module, "ImprintOptions")
        .def(py::init<>())
        .def_readwrite("tolerance", &ImprintOptions::tolerance)
        .def_readwrite("fill", &ImprintOptions::fill)
        .def_readwrite("recovery", &ImprintOptions::recovery)
        .def_readwrite("chord_error", &ImprintOptions::chordError);
    py::class_<ImprintCollector>(module, "ImprintInput")
        .def(py::init<>())
        .def("add_shape", &ImprintCollector::addShape, py::arg("shape"), py::arg("side"))
        .def("add_network", &ImprintCollector::addNetwork, py::arg("network"), py::arg("side"))
        .def("add_file", &ImprintCollector::addFile, py::arg("path"), py::arg("side"))
        .def("project", &ImprintCollector::project, py::arg("direction"));
    py::class_<ImprintHolder, std::shared_ptr<ImprintHolder>>(module, "ImprintData")
        .def("rings", &ringsOf, py::arg("cell"))
        .def("write", &write, py::arg("path"), py::call_guard<py::gil_scoped_release>())
        .def("brep",
             [](const ImprintHolder& holder) {
                 const py::gil_scoped_release release;
                 return brepOf(imprintedShape(holder.result, holder.input));
             })
        .def_property_readonly("origins", &originsOf)
        .def_property_readonly("wkt",
                               [](const ImprintHolder& holder) {
                                   return formatWkt(holder.result.overlay,
                                                    BooleanOperation::Cells);
                               })
        .def_property_readonly("matrix",
                               [](const ImprintHolder& holder) {
                                   const auto matrix = holder.input.frame.matrix();
                                   return py::array(py::dtype::of<double>(), {4, 4},
                                                    matrix.data());
                               })
        .def_readonly("report", &ImprintHolder::report);
    module.def("imprint", &runImprint, py::arg("input"), py::arg("options"), py::arg("execution"),
               py::arg("progress"));
}

} // namespace tessera::python
