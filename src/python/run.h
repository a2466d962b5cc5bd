// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

namespace tessera::python
{

/// Execution, MeshOptions and mesh(): one run with the GIL released.
void defineRun(pybind11::module_& module);

} // namespace tessera::python
