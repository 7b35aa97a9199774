# trivium_compiled_with(<output> <compiler> <flags> <Eigen's folder>): writes bodies/numbers/compiled_with.hpp, which is
# installed. If user code is compiled with other flags than the library, and the flags change types of the library or
# the treatment of NaN and infinity, the compilation fails with a message that names the flag. Flags and what they
# change:
#   __AVX__, __AVX512F__   Register and native_lanes     EIGEN_MAX_ALIGN_BYTES   matrices of fixed size
#   _GLIBCXX_DEBUG         containers                    __FAST_MATH__           isfinite, and comparisons with NaN
#   EIGEN_MAX_STATIC_ALIGN_BYTES, -fpack-struct   layout of structs       EIGEN_DEFAULT_TO_ROW_MAJOR   matrices
function(trivium_compiled_with output compiler flags eigen)
  set(switches "__AVX__=-mavx or an -march that includes it" "__AVX512F__=-mavx512f or an -march that includes it"
               "_GLIBCXX_DEBUG=-D_GLIBCXX_DEBUG" "__FAST_MATH__=-ffast-math"
               "EIGEN_DEFAULT_TO_ROW_MAJOR=-DEIGEN_DEFAULT_TO_ROW_MAJOR")
  # Ask the preprocessor for the values with the library's flags.
  set(probe "#include <Eigen/Core>\ntrivium alignment EIGEN_MAX_ALIGN_BYTES EIGEN_MAX_STATIC_ALIGN_BYTES\n")
  foreach(switch IN LISTS switches)
    string(REGEX REPLACE "=.*" "" macro "${switch}")
    string(APPEND probe "#ifdef ${macro}\ntrivium has \"${macro}\"\n#endif\n")
  endforeach()
  file(WRITE ${output}.probe.cpp "${probe}")
  separate_arguments(flags UNIX_COMMAND "${flags}")
  execute_process(COMMAND ${compiler} -std=c++20 ${flags} -I${eigen} -E ${output}.probe.cpp OUTPUT_VARIABLE said
                  COMMAND_ERROR_IS_FATAL ANY)
  file(REMOVE ${output}.probe.cpp)
  if(NOT said MATCHES "trivium alignment ([0-9]+) ([0-9]+)")
    message(FATAL_ERROR "the compiler does not say EIGEN_MAX_ALIGN_BYTES and EIGEN_MAX_STATIC_ALIGN_BYTES")
  endif()
  set(alignment "${CMAKE_MATCH_1}")
  set(static_alignment "${CMAKE_MATCH_2}")

  set(remedy "compile this file with the same flags as trivium")
  set(checks "")
  foreach(switch IN LISTS switches)
    string(REGEX REPLACE "=.*" "" macro "${switch}")
    string(REGEX REPLACE "^[^=]*=" "" option "${switch}")
    set(wrong "ifdef")
    set(library "without")
    set(here "with")
    if(said MATCHES "trivium has \"${macro}\"")
      set(wrong "ifndef")
      set(library "with")
      set(here "without")
    endif()
    string(APPEND checks "#${wrong} ${macro}\n#error \"trivium was compiled ${library} ${option}, but this file is compiled "
                         "${here} it: ${remedy}\"\n#endif\n")
  endforeach()
  string(APPEND checks "static_assert(EIGEN_MAX_ALIGN_BYTES == ${alignment},\n              \"trivium was compiled with "
                       "EIGEN_MAX_ALIGN_BYTES = ${alignment}, but this file is compiled with another value: ${remedy}\");\n"
                       "static_assert(EIGEN_MAX_STATIC_ALIGN_BYTES == ${static_alignment},\n              \"trivium was compiled with "
                       "EIGEN_MAX_STATIC_ALIGN_BYTES = ${static_alignment}, but this file is compiled with another value: ${remedy}\");\n"
                       "#if __FINITE_MATH_ONLY__\n#ifndef __FAST_MATH__\n#error \"trivium needs NaN and infinity: "
                       "leave out -ffinite-math-only\"\n#endif\n#endif\n"
                       "namespace trivium::detail {\nstruct OfTwoAlignments {\n  char small;\n  double large;\n};\n"
                       "static_assert(sizeof(OfTwoAlignments) == 2 * sizeof(double), \"trivium was compiled without "
                       "-fpack-struct, but this file is compiled with it: ${remedy}\");\n}  // namespace trivium::detail")
  configure_file(${CMAKE_CURRENT_FUNCTION_LIST_DIR}/../bodies/numbers/compiled_with.hpp.in ${output} @ONLY)
endfunction()
