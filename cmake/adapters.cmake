# SPDX-License-Identifier: MIT
# Everything that touches foreign libraries: OpenCASCADE, VTK, muParser, the command line and
# Python.

find_package(OpenCASCADE CONFIG REQUIRED)
file(GLOB occt_sources CONFIGURE_DEPENDS src/occt/*.cpp)
if(occt_sources)
  add_library(tessera_occt STATIC ${occt_sources})
  target_include_directories(tessera_occt SYSTEM PUBLIC ${OpenCASCADE_INCLUDE_DIR})
  # OCCT 7.8 joined the STEP toolkits into one.
  if(TARGET TKDESTEP)
    set(step_toolkits TKDESTEP)
  else()
    set(step_toolkits TKSTEP TKSTEPBase TKSTEPAttr TKSTEP209)
  endif()
  target_link_libraries(tessera_occt PUBLIC tessera_io TKernel TKMath TKBRep TKG2d TKG3d
                        TKGeomBase TKGeomAlgo TKTopAlgo TKPrim TKXSBase ${step_toolkits})
endif()

# The filters check cells in the tests only.
find_package(VTK 9 REQUIRED COMPONENTS CommonCore CommonDataModel CommonMisc IOCore IOXML
             IOLegacy FiltersGeneral FiltersVerdict QUIET)
file(GLOB vtk_sources CONFIGURE_DEPENDS src/vtk/*.cpp)
if(vtk_sources)
  add_library(tessera_vtk STATIC ${vtk_sources})
  target_link_libraries(tessera_vtk PUBLIC tessera_io VTK::CommonCore VTK::CommonDataModel
                        VTK::CommonMisc VTK::IOCore VTK::IOXML VTK::IOLegacy)
endif()

find_path(MUPARSER_INCLUDE_DIR muParser.h REQUIRED)
find_library(MUPARSER_LIBRARY muparser REQUIRED)
file(GLOB expression_sources CONFIGURE_DEPENDS src/expression/*.cpp)
add_library(tessera_expression STATIC ${expression_sources})
target_include_directories(tessera_expression SYSTEM PRIVATE ${MUPARSER_INCLUDE_DIR})
target_link_libraries(tessera_expression PUBLIC tessera_core PRIVATE ${MUPARSER_LIBRARY})

find_package(CLI11 REQUIRED)
file(GLOB cli_sources CONFIGURE_DEPENDS src/cli/*.cpp)
if(cli_sources)
  add_executable(tessera ${cli_sources})
  target_link_libraries(tessera PRIVATE tessera_io tessera_occt tessera_vtk tessera_expression
                        CLI11::CLI11)
endif()

find_package(Python REQUIRED COMPONENTS Interpreter Development.Module)
find_package(pybind11 CONFIG REQUIRED)
file(GLOB python_sources CONFIGURE_DEPENDS src/python/*.cpp)
if(python_sources)
  pybind11_add_module(_tessera NO_EXTRAS ${python_sources})
  target_link_libraries(_tessera PRIVATE tessera_io tessera_occt tessera_vtk tessera_expression)
  # Beside its Python package, so that the source tree is usable as it is.
  set_target_properties(_tessera PROPERTIES
    LIBRARY_OUTPUT_DIRECTORY ${CMAKE_SOURCE_DIR}/workbench/tessera)
endif()
