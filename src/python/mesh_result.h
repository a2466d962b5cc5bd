// SPDX-License-Identifier: MIT
#pragma once

#include "occt/plane_frame.h"
#include "pipeline.h"

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <string>

namespace tessera::python
{

/// A finished mesh as Python holds it; its arrays are views into it, read-only, without copies.
struct MeshHolder
{
    MeshResult result;
    CurveNetwork network; ///< names and markers, for writing
    PlaneFrame frame;
    std::string report; ///< JSON, as the command line writes it
};

void defineMesh(pybind11::module_& module);

} // namespace tessera::python
