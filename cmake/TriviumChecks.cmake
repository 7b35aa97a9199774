# Tests of the project as a whole: layers, headers, pages and format, and separate projects that use the
# installed package.
if(NOT TRIVIUM_BUILD_TESTS OR TRIVIUM_SANITIZE)
  return()
endif()
add_test(NAME layers.hold COMMAND ${CMAKE_COMMAND} -DSOURCE_DIR=${PROJECT_SOURCE_DIR}
                                  -P ${PROJECT_SOURCE_DIR}/cmake/check_layers.cmake)
add_test(NAME layers.violations_are_found
         COMMAND ${CMAKE_COMMAND} -DSOURCE_DIR=${PROJECT_SOURCE_DIR} -DWORK=${CMAKE_BINARY_DIR}/layers
                 -P ${PROJECT_SOURCE_DIR}/cmake/test_layers.cmake)
add_test(NAME headers.say_what_they_are_for COMMAND ${CMAKE_COMMAND} -DSOURCE_DIR=${PROJECT_SOURCE_DIR}
                                                    -P ${PROJECT_SOURCE_DIR}/cmake/check_headers.cmake)
add_test(NAME docs.name_what_exists COMMAND ${CMAKE_COMMAND} -DSOURCE_DIR=${PROJECT_SOURCE_DIR}
                                            -P ${PROJECT_SOURCE_DIR}/cmake/check_docs.cmake)
set(pages ${PROJECT_SOURCE_DIR}/README.md ${PROJECT_SOURCE_DIR}/CONTRIBUTING.md)
file(GLOB_RECURSE docs_pages CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/docs/*.md)
list(APPEND pages ${docs_pages})
add_test(NAME docs.are_spelt COMMAND ${PROJECT_SOURCE_DIR}/cmake/check_spelling.sh ${PROJECT_SOURCE_DIR} ${pages})
set_tests_properties(docs.are_spelt PROPERTIES SKIP_REGULAR_EXPRESSION "aspell is not installed")
add_test(NAME docs.figures_are_current COMMAND ${CMAKE_COMMAND} -DSOURCE_DIR=${PROJECT_SOURCE_DIR}
                                               -DWORK=${CMAKE_BINARY_DIR}/figures
                                               -P ${PROJECT_SOURCE_DIR}/cmake/check_figures.cmake)
set_tests_properties(docs.figures_are_current PROPERTIES SKIP_REGULAR_EXPRESSION "gnuplot is not installed")
add_test(NAME docs.render COMMAND ${PROJECT_SOURCE_DIR}/cmake/render_docs.sh ${CMAKE_BINARY_DIR}/html)
set_tests_properties(docs.render PROPERTIES SKIP_REGULAR_EXPRESSION "is not installed")
foreach(page IN LISTS pages)
  cmake_path(GET page STEM name)
  if(page MATCHES "/docs/README.md$")
    set(name docs)
  endif()
  add_test(NAME docs.${name}.shows_what_programs_print
           COMMAND ${PROJECT_SOURCE_DIR}/cmake/docs_pages.sh ${CMAKE_RUNTIME_OUTPUT_DIRECTORY} ${PROJECT_SOURCE_DIR}
                   ${CMAKE_BINARY_DIR}/docs ${page})
  set_tests_properties(docs.${name}.shows_what_programs_print PROPERTIES LABELS validation)
endforeach()
add_test(NAME docs.wrong_pages_are_found
         COMMAND ${CMAKE_COMMAND} -DBIN=${CMAKE_RUNTIME_OUTPUT_DIRECTORY} -DSOURCE_DIR=${PROJECT_SOURCE_DIR}
                 -DWORK=${CMAKE_BINARY_DIR}/docs_test -P ${PROJECT_SOURCE_DIR}/cmake/test_docs_pages.cmake)
set_tests_properties(docs.wrong_pages_are_found PROPERTIES LABELS validation)
add_test(NAME sources.are_formatted COMMAND ${CMAKE_COMMAND} -DSOURCE_DIR=${PROJECT_SOURCE_DIR}
                                            -P ${PROJECT_SOURCE_DIR}/cmake/check_format.cmake)
set_tests_properties(sources.are_formatted PROPERTIES SKIP_REGULAR_EXPRESSION "clang-format is not installed")
add_test(NAME package.serves_a_consumer
         COMMAND ${CMAKE_COMMAND} -DSOURCE_DIR=${PROJECT_SOURCE_DIR} -DBUILD_DIR=${CMAKE_BINARY_DIR}
                 -DWORK_DIR=${CMAKE_BINARY_DIR}/consumer -DCXX=${CMAKE_CXX_COMPILER} "-DROOMS=${rooms}"
                 -P ${PROJECT_SOURCE_DIR}/cmake/test_consumer.cmake)
add_test(NAME flags.that_change_types_do_not_compile
         COMMAND ${CMAKE_COMMAND} -DSOURCE_DIR=${PROJECT_SOURCE_DIR} -DWORK=${CMAKE_BINARY_DIR}/compiled_with
                 -DCXX=${CMAKE_CXX_COMPILER} -DEIGEN=${eigen_dir} -P ${PROJECT_SOURCE_DIR}/cmake/test_compiled_with.cmake)
set_tests_properties(layers.hold layers.violations_are_found headers.say_what_they_are_for docs.name_what_exists docs.are_spelt
                     docs.figures_are_current docs.render sources.are_formatted flags.that_change_types_do_not_compile PROPERTIES LABELS unit)
# it takes longest, so it starts first
set_tests_properties(package.serves_a_consumer PROPERTIES LABELS validation COST 200)
if(CCACHE)
  set_tests_properties(package.serves_a_consumer PROPERTIES ENVIRONMENT
    "CMAKE_CXX_COMPILER_LAUNCHER=${CCACHE};CCACHE_BASEDIR=${PROJECT_SOURCE_DIR}")
endif()
