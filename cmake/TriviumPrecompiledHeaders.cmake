# Precompiled headers of other projects: parsing them takes most of the time of a small translation unit. Headers of
# Trivium are not precompiled, so that a unit must still include each one that it uses. The library's units include the
# headers of other projects as well, because the preset bench compiles without precompiled headers.

set(trivium_common_headers <Eigen/Core> <Eigen/Eigenvalues> <Eigen/Geometry> <boost/multiprecision/float128.hpp>
                           <fmt/format.h> <fmt/ranges.h> <algorithm> <array> <cmath> <functional> <limits> <map> <memory>
                           <optional> <string> <string_view> <utility> <variant> <vector>)
set(empty ${CMAKE_BINARY_DIR}/generated/empty.cpp)
if(NOT EXISTS ${empty})
  file(WRITE ${empty} "")
endif()
# The compiler cache needs: from g++ a mark in the preprocessed text where a precompiled header is used; from clang++
# precompiled headers without time stamps.
if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
  set(trivium_cacheable_headers "SHELL:-Xclang -fno-pch-timestamp")
else()
  set(trivium_cacheable_headers -fpch-preprocess)
endif()

# trivium_precompiled_headers(<name> USES <target>... HEADERS <header>...): a set of precompiled headers for
# trivium_precompile.
function(trivium_precompiled_headers name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "USES;HEADERS")
  add_library(${name} STATIC ${empty})
  target_compile_features(${name} PRIVATE cxx_std_20)
  target_link_libraries(${name} PRIVATE trivium_options Eigen3::Eigen Boost::headers fmt::fmt ${arg_USES})
  target_compile_options(${name} PRIVATE ${trivium_cacheable_headers})
  target_precompile_headers(${name} PRIVATE ${trivium_common_headers} ${arg_HEADERS})
endfunction()

# trivium_precompile(<target>... FROM <name>): the targets use this set; they must use Eigen, Boost and fmt.
function(trivium_precompile)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "FROM" "")
  foreach(target IN LISTS arg_UNPARSED_ARGUMENTS)
    target_precompile_headers(${target} REUSE_FROM ${arg_FROM})
    target_compile_options(${target} PRIVATE ${trivium_cacheable_headers})
  endforeach()
endfunction()

trivium_precompiled_headers(trivium_library_headers)
if(TRIVIUM_BUILD_TESTS)
  trivium_precompiled_headers(trivium_test_headers USES GTest::gtest rapidcheck
                              HEADERS <boost/multiprecision/cpp_bin_float.hpp> <gtest/gtest.h> <rapidcheck.h>
                                      <rapidcheck/detail/TestListenerAdapter.h> <random> <set>)
  target_compile_options(trivium_test_headers PRIVATE $<$<CONFIG:Release>:-O1>)
endif()
