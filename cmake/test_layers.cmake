cmake_minimum_required(VERSION 3.25)
# Copies the sources, adds to the lowest layer an include that the layers do not allow, in each of its spellings, and
# expects check_layers.cmake to fail on that line.
#   SOURCE_DIR   the sources          WORK   a folder to write in
function(check outcome what)
  execute_process(COMMAND ${CMAKE_COMMAND} -DSOURCE_DIR=${WORK} -P ${SOURCE_DIR}/cmake/check_layers.cmake
                  RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(outcome STREQUAL "holds" AND NOT result EQUAL 0)
    message(FATAL_ERROR "${what}: refused\n${output}")
  elseif(outcome STREQUAL "fails" AND (result EQUAL 0 OR NOT output MATCHES "bodies/rotations/so3.hpp (includes|has) "))
    message(FATAL_ERROR "${what}: exit code ${result}, and not for this line\n${output}")
  endif()
  message(STATUS "${what}: ${outcome}, as it should be")
endfunction()

file(REMOVE_RECURSE ${WORK})
foreach(layer IN ITEMS base bodies constraints effects mechanism scenes formulations integrators simulation results trivium
                       validation paper)
  file(COPY ${SOURCE_DIR}/${layer} DESTINATION ${WORK} FILES_MATCHING PATTERN "*.hpp" PATTERN "*.cpp")
endforeach()
file(READ ${WORK}/bodies/rotations/so3.hpp text)
check(holds "the sources as they are")
foreach(include IN ITEMS [[#include "formulations/r_p.hpp"]] [[#include <formulations/r_p.hpp>]]
                         [[# include "formulations/r_p.hpp"]] [[  #	include<formulations/r_p.hpp>]]
                         [[#include "../formulations/r_p.hpp"]] [[#include "bodies/../formulations/r_p.hpp"]]
                         [[#include "./so3.hpp"]] [[#include "/trivium/formulations/r_p.hpp"]] [[#include R_P_HEADER]])
  file(WRITE ${WORK}/bodies/rotations/so3.hpp "${text}${include}\n")
  check(fails "${include}")
endforeach()
file(WRITE ${WORK}/bodies/rotations/so3.hpp "${text}#include <vector>\n# include \"base/error.hpp\"\n")
check(holds "what the layers allow, in another spelling")
