cmake_minimum_required(VERSION 3.25)
# Code with the library's flags must compile. With other flags it must not, and the message must name the flag.
include(${CMAKE_CURRENT_LIST_DIR}/TriviumCompiledWith.cmake)
file(REMOVE_RECURSE ${WORK})
file(WRITE ${WORK}/user.cpp "#include <bodies/numbers/batch.hpp>\n#include <bodies/numbers/register_vectors.hpp>\n")

# user_says(<variable> <flags of the library> <flags of the user>): the compiler's output for the user's code
function(user_says variable library user)
  trivium_compiled_with(${WORK}/bodies/numbers/compiled_with.hpp ${CXX} "${library}" ${EIGEN})
  separate_arguments(user UNIX_COMMAND "${user}")
  execute_process(COMMAND ${CXX} -std=c++20 -fsyntax-only -Wfatal-errors ${user} -I${SOURCE_DIR} -I${WORK} -I${EIGEN} ${WORK}/user.cpp
                  RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(result EQUAL 0)
    set(output "compiles")
  endif()
  set(${variable} "${output}" PARENT_SCOPE)
endfunction()
function(expect library user expected)
  user_says(said "${library}" "${user}")
  if(NOT said MATCHES "${expected}")
    message(FATAL_ERROR "library \"${library}\", user \"${user}\": expected \"${expected}\", got\n${said}")
  endif()
endfunction()

# `none`: the flags without the tested one
foreach(flag IN ITEMS -mavx -mavx512f -D_GLIBCXX_DEBUG -ffast-math)
  set(none "")
  if(flag STREQUAL "-mavx")
    set(none "-mno-avx")  # for compilers that enable AVX by default
  elseif(flag STREQUAL "-mavx512f")
    set(none "-mavx -mfma")  # Eigen needs both for AVX-512
  endif()
  set(set "${none} ${flag}")
  expect("${set}" "${set}" "^compiles$")
  expect("${none}" "${set}" "trivium was compiled without ${flag}[^\n]*, but this file is compiled with it")
  expect("${set}" "${none}" "trivium was compiled with ${flag}[^\n]*, but this file is compiled without it")
endforeach()
expect("-DEIGEN_MAX_ALIGN_BYTES=64" "" "trivium was compiled with EIGEN_MAX_ALIGN_BYTES = 64, but this file is compiled with another value")
expect("-DEIGEN_MAX_ALIGN_BYTES=64" "-DEIGEN_MAX_ALIGN_BYTES=64" "^compiles$")
# Users may choose flags that change neither types nor numbers.
expect("-O3 -DNDEBUG" "-O0 -g" "^compiles$")
