# Run as a script after a test program is built: writes OUTPUT, which tells CTest of the test suites of PROGRAM, with
# LABELS.
#
# A suite is one process, NAME.<suite>; with BY_FILE, the suites of a source file are, NAME.<file>: <suite> <suite> ...
# gtest_discover_tests() makes one of each test, which starts the program, loads its libraries, and makes what the tests
# have in common, again and again.
#
# Suites of tests that are instantiated as Nightly have the label nightly: `./lab nightly` runs them, `./lab test` does
# not, and they may take two hours. They are processes of their own.
execute_process(COMMAND ${PROGRAM} --gtest_list_tests --gtest_output=json:${OUTPUT}.json
                OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
file(READ ${OUTPUT}.json listed)
file(REMOVE ${OUTPUT}.json)
string(REPLACE "\\/" "/" listed "${listed}")
# A suite's name stands six columns from the left, before the files of its tests.
string(REGEX MATCHALL "\n      \"name\": \"[^\"]+\"|\"file\": \"[^\"]+\"" lines "${listed}")
set(files "")
set(suite "")
foreach(line IN LISTS lines)
  string(REGEX REPLACE "^.*\": \"(.*)\"$" "\\1" value "${line}")
  if(NOT line MATCHES "^\"file\"")
    set(suite ${value})
  elseif(suite AND NOT suite MATCHES "^DISABLED_") # its first test
    string(REGEX REPLACE "^.*/|(_test)?\\.[a-z]+$" "" file ${value})
    if(suite MATCHES "^Nightly/")
      string(APPEND file "_nightly")
    endif()
    if(NOT BY_FILE)
      set(file ${suite})
    endif()
    list(APPEND files ${file})
    list(APPEND suites_of_${file} ${suite})
    set(suite "")
  endif()
endforeach()
if(NOT files)
  message(FATAL_ERROR "${PROGRAM}: no test suites found")
endif()
list(REMOVE_DUPLICATES files)
set(text "")
foreach(file IN LISTS files)
  list(JOIN suites_of_${file} " " suites)
  list(TRANSFORM suites_of_${file} APPEND ".*" OUTPUT_VARIABLE filters)
  list(JOIN filters ":" filter)
  set(test "[=[${NAME}.${suites}]=]")
  if(BY_FILE)
    set(test "[=[${NAME}.${file}: ${suites}]=]")
  endif()
  string(APPEND text "add_test(${test} [=[${PROGRAM}]=] [=[--gtest_filter=${filter}]=])\n"
                     "set_tests_properties(${test} PROPERTIES TIMEOUT ${TIMEOUT} LABELS [=[${LABELS}]=])\n")
  if(file MATCHES "_nightly$|^Nightly/")
    string(APPEND text "set_tests_properties(${test} PROPERTIES LABELS nightly TIMEOUT 7200)\n")
  endif()
endforeach()
file(WRITE ${OUTPUT} "${text}")
