# The files that `cmake --install` installs: the front door, the rooms as libraries and headers, the catalogue,
# find_package(trivium) and a file for pkg-config. trivium::trivium is the front door; trivium::templates is all rooms.
include(CMakePackageConfigHelpers)
set(rooms base bodies constraints effects mechanism scenes formulations integrators simulation)
add_library(trivium_templates INTERFACE)
add_library(trivium::templates ALIAS trivium_templates)
set_target_properties(trivium_templates PROPERTIES EXPORT_NAME templates)
list(TRANSFORM rooms PREPEND trivium_ OUTPUT_VARIABLE libraries)
list(APPEND libraries trivium_command_line trivium_structured_solver trivium_scenes_in_other_scalars
     trivium_formulations_in_other_scalars)
target_link_libraries(trivium_templates INTERFACE ${libraries})
install(TARGETS trivium trivium_templates ${libraries} EXPORT triviumTargets)
install(FILES ${PROJECT_SOURCE_DIR}/trivium/trivium.hpp ${PROJECT_SOURCE_DIR}/trivium/scene.hpp
              ${PROJECT_SOURCE_DIR}/trivium/instant.hpp ${PROJECT_SOURCE_DIR}/trivium/solve.hpp
              ${PROJECT_SOURCE_DIR}/trivium/simulate.hpp ${PROJECT_SOURCE_DIR}/trivium/compare.hpp
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/trivium)
# trivium::harness contains the program lambda_invariance, for formulations of users
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
# order of static libraries: a library comes before those that it uses
set(of_rooms trivium_simulation trivium_integrators trivium_formulations_in_other_scalars trivium_structured_solver
             trivium_formulations trivium_scenes_in_other_scalars trivium_scenes trivium_bodies trivium_base)
list(TRANSFORM of_rooms PREPEND -l)
list(JOIN of_rooms " " libraries_of_rooms)
set(pkgconfig_dir ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
file(RELATIVE_PATH prefix_from_pkgconfig /prefix/${pkgconfig_dir} /prefix)
configure_file(${PROJECT_SOURCE_DIR}/cmake/trivium.pc.in ${CMAKE_BINARY_DIR}/trivium.pc @ONLY)
install(FILES ${CMAKE_BINARY_DIR}/trivium.pc DESTINATION ${pkgconfig_dir})
set(config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/trivium)
install(EXPORT triviumTargets NAMESPACE trivium:: DESTINATION ${config_dir})
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/triviumConfig.cmake.in ${CMAKE_BINARY_DIR}/triviumConfig.cmake
                              INSTALL_DESTINATION ${config_dir})
write_basic_package_version_file(${CMAKE_BINARY_DIR}/triviumConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/triviumConfig.cmake ${CMAKE_BINARY_DIR}/triviumConfigVersion.cmake
        DESTINATION ${config_dir})
