cmake_minimum_required(VERSION 3.25)
# Every source must be formatted by .clang-format. The test is skipped, by its message, if clang-format is not
# installed.
find_program(CLANG_FORMAT NAMES clang-format clang-format-14)
if(NOT CLANG_FORMAT)
  message("clang-format is not installed")
  return()
endif()
file(GLOB_RECURSE sources ${SOURCE_DIR}/*.hpp ${SOURCE_DIR}/*.cpp)
list(FILTER sources EXCLUDE REGEX "^${SOURCE_DIR}/build/")
execute_process(COMMAND ${CLANG_FORMAT} --dry-run -Werror ${sources} RESULT_VARIABLE result ERROR_VARIABLE output)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "${output}")
endif()
