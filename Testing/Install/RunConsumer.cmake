# Run by the tests Install.*; see CMakeLists.txt beside it for the variables.
set(prefix "${WORK_DIR}/prefix")
set(build "${WORK_DIR}/build")
set(output "${WORK_DIR}/output")

# Nothing of an earlier run may help this one.
file(REMOVE_RECURSE "${WORK_DIR}")
file(MAKE_DIRECTORY "${output}")

function (run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result)
  if (NOT result EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "failed (${result}): ${command}")
  endif ()
endfunction ()

run("${CMAKE_COMMAND}" --install "${BUILD_DIR}" --config "${CONFIG}" --prefix "${prefix}")
run("${CMAKE_COMMAND}" -S "${CONSUMER_DIR}" -B "${build}" -G "${GENERATOR}"
  "-DCMAKE_BUILD_TYPE=${CONFIG}"
  "-DCMAKE_CXX_COMPILER=${CXX_COMPILER}"
  "-DCMAKE_CXX_FLAGS=${CXX_FLAGS}"
  "-DCMAKE_PREFIX_PATH=${prefix}"
  "-DVTK_DIR=${VTK_DIR}")

# An installation elsewhere on the machine would make this test pass for nothing.
load_cache("${build}" READ_WITH_PREFIX consumer_ SoftShadows_DIR)
if (NOT consumer_SoftShadows_DIR STREQUAL "${prefix}/${PACKAGE_DIR}")
  message(FATAL_ERROR
    "found the package in ${consumer_SoftShadows_DIR}, not in ${prefix}/${PACKAGE_DIR}")
endif ()

run("${CMAKE_COMMAND}" --build "${build}" --config "${CONFIG}")
if (RUN_CTEST)
  run("${CMAKE_CTEST_COMMAND}" --test-dir "${build}" -C "${CONFIG}" --output-on-failure --no-tests=error)
  return ()
endif ()
find_program(program "${PROGRAM}" PATHS "${build}" "${build}/${CONFIG}" NO_DEFAULT_PATH REQUIRED)
run("${CMAKE_COMMAND}" -E chdir "${output}" "${program}" ${ARGUMENTS})
if (PICTURES)
  run("${CMAKE_COMMAND}" -E chdir "${output}" "${CHECK_PICTURE}" ${PICTURES})
endif ()
