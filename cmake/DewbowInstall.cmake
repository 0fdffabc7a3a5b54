# SPDX-License-Identifier: Apache-2.0
# The library for other people's CMake: find_package(dewbow), dewbow::optics or dewbow::dewbow.
include(CMakePackageConfigHelpers)

set(dewbow_package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/dewbow")
install(TARGETS ${dewbow_module_targets} dewbow_umbrella EXPORT dewbowTargets
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(EXPORT dewbowTargets NAMESPACE dewbow:: DESTINATION "${dewbow_package_dir}")
if(EXISTS "${PROJECT_SOURCE_DIR}/src/dewbow")
  install(DIRECTORY src/dewbow DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.h")
endif()

configure_package_config_file(cmake/dewbowConfig.cmake.in
                              "${PROJECT_BINARY_DIR}/dewbowConfig.cmake"
                              INSTALL_DESTINATION "${dewbow_package_dir}")
write_basic_package_version_file("${PROJECT_BINARY_DIR}/dewbowConfigVersion.cmake"
                                 COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/dewbowConfig.cmake"
              "${PROJECT_BINARY_DIR}/dewbowConfigVersion.cmake"
        DESTINATION "${dewbow_package_dir}")
