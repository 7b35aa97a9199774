cmake_minimum_required(VERSION 3.25)
# Copies the sources, adds forbidden includes, and expects check_layers.cmake to fail on these lines: one include in
# each possible spelling, and one include for each important pair of rooms.
#   SOURCE_DIR   the sources          WORK   a folder to write in
function(check outcome file what)
  execute_process(COMMAND ${CMAKE_COMMAND} -DSOURCE_DIR=${WORK} -P ${SOURCE_DIR}/cmake/check_layers.cmake
                  RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(outcome STREQUAL "holds" AND NOT result EQUAL 0)
    message(FATAL_ERROR "${file}, ${what}: refused\n${output}")
  elseif(outcome STREQUAL "fails" AND (result EQUAL 0 OR NOT output MATCHES "${file} (includes|has) "))
    message(FATAL_ERROR "${file}, ${what}: exit code ${result}, and not for this line\n${output}")
  endif()
  message(STATUS "${file}, ${what}: ${outcome}, as it should be")
endfunction()

file(REMOVE_RECURSE ${WORK})
foreach(layer IN ITEMS base bodies constraints effects mechanism scenes formulations integrators simulation results trivium
                       validation paper)
  file(COPY ${SOURCE_DIR}/${layer} DESTINATION ${WORK} FILES_MATCHING PATTERN "*.hpp" PATTERN "*.cpp")
endforeach()
set(so3 bodies/rotations/so3.hpp)
file(READ ${WORK}/${so3} text)
check(holds ${so3} "the sources as they are")
foreach(include IN ITEMS [[#include "formulations/r_p.hpp"]] [[#include <formulations/r_p.hpp>]]
                         [[# include "formulations/r_p.hpp"]] [[  #	include<formulations/r_p.hpp>]]
                         [[#include "../formulations/r_p.hpp"]] [[#include "bodies/../formulations/r_p.hpp"]]
                         [[/**/ #include "formulations/r_p.hpp"]] [[#/* r-p */include "formulations/r_p.hpp"]]
                         [[#include "./so3.hpp"]] [[#include "/trivium/formulations/r_p.hpp"]] [[#include R_P_HEADER]]
                         [[/* a * b */ #include "formulations/r_p.hpp"]] [[#/***/include "formulations/r_p.hpp"]]
                         [[#import "formulations/r_p.hpp"]] [[%:include "formulations/r_p.hpp"]]
                         [[#include <formulations/r_p.hpp>  // a] b[ c]])
  file(WRITE ${WORK}/${so3} "${text}${include}\n")
  check(fails ${so3} "${include}")
endforeach()
foreach(lines IN ITEMS "#include <vector>  // a[\n#include \"formulations/r_p.hpp\"" "#inc\\\nlude \"formulations/r_p.hpp\""
                       "/* over\nlines */ #include \"formulations/r_p.hpp\"" "// half /*\n#include \"formulations/r_p.hpp\"\n// */")
  file(WRITE ${WORK}/${so3} "${text}${lines}\n")
  check(fails ${so3} "${lines}")
endforeach()
file(WRITE ${WORK}/${so3} "${text}#include <vector>\n# include \"base/error.hpp\"\n")
check(holds ${so3} "what the layers allow, in another spelling")

# plant(<outcome> <file> <include>): adds a file with one include
function(plant outcome file include)
  file(WRITE ${WORK}/${file} "#include \"${include}\"\n")
  check(${outcome} ${file} "${include}")
  file(REMOVE ${WORK}/${file})
endfunction()
plant(fails base/planted.hpp bodies/inertia.hpp)
plant(fails mechanism/planted.hpp scenes/scene.hpp)
plant(fails scenes/planted.hpp formulations/r_p.hpp)
plant(fails formulations/planted.hpp scenes/scene.hpp)
plant(fails formulations/structured/planted.cpp simulation/simulate.hpp)
plant(fails integrators/planted.hpp formulations/r_p.hpp)
plant(fails simulation/planted.cpp scenes/scene.hpp)
plant(fails trivium/command/planted.cpp results/tools/results_table.hpp)
plant(fails validation/planted.cpp trivium/command/commands.hpp)
plant(fails paper/generator/planted.cpp validation/harness/program.hpp)
plant(fails bodies/planted.hpp bodies/testing/properties.hpp)
plant(fails bodies/planted.hpp testing/properties.hpp)
plant(fails bodies/planted.h formulations/r_p.hpp)
plant(fails bodies/planted.ipp formulations/r_p.hpp)
plant(fails cmake/planted.hpp base/error.hpp)
# Tests and their helpers may also include scenes.
plant(holds formulations/planted_test.cpp scenes/make_mechanism.hpp)
plant(holds formulations/testing/planted.hpp scenes/scene.hpp)
plant(fails formulations/testing/planted.hpp simulation/simulate.hpp)
