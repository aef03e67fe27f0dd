# What `cmake --install` puts where; all of it may be moved together afterwards.
include(CMakePackageConfigHelpers)

set(package ${CMAKE_INSTALL_LIBDIR}/cmake/epura)
install(TARGETS epura RUNTIME)
install(TARGETS epura_plugin epura_library EXPORT epura-targets)
install(DIRECTORY include/epura DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(FILES docs/plugins.md docs/formats.md DESTINATION ${CMAKE_INSTALL_DOCDIR})

configure_package_config_file(cmake/epura-config.cmake.in epura-config.cmake INSTALL_DESTINATION ${package})
write_basic_package_version_file(epura-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/epura-config.cmake ${CMAKE_CURRENT_BINARY_DIR}/epura-config-version.cmake
              cmake/EpuraProjection.cmake cmake/EpuraSnapshotTests.cmake DESTINATION ${package})
install(EXPORT epura-targets NAMESPACE epura:: DESTINATION ${package})

set(pkgconfig ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
string(REGEX REPLACE "[^/]+" ".." EPURA_PREFIX_FROM_PC ${pkgconfig})
configure_file(cmake/epura.pc.in epura.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/epura.pc DESTINATION ${pkgconfig})
