# Functions for the Testing folders.
#
# softshadows_add_unit_tests(<module> <file>...)
#   GoogleTest program vtkRenderingSoftShadows<module>UnitTests, linked with the module under test,
#   its TEST_DEPENDS and the SoftShadowsTesting library. One CTest test per GoogleTest case, named
#   <module>.<suite>.<case>, label <module>. To be called below the module's Testing folder.
#
# softshadows_add_image_tests(<module> <file>[,option...]...)
#   VTK's own image tests: one function of the file's name per file, baseline
#   ../Data/Baseline/<file's name>.png. Options are those of vtk_add_test_cxx (NO_VALID, ...).
#   To be called below the module's Testing folder.
#
# softshadows_add_gtests(<target> LABEL <label> SOURCES <file>... [LIBRARIES <library>...])
#   The same as the first for folders that belong to no module. VTK modules among LIBRARIES are
#   initialised (vtk_module_autoinit).
#
# No list of files: nothing is added. Without GoogleTest or OpenImageIO (as in VTK's own build) the
# GoogleTest programs are left out.
#
# Programs see SOFTSHADOWS_BASELINE_DIR (the Data/Baseline folder beside the calling folder) and
# SOFTSHADOWS_TEST_OUTPUT_DIR (where pictures of failures go) as C strings. Tests are discovered
# when ctest starts, by running the program with --gtest_list_tests: nothing may open a display
# before main() has parsed its arguments.

# Sources' root, from this file's place: inside VTK's tree the project's own root has not run.
get_filename_component(_softshadows_source_dir "${CMAKE_CURRENT_LIST_DIR}/../.." ABSOLUTE)

#---------------------------------------------------------------------------------------------------
macro (_softshadows_find_test_packages)
  # Imported targets are visible only in the folder that found them.
  find_package(GTest QUIET)
  if (GTest_FOUND AND NOT TARGET OpenImageIO::OpenImageIO)
    find_package(OpenImageIO QUIET)
    include("${_softshadows_source_dir}/Utilities/CMake/SoftShadowsFixOpenImageIO.cmake")
  endif ()
  set(_softshadows_can_test OFF)
  if (TARGET GTest::gtest_main AND TARGET OpenImageIO::OpenImageIO)
    set(_softshadows_can_test ON)
  endif ()
endmacro ()

# Several test files become one source: most of the time of a test file goes into its headers. Each
# file keeps a namespace of its own; what all of them include comes first, outside of the namespaces.
# Files that are no tests (other files call them) stay as they are.
function (_softshadows_unite_tests target)
  set(includes "${CMAKE_CURRENT_BINARY_DIR}/${target}Includes.h")
  set(lines)
  get_target_property(sources "${target}" SOURCES)
  foreach (source IN LISTS sources)
    if (source MATCHES "(^|/)(Unit)?Test[^/]*\\.cxx$")
      file(STRINGS "${source}" found REGEX "^#include ")
      foreach (line IN LISTS found)
        # Headers of other versions of VTK are included where they are.
        string(REGEX REPLACE "^#include ([\"<][^\">]*[\">]).*" "\\1" header "${line}")
        list(APPEND lines "#if __has_include(${header})\n#include ${header}\n#endif")
      endforeach ()
      set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${source}")
    else ()
      set_source_files_properties("${source}" PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
    endif ()
  endforeach ()
  list(REMOVE_DUPLICATES lines)
  list(JOIN lines "\n" lines)
  # Fixtures in anonymous namespaces are right in a file that nobody else includes.
  string(CONCAT content
    "#pragma once\n"
    "#if defined(__GNUC__) && !defined(__clang__)\n"
    "#pragma GCC diagnostic ignored \"-Wsubobject-linkage\"\n"
    "#endif\n"
    "${lines}\n")
  file(CONFIGURE OUTPUT "${includes}" CONTENT "${content}" @ONLY)
  set_target_properties("${target}" PROPERTIES
    UNITY_BUILD ON
    UNITY_BUILD_BATCH_SIZE 6
    UNITY_BUILD_UNIQUE_ID SOFTSHADOWS_UNIT
    UNITY_BUILD_CODE_BEFORE_INCLUDE
      "#include \"${includes}\"\nnamespace SOFTSHADOWS_UNIT {\n// NOLINTNEXTLINE(bugprone-suspicious-include)"
    UNITY_BUILD_CODE_AFTER_INCLUDE "}")
  # Includes in quotes name files beside the tests.
  target_include_directories("${target}" PRIVATE "${CMAKE_CURRENT_SOURCE_DIR}")
endfunction ()

#---------------------------------------------------------------------------------------------------
function (_softshadows_finish_gtests target label)
  if (SOFTSHADOWS_UNITE_TESTS)
    _softshadows_unite_tests("${target}")
    # Compiling takes longer than what these would gain in running.
    target_compile_options("${target}" PRIVATE "$<$<CXX_COMPILER_ID:GNU,Clang>:-O1>")
  endif ()
  if (EXISTS "${_softshadows_source_dir}/Testing/Support/CMakeLists.txt")
    target_link_libraries("${target}" PRIVATE SoftShadowsTesting)
  endif ()
  target_link_libraries("${target}" PRIVATE GTest::gtest_main GTest::gmock OpenImageIO::OpenImageIO)
  get_filename_component(baselines "${CMAKE_CURRENT_SOURCE_DIR}/../Data/Baseline" ABSOLUTE)
  target_compile_definitions("${target}" PRIVATE
    "SOFTSHADOWS_BASELINE_DIR=\"${baselines}\""
    "SOFTSHADOWS_TEST_OUTPUT_DIR=\"${CMAKE_BINARY_DIR}/Testing/Temporary\"")
  include(GoogleTest)
  gtest_discover_tests("${target}"
    TEST_PREFIX     "${label}."
    DISCOVERY_MODE  PRE_TEST
    PROPERTIES      LABELS "${label}")
endfunction ()

#---------------------------------------------------------------------------------------------------
function (softshadows_add_unit_tests module)
  if (NOT ARGN)
    return ()
  endif ()
  _softshadows_find_test_packages()
  if (NOT _softshadows_can_test)
    return ()
  endif ()
  set(target "vtkRenderingSoftShadows${module}UnitTests")
  vtk_module_test_executable("${target}" ${ARGN})
  _softshadows_finish_gtests("${target}" "${module}")
endfunction ()

#---------------------------------------------------------------------------------------------------
function (softshadows_add_image_tests module)
  if (NOT ARGN)
    return ()
  endif ()
  set(target "vtkRenderingSoftShadows${module}CxxTests")
  vtk_add_test_cxx("${target}" tests NO_DATA ${ARGN})
  # Floating-point traps kill Mesa's software renderer in builds without NDEBUG.
  vtk_test_cxx_executable("${target}" tests RENDERING_FACTORY DISABLE_FLOATING_POINT_EXCEPTIONS)
endfunction ()

#---------------------------------------------------------------------------------------------------
function (softshadows_add_gtests target)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "LABEL" "SOURCES;LIBRARIES")
  if (NOT arg_SOURCES)
    return ()
  endif ()
  _softshadows_find_test_packages()
  if (NOT _softshadows_can_test)
    return ()
  endif ()
  add_executable("${target}" ${arg_SOURCES})
  target_link_libraries("${target}" PRIVATE ${arg_LIBRARIES})
  set(modules ${arg_LIBRARIES})
  list(FILTER modules INCLUDE REGEX "^VTK::")
  list(REMOVE_ITEM modules VTK::RenderingSoftShadows)
  if (modules)
    vtk_module_autoinit(TARGETS "${target}" MODULES ${modules})
  endif ()
  _softshadows_finish_gtests("${target}" "${arg_LABEL}")
endfunction ()
