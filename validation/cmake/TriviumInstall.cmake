# What `cmake --install` lays out: the library, its headers by folder, the catalogue and find_package(trivium).
include(CMakePackageConfigHelpers)
install(TARGETS trivium EXPORT triviumTargets)
foreach(layer IN ITEMS bodies constraints effects scenes formulations integrators)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${layer} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/trivium FILES_MATCHING
          PATTERN "*.hpp" PATTERN "malformed" EXCLUDE PATTERN "wellformed" EXCLUDE)
endforeach()
install(DIRECTORY ${PROJECT_SOURCE_DIR}/scenes DESTINATION ${CMAKE_INSTALL_DATADIR}/trivium FILES_MATCHING
        PATTERN "*.json" PATTERN "malformed" EXCLUDE PATTERN "wellformed" EXCLUDE)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/validation/reference DESTINATION ${CMAKE_INSTALL_DATADIR}/trivium)
set(config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/trivium)
install(EXPORT triviumTargets NAMESPACE trivium:: DESTINATION ${config_dir})
configure_package_config_file(${PROJECT_SOURCE_DIR}/validation/cmake/triviumConfig.cmake.in ${CMAKE_BINARY_DIR}/triviumConfig.cmake
                              INSTALL_DESTINATION ${config_dir})
write_basic_package_version_file(${CMAKE_BINARY_DIR}/triviumConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/triviumConfig.cmake ${CMAKE_BINARY_DIR}/triviumConfigVersion.cmake
        DESTINATION ${config_dir})
