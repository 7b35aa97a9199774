cmake_minimum_required(VERSION 3.25)
# Writes build_info.hpp, the provenance that results state about the program. Runs at every build, so that the commit is
# current. The file is only touched if its content changes.
execute_process(COMMAND git -C ${SOURCE_DIR} describe --always --abbrev=12
                OUTPUT_VARIABLE COMMIT OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
# Result files and the tables made from them do not affect the programs: accepting one result must not mark the next one as
# modified ("-dirty").
execute_process(COMMAND git -C ${SOURCE_DIR} diff --quiet HEAD -- . ":(exclude)results/*.csv"
                        ":(exclude)results/*.json" ":(exclude)paper/tables"
                RESULT_VARIABLE changed ERROR_QUIET)
if(NOT COMMIT)
  set(COMMIT "unknown")
elseif(NOT changed EQUAL 0)
  string(APPEND COMMIT "-dirty")
endif()
configure_file(${SOURCE_DIR}/cmake/build_info.hpp.in ${OUTPUT} @ONLY)
