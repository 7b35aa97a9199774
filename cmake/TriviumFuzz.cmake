# Fuzz targets, built by clang++ whatever compiler builds the rest: libFuzzer and the sanitizers come with it.

option(TRIVIUM_FUZZ "Build the fuzz targets with everything else; needs clang++" OFF)
set(TRIVIUM_FUZZ_SECONDS 60 CACHE STRING "How long the stress test lets a fuzzer run")
find_program(TRIVIUM_FUZZ_COMPILER NAMES clang++ clang++-14 clang++-15 clang++-16 clang++-17)
if(TRIVIUM_FUZZ AND NOT TRIVIUM_FUZZ_COMPILER)
  message(FATAL_ERROR "TRIVIUM_FUZZ needs clang++ and its libFuzzer")
endif()

# trivium_fuzz(<name> <source>...): the target <name>, and a test of the label stress that builds and runs it on the
# scenes of the current folder; skipped where there is no clang++.
function(trivium_fuzz name)
  set(fuzzer ${CMAKE_BINARY_DIR}/tests/${name})
  add_test(NAME ${name} COMMAND sh ${PROJECT_SOURCE_DIR}/cmake/run_fuzz.sh ${fuzzer} ${CMAKE_CURRENT_SOURCE_DIR}
                                ${CMAKE_CURRENT_BINARY_DIR}/${name} ${TRIVIUM_FUZZ_SECONDS})
  math(EXPR timeout "${TRIVIUM_FUZZ_SECONDS} + 120")
  set_tests_properties(${name} PROPERTIES LABELS stress SKIP_RETURN_CODE 77 TIMEOUT ${timeout})
  if(NOT TRIVIUM_FUZZ_COMPILER)
    return()
  endif()

  list(TRANSFORM ARGN PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/ OUTPUT_VARIABLE sources)
  file(GLOB_RECURSE headers CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/base/*.hpp ${PROJECT_SOURCE_DIR}/bodies/*.hpp
       ${PROJECT_SOURCE_DIR}/constraints/*.hpp ${CMAKE_CURRENT_SOURCE_DIR}/*.hpp)
  set(objects)
  foreach(source IN LISTS sources)
    cmake_path(GET source STEM stem)
    set(object ${CMAKE_CURRENT_BINARY_DIR}/${name}_${stem}.o)
    add_custom_command(OUTPUT ${object}
      COMMAND ${CMAKE_CXX_COMPILER_LAUNCHER} ${TRIVIUM_FUZZ_COMPILER} -std=c++20 -O1 -g -DFMT_HEADER_ONLY
              -fsanitize=fuzzer,address,undefined -fno-sanitize-recover=all -I ${PROJECT_SOURCE_DIR}
              "-I$<JOIN:$<TARGET_PROPERTY:Eigen3::Eigen,INTERFACE_INCLUDE_DIRECTORIES>,;-I>"
              -c ${source} -o ${object}
      DEPENDS ${source} ${headers}
      COMMENT "Building ${object} for fuzzing" COMMAND_EXPAND_LISTS VERBATIM)
    list(APPEND objects ${object})
  endforeach()
  add_custom_command(OUTPUT ${fuzzer}
    COMMAND ${CMAKE_COMMAND} -E make_directory ${CMAKE_BINARY_DIR}/tests
    COMMAND ${TRIVIUM_FUZZ_COMPILER} -fsanitize=fuzzer,address,undefined ${objects} -o ${fuzzer}
    DEPENDS ${objects} COMMENT "Linking ${fuzzer}" VERBATIM)
  if(TRIVIUM_FUZZ)
    add_custom_target(${name} ALL DEPENDS ${fuzzer})
  else()
    add_custom_target(${name} DEPENDS ${fuzzer})
  endif()

  add_test(NAME ${name}.build COMMAND ${CMAKE_COMMAND} --build ${CMAKE_BINARY_DIR} --target ${name})
  set_tests_properties(${name}.build PROPERTIES LABELS stress FIXTURES_SETUP ${name} TIMEOUT 600)
  set_tests_properties(${name} PROPERTIES FIXTURES_REQUIRED ${name})
endfunction()
