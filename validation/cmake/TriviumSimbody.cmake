# simbody_reference, where Simbody is installed. Its headers are not C++20 and its clients must not define NDEBUG (the
# library is built without), so it stays behind a C++17 library of its own that shows no SimTK type.
find_package(Simbody 3.7 QUIET)
if(NOT Simbody_FOUND)
  message(STATUS "Simbody 3.7 was not found (Debian: libsimbody-dev): simbody_reference and its tests are left out")
  return()
endif()

add_library(trivium_simbody STATIC simbody_model.cpp simbody_tree.cpp simbody_effects.cpp simbody_custom_row.cpp
                                   simbody_built_in_rows.cpp)
set_target_properties(trivium_simbody PROPERTIES CXX_STANDARD 17 CXX_STANDARD_REQUIRED ON CXX_EXTENSIONS OFF)
target_compile_options(trivium_simbody PRIVATE -UNDEBUG)
target_include_directories(trivium_simbody PUBLIC ${PROJECT_SOURCE_DIR})
target_include_directories(trivium_simbody SYSTEM PRIVATE ${Simbody_INCLUDE_DIR})
target_link_libraries(trivium_simbody PRIVATE trivium_options SimTKsimbody)

add_library(trivium_simbody_comparison STATIC simbody_translation.cpp simbody_comparison.cpp
                                              simbody_massless_motion.cpp physical_twin.cpp)
target_link_libraries(trivium_simbody_comparison PUBLIC trivium trivium_simbody PRIVATE trivium_options)

add_executable(simbody_reference simbody_reference.cpp)
target_link_libraries(simbody_reference PRIVATE trivium_edge trivium_simbody_comparison trivium_options)
install(TARGETS simbody_reference RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})

# against a library that no sanitizer sees
trivium_test(simbody_test validation simbody_mapping_test.cpp simbody_joints_test.cpp simbody_massless_motion_test.cpp
             physical_twin_test.cpp)
if(TARGET simbody_test)
  target_link_libraries(simbody_test PRIVATE trivium_simbody_comparison)
endif()
if(TRIVIUM_BUILD_TESTS AND NOT TRIVIUM_SANITIZE)
  add_test(NAME simbody_reference.agrees_on_the_catalogue COMMAND simbody_reference)
  set_tests_properties(simbody_reference.agrees_on_the_catalogue PROPERTIES LABELS validation TIMEOUT 600)
  add_test(NAME simbody_reference.takes_the_time_as_trivium_does COMMAND simbody_reference heavy_top --t 1.5 --json)
  set_tests_properties(simbody_reference.takes_the_time_as_trivium_does
                       PROPERTIES LABELS validation PASS_REGULAR_EXPRESSION "\"t\": 1.5")
endif()
