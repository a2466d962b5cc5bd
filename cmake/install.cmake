# SPDX-License-Identifier: MIT
# `cmake --install BUILD` puts the workbench into the user's FreeCAD; `--prefix DIR` elsewhere: DIR is
# the addon's folder, .../Mod/Tessera.
if(CMAKE_INSTALL_PREFIX_INITIALIZED_TO_DEFAULT)
  set(CMAKE_INSTALL_PREFIX "$ENV{HOME}/.local/share/FreeCAD/Mod/Tessera"
      CACHE PATH "Folder of the addon" FORCE)
endif()
install(FILES Init.py InitGui.py package.xml LICENSE README.md CHANGELOG.md DESTINATION .)
install(DIRECTORY workbench resources DESTINATION . PATTERN __pycache__ EXCLUDE
        PATTERN "*.so" EXCLUDE)
install(TARGETS _tessera LIBRARY DESTINATION workbench/tessera)
install(TARGETS tessera RUNTIME DESTINATION bin)
