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
# serves(<folder> <program> <scene>): the project of a folder builds, and its program is content with a scene
function(serves folder program scene)
  set(build ${WORK_DIR}/${program})
  step(${CMAKE_COMMAND} -S ${SOURCE_DIR}/${folder} -B ${build} -G Ninja -DCMAKE_PREFIX_PATH=${WORK_DIR}/prefix
       -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_COMPILER=${CXX})
  step(${CMAKE_COMMAND} --build ${build})
  step(${build}/${program} ${WORK_DIR}/prefix/share/trivium/scenes/${scene}.json)
endfunction()
serves(cmake/consumer consumer heavy_top)
serves(examples/rotation_vector rotation_vector_moves spatial_slider_crank)
serves(examples/directors directors_lambda spatial_slider_crank)
