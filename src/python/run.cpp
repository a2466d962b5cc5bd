// SPDX-License-Identifier: MIT
#include "python/run.h"

#include "base/execution.h"
#include "io/report_json.h"
#include "io/stage_pictures.h"
#include "io/system_memory.h"
#include "pipeline.h"
#include "python/mesh_result.h"
#include "python/network_input.h"
#include "python/progress_bridge.h"

#include <memory>
#include <string>

namespace py = pybind11;

namespace tessera::python
{
namespace
{

std::shared_ptr<MeshHolder> runMesh(const NetworkInput& input, MeshOptions options,
                                    Execution& execution, const py::object& progress,
                                    const std::string& stagesFolder)
{
    if (options.weld < 0.0) {
        options.weld = input.defaultWeld();
    }
    options.memoryLimit = static_cast<double>(availableMemoryBytes());
    auto holder = std::make_shared<MeshHolder>();
    holder->network = input.network();
    holder->frame = input.frame();
    ProgressBridge bridge(progress, execution);
    try {
        const py::gil_scoped_release release;
        std::unique_ptr<StagePictures> stages;
        if (!stagesFolder.empty()) {
            stages = std::make_unique<StagePictures>(stagesFolder);
        }
        holder->result = meshNetwork(holder->network, options, execution, stages.get());
        StageSeconds& seconds = holder->result.report.seconds;
        seconds.read = input.secondsToRead();
        seconds.total += seconds.read;
        holder->report = formatReport(holder->result);
        bridge.tell(1.0, "done");
        execution.checkpoint(); // the last call may still say no
    }
    catch (const Error& error) {
        bridge.rethrow();
        input.raise(error);
    }
    bridge.rethrow();
    return holder;
}

} // namespace

void defineRun(py::module_& module)
{
    py::class_<Execution, std::shared_ptr<Execution>>(
        module, "Execution",
        "Handle of one run. cancel() may be called from any thread and ends the run with a "
        "CancelledError.")
        .def(py::init<>())
        .def("cancel", &Execution::cancel)
        .def("set_threads", &Execution::setThreads, py::arg("count"))
        .def("set_time_limit", &Execution::setTimeLimit, py::arg("seconds"));

    py::class_<MeshOptions>(module, "MeshOptions")
        .def(py::init<>())
        .def_readwrite("size", &MeshOptions::size)
        .def_readwrite("count", &MeshOptions::count)
        .def_readwrite("min_size", &MeshOptions::minSize)
        .def_readwrite("growth", &MeshOptions::growth)
        .def_readwrite("min_angle", &MeshOptions::minAngle)
        .def_readwrite("max_area", &MeshOptions::maxArea)
        .def_readwrite("weld", &MeshOptions::weld)
        .def_readwrite("order", &MeshOptions::order)
        .def_readwrite("fill", &MeshOptions::fill)
        .def_readwrite("recovery", &MeshOptions::recovery)
        .def_readwrite("refine", &MeshOptions::refine)
        .def_readwrite("optimize", &MeshOptions::optimize)
        .def_readwrite("freeze_boundary", &MeshOptions::freezeBoundary)
        .def_readwrite("narrow_gaps", &MeshOptions::narrowShare)
        .def_readwrite("sizes", &MeshOptions::sizes);

    module.def("mesh", &runMesh, py::arg("input"), py::arg("options"), py::arg("execution"),
               py::arg("progress"), py::arg("stages"));
}

} // namespace tessera::python
