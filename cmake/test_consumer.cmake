cmake_minimum_required(VERSION 3.25)
# Installs the build, looks at the headers that are then there, and configures, builds and runs projects of their own that
# find them: the walk of README, and the examples.
file(REMOVE_RECURSE ${WORK_DIR})
function(step)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${ARGN}\n${output}")
  endif()
endfunction()
step(${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${WORK_DIR}/prefix)
set(INCLUDE ${WORK_DIR}/prefix/include/trivium)
include(${SOURCE_DIR}/cmake/check_package.cmake)
# serves(<folder> <program> <scene>...): the project of a folder builds, and its program is content with the scenes
function(serves folder program)
  set(build ${WORK_DIR}/${program})
  step(${CMAKE_COMMAND} -S ${SOURCE_DIR}/${folder} -B ${build} -G Ninja -DCMAKE_PREFIX_PATH=${WORK_DIR}/prefix
       -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_COMPILER=${CXX})
  step(${CMAKE_COMMAND} --build ${build})
  list(TRANSFORM ARGN REPLACE "(.+)" "${WORK_DIR}/prefix/share/trivium/scenes/\\1.json")
  step(${build}/${program} ${ARGN})
endfunction()
# compiled for a processor that the library was not, a project does not build, and is told why
function(is_refused_with flag)
  set(build ${WORK_DIR}/refused)
  step(${CMAKE_COMMAND} -S ${SOURCE_DIR}/cmake/consumer -B ${build} -G Ninja -DCMAKE_PREFIX_PATH=${WORK_DIR}/prefix
       -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_COMPILER=${CXX} -DCMAKE_CXX_FLAGS=${flag})
  execute_process(COMMAND ${CMAKE_COMMAND} --build ${build} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(result EQUAL 0 OR NOT output MATCHES "trivium was compiled without ${flag}[^\n]*, this file with")
    message(FATAL_ERROR "a consumer with ${flag} is not refused by name\n${output}")
  endif()
endfunction()
file(READ ${INCLUDE}/bodies/numbers/compiled_with.hpp compiled_with)
if(compiled_with MATCHES "#ifdef __AVX__")  # a library for any processor
  is_refused_with(-mavx)
endif()
is_refused_with(-ffast-math)
serves(cmake/consumer consumer heavy_top)
serves(examples/rotation_vector rotation_vector_moves spatial_slider_crank)
serves(examples/directors directors_lambda spatial_slider_crank heavy_top stewart_platform four_bar flyball_governor
       triple_pendulum bricard)
serves(examples/own_method own_method_moves spatial_slider_crank)
serves(examples/own_types own_types_move spatial_slider_crank)
