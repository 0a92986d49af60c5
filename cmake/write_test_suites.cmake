# Run as a script after a test program is built: writes OUTPUT, which tells CTest of each test suite of PROGRAM as
# NAME.<suite>, with LABELS.
#
# A suite is one process. gtest_discover_tests() makes one of each test, which starts the program, and makes what the
# suite's tests have in common, again and again.
#
# Suites of tests that are instantiated as Nightly have the label nightly: `./lab nightly` runs them, `./lab test` does
# not, and they may take two hours.
execute_process(COMMAND ${PROGRAM} --gtest_list_tests OUTPUT_VARIABLE listed COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "[^\n]+" lines "${listed}")
set(text "")
foreach(line IN LISTS lines)
  # "Suite." or "Suite/0.  # TypeParam = ..."; its tests are indented.
  if(line MATCHES "^DISABLED_" OR NOT line MATCHES "^([^ .]+)\\.( |$)")
    continue()
  endif()
  set(suite ${CMAKE_MATCH_1})
  string(APPEND text "add_test([=[${NAME}.${suite}]=] [=[${PROGRAM}]=] [=[--gtest_filter=${suite}.*]=])\n"
                     "set_tests_properties([=[${NAME}.${suite}]=] PROPERTIES TIMEOUT ${TIMEOUT} LABELS [=[${LABELS}]=])\n")
  if(suite MATCHES "^Nightly/")
    string(APPEND text "set_tests_properties([=[${NAME}.${suite}]=] PROPERTIES LABELS nightly TIMEOUT 7200)\n")
  endif()
endforeach()
file(WRITE ${OUTPUT} "${text}")
