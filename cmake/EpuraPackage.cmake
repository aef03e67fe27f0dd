# SPDX-License-Identifier: Apache-2.0
# What `cmake --install` puts where; all of it may be moved together afterwards. What names no component is of the
# program.
include(CMakePackageConfigHelpers)

option(EPURA_DEBIAN "make Debian packages with CPack" OFF)
set(EPURA_ZSH_COMPLETIONS ${CMAKE_INSTALL_DATADIR}/zsh/site-functions CACHE STRING "where zsh looks for completions")

install(TARGETS epura RUNTIME)
install(TARGETS epura-study RUNTIME COMPONENT study)
install(FILES docs/plugins.md docs/importers.md docs/formats.md docs/reports.md docs/scenes.md CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
set(completion src/run/app/completion/epura)
install(FILES ${completion}.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME epura)
install(FILES ${completion}.zsh DESTINATION ${EPURA_ZSH_COMPLETIONS} RENAME _epura)
install(FILES ${completion}.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)

# Each program writes its own manual page; that of epura tells the projections of this project.
function(epura_install_manual program component)
  set(page ${CMAKE_CURRENT_BINARY_DIR}/${program}.1)
  set(compress)
  if(EPURA_DEBIAN)
    set(compress "execute_process(COMMAND gzip -9nf \"${page}\" COMMAND_ERROR_IS_FATAL ANY)")
  endif()
  install(CODE "
    execute_process(COMMAND \"${CMAKE_COMMAND}\" -E env --unset=EPURA_PLUGIN_PATH \"$<TARGET_FILE:${program}>\" manual
                    OUTPUT_FILE \"${page}\" COMMAND_ERROR_IS_FATAL ANY)
    ${compress}" COMPONENT ${component})
  install(FILES ${page}$<$<BOOL:${EPURA_DEBIAN}>:.gz> DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT ${component})
endfunction()
epura_install_manual(epura epura)
epura_install_manual(epura-study study)

set(package ${CMAKE_INSTALL_LIBDIR}/cmake/epura)
install(TARGETS epura_plugin epura_library epura_hlr EXPORT epura-targets
        LIBRARY COMPONENT library NAMELINK_COMPONENT development)
install(DIRECTORY include/epura DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development)

configure_package_config_file(cmake/epura-config.cmake.in epura-config.cmake INSTALL_DESTINATION ${package})
write_basic_package_version_file(epura-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/epura-config.cmake ${CMAKE_CURRENT_BINARY_DIR}/epura-config-version.cmake
              cmake/EpuraPlugins.cmake cmake/EpuraSnapshotTests.cmake
        DESTINATION ${package} COMPONENT development)
install(EXPORT epura-targets NAMESPACE epura:: DESTINATION ${package} COMPONENT development)

set(pkgconfig ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
string(REGEX REPLACE "[^/]+" ".." EPURA_PREFIX_FROM_PC ${pkgconfig})
foreach(name IN ITEMS epura epura-hlr)
  configure_file(cmake/epura.pc.in ${name}.pc @ONLY)
endforeach()
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/epura.pc ${CMAKE_CURRENT_BINARY_DIR}/epura-hlr.pc DESTINATION ${pkgconfig} COMPONENT development)

if(EPURA_DEBIAN)
  include(EpuraDebian)
endif()
