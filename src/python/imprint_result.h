// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

namespace tessera::python
{

/// ImprintSide, ImprintOptions, ImprintInput, ImprintData and imprint(): one run with the GIL
/// released.
void defineImprint(pybind11::module_& module);

} // namespace tessera::python
