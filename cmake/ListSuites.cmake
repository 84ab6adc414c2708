# cmake -D PROGRAM=... -D LABELS=... -D COST=... -D OUTPUT=... -P ListSuites.cmake: lists the suites of a
# gtest program and writes a CTest file with a test for each.
execute_process(COMMAND ${PROGRAM} --gtest_list_tests OUTPUT_VARIABLE listed COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "(^|\n)[^ \n]+\\." suites "${listed}")
set(text "")
foreach(suite ${suites})
    string(REGEX REPLACE "^\n|\\.$" "" suite "${suite}")
    string(APPEND text "add_test([[${suite}]] [[${PROGRAM}]] [[--gtest_filter=${suite}.*]])\n")
    string(APPEND text "set_tests_properties([[${suite}]] PROPERTIES LABELS \"${LABELS}\" COST ${COST})\n")
endforeach()
file(WRITE ${OUTPUT} "${text}")
