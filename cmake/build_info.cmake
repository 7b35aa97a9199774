cmake_minimum_required(VERSION 3.25)
# Writes build_info.hpp: what results say about the program that made them. Run at every build, so that the commit is
# that of the sources; the file changes only when what it says does.
execute_process(COMMAND git -C ${SOURCE_DIR} describe --always --abbrev=12
                OUTPUT_VARIABLE COMMIT OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
# results/ and paper/ take no part in what the program is: accepting one result must not soil the next.
execute_process(COMMAND git -C ${SOURCE_DIR} diff --quiet HEAD -- . ":(exclude)results" ":(exclude)paper"
                RESULT_VARIABLE changed ERROR_QUIET)
if(NOT COMMIT)
  set(COMMIT "unknown")
elseif(NOT changed EQUAL 0)
  string(APPEND COMMIT "-dirty")
endif()
configure_file(${SOURCE_DIR}/cmake/build_info.hpp.in ${OUTPUT} @ONLY)
