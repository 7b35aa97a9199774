cmake_minimum_required(VERSION 3.25)
# Runs a program and expects this exit code: a program that merely crashes proves nothing.
#   COMMAND   the program and its arguments     EXIT_CODE
execute_process(COMMAND ${COMMAND} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
if(NOT result EQUAL EXIT_CODE)
  message(FATAL_ERROR "exit code ${result} instead of ${EXIT_CODE}:\n${output}")
endif()
