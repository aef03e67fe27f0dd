# SPDX-License-Identifier: Apache-2.0
# epura_add_projection(NAME source... [COMPONENT component]): a projection plugin NAME.so, in C++ or C.
# epura_add_importer(NAME source... [COMPONENT component]): an importer NAME.so, in C++ or C.
# In this tree and outside it, after find_package(epura COMPONENTS plugin), the same functions are used.
include(GNUInstallDirs)

function(epura_add_projection name)
  epura_add_plugin(${name} projections "${EPURA_PLUGIN_OUTPUT_DIRECTORY}" ${ARGN})
endfunction()

function(epura_add_importer name)
  epura_add_plugin(${name} importers "${EPURA_IMPORTER_OUTPUT_DIRECTORY}" ${ARGN})
endfunction()

# `folder`: where epura looks for plugins of its kind, below lib/epura. `output`: where it is built, or empty.
function(epura_add_plugin name folder output)
  cmake_parse_arguments(PLUGIN "" "COMPONENT" "" ${ARGN})
  add_library(${name} MODULE ${PLUGIN_UNPARSED_ARGUMENTS})
  target_link_libraries(${name} PRIVATE epura::plugin)
  get_property(languages GLOBAL PROPERTY ENABLED_LANGUAGES)
  if(CXX IN_LIST languages)
    target_compile_features(${name} PRIVATE cxx_std_20)
  endif()
  # Everything but the entry point stays inside.
  set_target_properties(${name} PROPERTIES PREFIX "" CXX_VISIBILITY_PRESET hidden C_VISIBILITY_PRESET hidden
                        VISIBILITY_INLINES_HIDDEN ON)
  if(output)
    set_target_properties(${name} PROPERTIES LIBRARY_OUTPUT_DIRECTORY ${output})
  endif()
  set(component)
  if(PLUGIN_COMPONENT)
    set(component COMPONENT ${PLUGIN_COMPONENT})
  endif()
  install(TARGETS ${name} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/epura/${folder} ${component})
endfunction()
