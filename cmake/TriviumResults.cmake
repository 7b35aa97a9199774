# results/ holds the accepted results. Tests make each file of schema.json again in the build tree and compare it with
# the accepted one. `cmake --build ... --target accept` (./run accept) makes all files, accepts them and writes the
# paper's tables. Files of timings are only made and accepted by `./run bench --accept` and `./run times`: no test
# repeats them.
set(schema ${PROJECT_SOURCE_DIR}/results/schema.json)
set(regenerated ${CMAKE_BINARY_DIR}/results/regenerated)
file(MAKE_DIRECTORY ${regenerated})
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${schema})
file(READ ${schema} schema_text)
set(accept_commands "")
set(accept_files "")
set(accept_programs accept_results paper_tables)
set(fixtures "")
set(missing "")

string(JSON count LENGTH "${schema_text}" files)
math(EXPR last "${count} - 1")
foreach(k RANGE ${last})
  string(JSON name MEMBER "${schema_text}" files ${k})
  string(JSON timings ERROR_VARIABLE no_timings GET "${schema_text}" files ${name} timings)
  if(timings STREQUAL "ON")
    continue()
  endif()
  string(JSON words LENGTH "${schema_text}" files ${name} command)
  math(EXPR last_word "${words} - 1")
  set(command "")
  foreach(w RANGE ${last_word})
    string(JSON word GET "${schema_text}" files ${name} command ${w})
    list(APPEND command ${word})
  endforeach()
  list(GET command 0 program)
  if(NOT TARGET ${program})
    list(APPEND missing ${program})
    trivium_skip("${program} needs a program or library that is not installed" results.${name}.regenerates)
    continue()
  endif()
  list(APPEND accept_programs ${program})
  list(APPEND command --csv ${regenerated}/${name}.csv)
  list(APPEND accept_commands COMMAND ${command})
  list(APPEND fixtures regenerated_${name})
  list(APPEND accept_files ${regenerated}/${name}.csv)

  if(TRIVIUM_BUILD_TESTS AND NOT TRIVIUM_SANITIZE)
    add_test(NAME results.${name}.regenerates COMMAND ${command})
    add_test(NAME results.${name}.is_as_accepted
             COMMAND compare_results ${PROJECT_SOURCE_DIR}/results/${name}.csv ${regenerated}/${name}.csv
                     --schema ${schema})
    set_tests_properties(results.${name}.regenerates PROPERTIES LABELS paper FIXTURES_SETUP regenerated_${name}
                         COST 100)  # the longest tests start first
    set_tests_properties(results.${name}.is_as_accepted PROPERTIES LABELS paper FIXTURES_REQUIRED regenerated_${name})
  endif()
endforeach()

# The exit code of motion_invariance also states whether every scene of the catalogue passed.
if(TEST results.motion_invariance.regenerates)
  set_tests_properties(results.motion_invariance.regenerates PROPERTIES LABELS "paper;validation")
endif()

# the programs that `accept` runs, for a separate build
add_custom_target(accept_programs)
add_dependencies(accept_programs ${accept_programs})
if(missing)
  add_custom_target(accept COMMAND ${CMAKE_COMMAND} -E echo "results of ${missing} cannot be made in this build"
                           COMMAND ${CMAKE_COMMAND} -E false VERBATIM)
else()
  add_custom_target(accept ${accept_commands}
                    COMMAND accept_results ${accept_files} --into ${PROJECT_SOURCE_DIR}/results
                    COMMAND paper_tables ${PROJECT_SOURCE_DIR}/results ${PROJECT_SOURCE_DIR}/paper/tables
                    VERBATIM USES_TERMINAL)
endif()

if(missing)
  trivium_skip("results of ${missing} cannot be made here" paper.tampering_is_found)
elseif(TRIVIUM_BUILD_TESTS AND NOT TRIVIUM_SANITIZE)
  add_test(NAME paper.tampering_is_found
           COMMAND ${CMAKE_COMMAND} -DCOMPARE=$<TARGET_FILE:compare_results> -DTABLES=$<TARGET_FILE:paper_tables>
                   -DRESULTS=${PROJECT_SOURCE_DIR}/results -DPAPER_TABLES=${PROJECT_SOURCE_DIR}/paper/tables
                   -DREGENERATED=${regenerated} -DWORK=${CMAKE_BINARY_DIR}/results/tampered
                   -P ${PROJECT_SOURCE_DIR}/cmake/test_tampering.cmake)
  set_tests_properties(paper.tampering_is_found PROPERTIES LABELS paper FIXTURES_REQUIRED "${fixtures}")
endif()
