// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

namespace tessera::python
{

/// BooleanOperation, Priority, OverlayData and overlay(): one run with the GIL released.
void defineOverlay(pybind11::module_& module);

} // namespace tessera::python
