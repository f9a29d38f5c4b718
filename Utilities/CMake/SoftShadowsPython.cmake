# The Python package vtksoftshadows: the modules wrapped by VTK's own wrapping. Include after
# vtk_module_build, in the folder that found the VTK components Python and WrappingPythonCore.
#
# Reads  softshadows_modules
# Sets   softshadows_python_destination, the folder of the package below the build and the prefix

if (NOT BUILD_SHARED_LIBS)
  message(FATAL_ERROR "SOFTSHADOWS_WRAP_PYTHON needs BUILD_SHARED_LIBS.")
endif ()
if (NOT TARGET VTK::WrapPython AND NOT TARGET VTKCompileTools::WrapPython)
  message(FATAL_ERROR
    "The VTK in ${VTK_DIR} has no Python wrapping (on Debian: package python3-vtk9).")
endif ()

vtk_module_python_default_destination(softshadows_python_destination)
vtk_module_wrap_python(
  MODULES             ${softshadows_modules}
  WRAPPED_MODULES     softshadows_wrapped_modules
  TARGET              VTK::SoftShadowsPython
  PYTHON_PACKAGE      vtksoftshadows
  MODULE_DESTINATION  "${softshadows_python_destination}"
  CMAKE_DESTINATION   "${softshadows_cmake_dir}"
  INSTALL_HEADERS     OFF
  INSTALL_EXPORT      ""
  BUILD_STATIC        OFF)

set(softshadows_python_imports)
foreach (module IN LISTS softshadows_wrapped_modules)
  _vtk_module_get_module_property("${module}"
    PROPERTY  "library_name"
    VARIABLE  library)
  string(APPEND softshadows_python_imports "from .${library} import *\n")
endforeach ()
set(softshadows_python_package
  "${CMAKE_BINARY_DIR}/${softshadows_python_destination}/vtksoftshadows")
configure_file(
  "${SoftShadows_SOURCE_DIR}/Utilities/Python/__init__.py.in"
  "${softshadows_python_package}/__init__.py" @ONLY)
install(
  FILES        "${softshadows_python_package}/__init__.py"
  DESTINATION  "${softshadows_python_destination}/vtksoftshadows"
  COMPONENT    python)
