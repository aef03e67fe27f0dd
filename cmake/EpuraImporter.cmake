# SPDX-License-Identifier: Apache-2.0
# epura_add_importer(NAME source... [COMPONENT component]): an importer NAME.so, loadable by epura, in C++ or C.
# In this tree and outside it, after find_package(epura COMPONENTS plugin), the same function is used.
include(GNUInstallDirs)

function(epura_add_importer name)
  cmake_parse_arguments(IMPORTER "" "COMPONENT" "" ${ARGN})
  add_library(${name} MODULE ${IMPORTER_UNPARSED_ARGUMENTS})
  target_link_libraries(${name} PRIVATE epura::plugin)
  get_property(languages GLOBAL PROPERTY ENABLED_LANGUAGES)
  if(CXX IN_LIST languages)
    target_compile_features(${name} PRIVATE cxx_std_20)
  endif()
  # Everything but the entry point stays inside.
  set_target_properties(${name} PROPERTIES PREFIX "" CXX_VISIBILITY_PRESET hidden C_VISIBILITY_PRESET hidden
                        VISIBILITY_INLINES_HIDDEN ON)
  if(EPURA_IMPORTER_OUTPUT_DIRECTORY)
    set_target_properties(${name} PROPERTIES LIBRARY_OUTPUT_DIRECTORY ${EPURA_IMPORTER_OUTPUT_DIRECTORY})
  endif()
  if(IMPORTER_COMPONENT)
    install(TARGETS ${name} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/epura/importers
            COMPONENT ${IMPORTER_COMPONENT})
  else()
    install(TARGETS ${name} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/epura/importers)
  endif()
endfunction()
