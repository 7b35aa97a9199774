# What `cmake --install` lays out: the rooms as libraries and headers, the catalogue and find_package(trivium).
# trivium::trivium is all of them.
include(CMakePackageConfigHelpers)
set(rooms base bodies constraints effects mechanism scenes formulations integrators simulation)
add_library(trivium INTERFACE)
add_library(trivium::trivium ALIAS trivium)
list(TRANSFORM rooms PREPEND trivium_ OUTPUT_VARIABLE libraries)
list(APPEND libraries trivium_command_line trivium_structured_solver trivium_scenes_in_other_scalars
     trivium_formulations_in_other_scalars)
target_link_libraries(trivium INTERFACE ${libraries})
install(TARGETS trivium ${libraries} EXPORT triviumTargets)
# trivium::harness is lambda_invariance for formulations from outside
install(TARGETS trivium_results trivium_harness EXPORT triviumTargets)
install(FILES ${PROJECT_SOURCE_DIR}/validation/harness/lambda_invariance.hpp
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/trivium/validation/harness)
foreach(room IN LISTS rooms)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${room} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/trivium FILES_MATCHING
          PATTERN "*.hpp" PATTERN "testing" EXCLUDE PATTERN "catalogue" EXCLUDE PATTERN "instances" EXCLUDE)
endforeach()
install(FILES ${compiled_with_dir}/bodies/numbers/compiled_with.hpp
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/trivium/bodies/numbers)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/scenes/catalogue/ DESTINATION ${CMAKE_INSTALL_DATADIR}/trivium/scenes
        FILES_MATCHING PATTERN "*.json")
install(FILES ${PROJECT_SOURCE_DIR}/scenes/format/scene.schema.json DESTINATION ${CMAKE_INSTALL_DATADIR}/trivium)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/validation/reference DESTINATION ${CMAKE_INSTALL_DATADIR}/trivium)
set(config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/trivium)
install(EXPORT triviumTargets NAMESPACE trivium:: DESTINATION ${config_dir})
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/triviumConfig.cmake.in ${CMAKE_BINARY_DIR}/triviumConfig.cmake
                              INSTALL_DESTINATION ${config_dir})
write_basic_package_version_file(${CMAKE_BINARY_DIR}/triviumConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/triviumConfig.cmake ${CMAKE_BINARY_DIR}/triviumConfigVersion.cmake
        DESTINATION ${config_dir})
