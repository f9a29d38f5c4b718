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
# All that the package needs in the build tree.
add_custom_target(python-package)

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
  add_dependencies(python-package "${library}Python")
endforeach ()
set(softshadows_python_package
  "${CMAKE_BINARY_DIR}/${softshadows_python_destination}/vtksoftshadows")
configure_file(
  "${SoftShadows_SOURCE_DIR}/Utilities/Python/__init__.py.in"
  "${softshadows_python_package}/__init__.py" @ONLY)

# What is written in Python, in the build tree as it is installed. The table of techniques is the tool's.
set(softshadows_python_files)
foreach (name IN ITEMS _chain _lights _results _settings _techniques pyvista rendering)
  configure_file(
    "${SoftShadows_SOURCE_DIR}/Utilities/Python/${name}.py"
    "${softshadows_python_package}/${name}.py" COPYONLY)
  list(APPEND softshadows_python_files "${softshadows_python_package}/${name}.py")
endforeach ()
install(
  FILES
    "${softshadows_python_package}/__init__.py"
    "${softshadows_python_package}/_techniques.json"
    ${softshadows_python_files}
  DESTINATION  "${softshadows_python_destination}/vtksoftshadows"
  COMPONENT    python)

find_package(Python3 REQUIRED COMPONENTS Interpreter)

# Stubs, from which editors complete, made of what the wrapped modules tell of themselves.
execute_process(
  COMMAND          "${Python3_EXECUTABLE}" -c "import vtkmodules.generate_pyi"
  RESULT_VARIABLE  softshadows_no_stubs
  OUTPUT_QUIET ERROR_QUIET)
if (softshadows_no_stubs) # as VTK 9.1
  message(STATUS "No stubs for Python: vtkmodules has no generate_pyi.")
else ()
  set(softshadows_stubs)
  set(softshadows_stub_modules)
  set(softshadows_stub_targets)
  foreach (module IN LISTS softshadows_wrapped_modules)
    _vtk_module_get_module_property("${module}"
      PROPERTY  "library_name"
      VARIABLE  library)
    list(APPEND softshadows_stub_modules "${library}")
    list(APPEND softshadows_stub_targets "${library}Python")
    list(APPEND softshadows_stubs "${softshadows_python_package}/${library}.pyi")
  endforeach ()
  add_custom_command(
    OUTPUT   ${softshadows_stubs}
    COMMAND  "${CMAKE_COMMAND}" -E env
      "PYTHONPATH=${CMAKE_BINARY_DIR}/${softshadows_python_destination}"
      "${Python3_EXECUTABLE}" -m vtkmodules.generate_pyi
      -p vtksoftshadows -o "${softshadows_python_package}" ${softshadows_stub_modules}
    DEPENDS  ${softshadows_stub_targets}
    COMMENT  "Writing stubs for Python")
  add_custom_target(SoftShadowsPythonStubs ALL DEPENDS ${softshadows_stubs})
  add_dependencies(python-package SoftShadowsPythonStubs)
  install(
    FILES        ${softshadows_stubs}
    DESTINATION  "${softshadows_python_destination}/vtksoftshadows"
    COMPONENT    python)
endif ()

# What pip shows of a package.
set(softshadows_metadata
  "${softshadows_python_destination}/vtksoftshadows-${PROJECT_VERSION}.dist-info")
configure_file(
  "${SoftShadows_SOURCE_DIR}/Utilities/Python/METADATA.in"
  "${CMAKE_BINARY_DIR}/${softshadows_metadata}/METADATA" @ONLY)
file(WRITE "${CMAKE_BINARY_DIR}/${softshadows_metadata}/INSTALLER" "cmake\n")
install(
  DIRECTORY    "${CMAKE_BINARY_DIR}/${softshadows_metadata}"
  DESTINATION  "${softshadows_python_destination}"
  COMPONENT    python)
