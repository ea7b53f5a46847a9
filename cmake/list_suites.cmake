# Writes PROGRAM's GoogleTest suites as CTest tests, one process for each: a thousand quick tests take longer to start than to run.
execute_process(COMMAND "${PROGRAM}" --gtest_list_tests
  OUTPUT_VARIABLE listed RESULT_VARIABLE result WORKING_DIRECTORY "${FOLDER}")
if(NOT result EQUAL 0)
  message(FATAL_ERROR "${PROGRAM} does not list its tests: ${result}")
endif()
string(REGEX MATCHALL "(^|\n)[^ \n]+[.]( [^\n]*)?" lines "${listed}")
if(NOT lines)
  message(FATAL_ERROR "${PROGRAM} holds no tests")
endif()
set(tests "")
foreach(line IN LISTS lines)
  string(REGEX REPLACE "^\n?([^ ]+)[.].*" "\\1" suite "${line}")
  string(APPEND tests "add_test([=[${suite}]=] [=[${PROGRAM}]=] [=[--gtest_filter=${suite}.*]=])\n"
    "set_tests_properties([=[${suite}]=] PROPERTIES LABELS [=[${LABEL}]=] TIMEOUT ${TIMEOUT} "
    "WORKING_DIRECTORY [=[${FOLDER}]=])\n")
endforeach()
file(WRITE "${OUTPUT}" "${tests}")
