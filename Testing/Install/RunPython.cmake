# Run by the test Install.Python: installs the build into a folder of its own and runs the Python
# examples with the package that lies there; see CMakeLists.txt beside it for the variables.
set(prefix "${WORK_DIR}/prefix")
set(output "${WORK_DIR}/output")
file(REMOVE_RECURSE "${WORK_DIR}")
file(MAKE_DIRECTORY "${output}")
set(ENV{PYTHONPATH} "${prefix}/${PYTHON_DESTINATION}")

function (run)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY "${output}" RESULT_VARIABLE result)
  if (NOT result EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "failed (${result}): ${command}")
  endif ()
endfunction ()

run("${CMAKE_COMMAND}" --install "${BUILD_DIR}" --config "${CONFIG}" --prefix "${prefix}")

# A package elsewhere on the machine would make this test pass for nothing.
run("${PYTHON}" -c
  "import os, sys, vtksoftshadows as s; sys.exit(not os.path.samefile(os.path.dirname(s.__file__), '${prefix}/${PYTHON_DESTINATION}/vtksoftshadows'))")
# Its metadata is what pip shows.
run("${PYTHON}" -c
  "import importlib.metadata as m, sys, vtksoftshadows as s; sys.exit(m.version('vtksoftshadows') != s.__version__)")
run("${PYTHON}" "${EXAMPLES_DIR}/minimal.py" minimal.png)
run("${CHECK_PICTURE}" minimal.png)

execute_process(
  COMMAND            "${PYTHON}" "${EXAMPLES_DIR}/pyvista_style.py" pyvista.png
  WORKING_DIRECTORY  "${output}"
  RESULT_VARIABLE    result)
if (result EQUAL 0)
  run("${CHECK_PICTURE}" pyvista.png)
elseif (NOT result EQUAL 77) # without PyVista it says so
  message(FATAL_ERROR "pyvista_style.py failed (${result})")
endif ()
