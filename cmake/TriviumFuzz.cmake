# Fuzz targets. They are part of the build with sanitizers, because its compiler clang++ contains libFuzzer.

set(TRIVIUM_FUZZ_SECONDS 60 CACHE STRING "How long the stress test lets a fuzzer run")

# trivium_fuzz(<name> USES <target>... SOURCES <source>...): adds the fuzz target <name> and a test with the label
# stress, which runs it on the scenes of the current folder. The used targets are instrumented to report the branches
# taken.
function(trivium_fuzz name)
  if(NOT TRIVIUM_BUILD_TESTS OR NOT TRIVIUM_SANITIZE)
    return()
  endif()
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "USES;SOURCES")
  set(fuzzer ${CMAKE_BINARY_DIR}/tests/${name})
  add_executable(${name} ${arg_SOURCES})
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/tests)
  target_link_libraries(${name} PRIVATE ${arg_USES} trivium_options)
  # -O1 for more inputs per second; line numbers for the reports
  target_compile_options(${name} PRIVATE -O1 -gline-tables-only -fsanitize=fuzzer)
  target_link_options(${name} PRIVATE -fsanitize=fuzzer)
  foreach(target IN LISTS arg_USES)
    target_compile_options(${target} PRIVATE -O1 -gline-tables-only -fsanitize=fuzzer-no-link)
    # clang++ refuses headers that were precompiled without these options
    set_target_properties(${target} PROPERTIES DISABLE_PRECOMPILE_HEADERS ON)
  endforeach()
  add_dependencies(unit_tests ${name})

  add_test(NAME ${name} COMMAND sh ${PROJECT_SOURCE_DIR}/cmake/run_fuzz.sh ${fuzzer} ${CMAKE_CURRENT_SOURCE_DIR}
                                ${CMAKE_CURRENT_BINARY_DIR}/${name} ${TRIVIUM_FUZZ_SECONDS})
  math(EXPR timeout "${TRIVIUM_FUZZ_SECONDS} + 120")  # libFuzzer does not check the time limit while it runs the seeds
  # COST makes ctest start this test first, because it takes longest
  set_tests_properties(${name} PROPERTIES LABELS stress TIMEOUT ${timeout} COST ${TRIVIUM_FUZZ_SECONDS})
endfunction()
