# Functions that the CMakeLists.txt of the rooms share.

# Warnings are errors in the targets of the project, but not in those of its users. -Wrestrict is off: g++ 12 wrongly
# reports overlapping memcpy for plain string concatenation (GCC bug 105651).
add_library(trivium_options INTERFACE)
target_compile_options(trivium_options INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
                                                 $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict> -Werror)
# quadmath.h belongs to g++. clang++ searches g++'s folder after all others.
if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
  execute_process(COMMAND g++ -print-file-name=include OUTPUT_VARIABLE gcc_headers OUTPUT_STRIP_TRAILING_WHITESPACE
                  COMMAND_ERROR_IS_FATAL ANY)
  target_compile_options(trivium_options INTERFACE -idirafter ${gcc_headers})
endif()
# The preset with TRIVIUM_BUILD_BENCH compiles with -march=native. With this flag, g++ 12 wrongly warns about its AVX-512
# headers (GCC bug 105593) and about Eigen's loads.
if(TRIVIUM_BUILD_BENCH)
  target_compile_options(trivium_options INTERFACE -Wno-maybe-uninitialized -Wno-uninitialized -Wno-array-bounds)
endif()
if(TRIVIUM_SANITIZE)
  if(NOT CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    message(FATAL_ERROR "TRIVIUM_SANITIZE needs clang++, not ${CMAKE_CXX_COMPILER_ID}: use the preset asan")
  endif()
  # relative to the folder that the compiler runs in, because the compiler cache hashes this option as it stands
  cmake_path(RELATIVE_PATH CMAKE_CURRENT_LIST_DIR BASE_DIRECTORY ${CMAKE_BINARY_DIR} OUTPUT_VARIABLE from_build)
  target_compile_options(trivium_options INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=all
                                                   -fno-omit-frame-pointer
                                                   -fsanitize-ignorelist=${from_build}/sanitizers_ignored.txt)
  target_link_options(trivium_options INTERFACE -fsanitize=address,undefined)
endif()

# trivium_room(<room> [WITHOUT_EIGEN] USES <target>... SOURCES <source>...): the library trivium_<room> of the current
# folder and its dependencies. A room without sources is an INTERFACE library.
function(trivium_room room)
  cmake_parse_arguments(PARSE_ARGV 1 arg "WITHOUT_EIGEN" "" "USES;SOURCES")
  set(name trivium_${room})
  set(scope PUBLIC)
  if(arg_SOURCES)
    add_library(${name} STATIC ${arg_SOURCES})
    target_link_libraries(${name} PRIVATE $<BUILD_INTERFACE:trivium_options>)
    if(NOT arg_WITHOUT_EIGEN)
      trivium_precompile(${name} FROM trivium_library_headers)
    endif()
  else()
    add_library(${name} INTERFACE)
    set(scope INTERFACE)
  endif()
  add_library(trivium::${room} ALIAS ${name})
  set_target_properties(${name} PROPERTIES EXPORT_NAME ${room})
  target_compile_features(${name} ${scope} cxx_std_20)
  target_include_directories(${name} ${scope} $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
                                              $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/trivium>)
  target_link_libraries(${name} ${scope} ${arg_USES})
endfunction()

# All test executables with the label unit; the sanitizer build makes this target.
add_custom_target(unit_tests)

# trivium_test(<name> <label> [WITHOUT_EIGEN] USES <target>... SOURCES <source>... [DEFINES <definition>...]): a
# GoogleTest executable; each of its tests becomes a CTest test.
function(trivium_test name label)
  if(NOT TRIVIUM_BUILD_TESTS OR (TRIVIUM_SANITIZE AND NOT label STREQUAL "unit"))
    return()
  endif()
  cmake_parse_arguments(PARSE_ARGV 2 arg "WITHOUT_EIGEN" "" "USES;SOURCES;DEFINES")
  add_executable(${name} ${arg_SOURCES})
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/tests)
  target_link_libraries(${name} PRIVATE ${arg_USES} trivium_options GTest::gtest_main rapidcheck)
  target_compile_definitions(${name} PRIVATE ${arg_DEFINES})
  # Tests instantiate many templates and need not be fast: -O1 halves the compile time.
  target_compile_options(${name} PRIVATE $<$<CONFIG:Release>:-O1>)
  if(NOT arg_WITHOUT_EIGEN)
    trivium_precompile(${name} FROM trivium_test_headers)
  endif()
  if(label STREQUAL "unit")
    add_dependencies(unit_tests ${name})
  endif()
  # NO_PRETTY_VALUES: GoogleTest may print the parameter of a test as bytes, pointers among them. In a name of a test these
  # bytes would differ from run to run. If a name is misread as a filter pattern, no test runs; this must count as a failure.
  gtest_discover_tests(${name} PROPERTIES LABELS ${label} FAIL_REGULAR_EXPRESSION "Running 0 tests" DISCOVERY_TIMEOUT 60
                       TEST_PREFIX ${name}. NO_PRETTY_VALUES)
endfunction()

# trivium_count_allocations(<test>): counts the memory allocations of a test (base/testing/counted_allocations.hpp)
function(trivium_count_allocations name)
  if(NOT TARGET ${name})
    return()
  endif()
  target_sources(${name} PRIVATE ${PROJECT_SOURCE_DIR}/base/testing/counted_allocations.cpp)
  # with inlining, g++ takes the replaced operators new and delete for mismatched ones
  target_compile_options(${name} PRIVATE -Wno-mismatched-new-delete)
  target_link_options(${name} PRIVATE -Wl,--wrap=malloc,--wrap=aligned_alloc)
endfunction()

# trivium_skip(<why> <name>...): lists tests that this machine cannot run as skipped, with the reason
function(trivium_skip why)
  if(NOT TRIVIUM_BUILD_TESTS OR TRIVIUM_SANITIZE)
    return()
  endif()
  foreach(name IN LISTS ARGN)
    add_test(NAME ${name} COMMAND ${CMAKE_COMMAND} -E echo "skipped: ${why}")
    set_tests_properties(${name} PROPERTIES SKIP_REGULAR_EXPRESSION "skipped: ")
  endforeach()
endfunction()
