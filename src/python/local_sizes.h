// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

namespace tessera::python
{

/// LocalSizes: what asks for sizes in a run, added piece by piece.
void defineLocalSizes(pybind11::module_& module);

} // namespace tessera::python
