# Run by the test Benchmark.FillDocument: generated blocks are replaced, words and other blocks stay.
file(REMOVE_RECURSE "${WORK_DIR}")
file(MAKE_DIRECTORY "${WORK_DIR}/pictures")
set(document "${WORK_DIR}/document.md")
file(WRITE "${document}" "Words before.\n<!-- generated: one -->\nold\n<!-- end: one -->\nWords between.\n"
  "<!-- generated: two -->\nkept\n<!-- end: two -->\nWords behind.\n")
file(WRITE "${WORK_DIR}/one.md" "| new |\n\n![plot](Images/plot.png)\n")
file(WRITE "${WORK_DIR}/pictures/plot.png" "a picture")
set(expected "Words before.\n<!-- generated: one -->\n\n| new |\n\n![plot](Images/plot.png)\n\n"
  "<!-- end: one -->\nWords between.\n<!-- generated: two -->\nkept\n<!-- end: two -->\nWords behind.\n")
string(CONCAT expected ${expected})

# Twice: what was generated before is no obstacle. The second block's file is missing, which is told.
foreach (time IN ITEMS first second)
  execute_process(
    COMMAND "${PYTHON}" "${SCRIPT}" "${document}"
      --block "one=${WORK_DIR}/one.md" --block "two=${WORK_DIR}/two.md" --images "${WORK_DIR}/pictures"
    RESULT_VARIABLE result
    ERROR_VARIABLE errors)
  file(READ "${document}" text)
  if (NOT text STREQUAL expected)
    message(FATAL_ERROR "the ${time} time:\n${text}\nis not\n${expected}")
  endif ()
  if (NOT result EQUAL 1 OR NOT errors MATCHES "two.md is missing")
    message(FATAL_ERROR "a missing file went unnoticed: ${result}, ${errors}")
  endif ()
endforeach ()
file(READ "${WORK_DIR}/Images/plot.png" picture)
if (NOT picture STREQUAL "a picture")
  message(FATAL_ERROR "the picture was not copied")
endif ()
