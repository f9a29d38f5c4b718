# Run by the test Install.Scenes; see CMakeLists.txt beside it for the variables.
set(first "${WORK_DIR}/first")
set(prefix "${WORK_DIR}/moved")
file(REMOVE_RECURSE "${WORK_DIR}")
file(MAKE_DIRECTORY "${WORK_DIR}/run")

function (run)
  execute_process(COMMAND ${ARGN}
    WORKING_DIRECTORY "${WORK_DIR}/run"
    RESULT_VARIABLE result
    OUTPUT_VARIABLE text
    ERROR_VARIABLE text)
  if (NOT result EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "failed (${result}): ${command}\n${text}")
  endif ()
  set(output "${text}" PARENT_SCOPE)
endfunction ()

run("${CMAKE_COMMAND}" --install "${BUILD_DIR}" --prefix "${first}" --component SoftShadowsScenes)
file(RENAME "${first}" "${prefix}")
file(COPY "${TOOL}" DESTINATION "${prefix}/${BINDIR}")
set(tool "${prefix}/${BINDIR}/softshadow")
set(scenes "${prefix}/${DATADIR}/SoftShadows/Scenes")

run("${tool}" benchmark --help)
string(FIND "${output}" "${scenes}" place)
if (place EQUAL -1)
  message(FATAL_ERROR "the tool does not look for scenes in ${scenes}:\n${output}")
endif ()
run("${tool}" benchmark --list)
foreach (name IN ITEMS assembly bunny dragon fence foliage fused lights molecule street terrain)
  if (NOT output MATCHES "(^|\n)${name}\n")
    message(FATAL_ERROR "no scene ${name}, or one that cannot be read:\n${output}")
  endif ()
endforeach ()
# Those with meshes that are installed find them.
foreach (name IN ITEMS bunny dragon)
  run("${tool}" reference "${scenes}/${name}.json" -o "${name}.exr"
    --samples 1 --width 16 --height 16)
endforeach ()
