# SPDX-License-Identifier: Apache-2.0
# epura_add_projection(NAME source...): a projection plugin NAME.so, loadable by epura, in C++ or C.
# In this tree and outside it, after find_package(epura COMPONENTS plugin), the same function is used.
include(GNUInstallDirs)

function(epura_add_projection name)
  add_library(${name} MODULE ${ARGN})
  target_link_libraries(${name} PRIVATE epura::plugin)
  get_property(languages GLOBAL PROPERTY ENABLED_LANGUAGES)
  if(CXX IN_LIST languages)
    target_compile_features(${name} PRIVATE cxx_std_20)
  endif()
  # Everything but the entry point stays inside.
  set_target_properties(${name} PROPERTIES PREFIX "" CXX_VISIBILITY_PRESET hidden C_VISIBILITY_PRESET hidden
                        VISIBILITY_INLINES_HIDDEN ON)
  if(EPURA_PLUGIN_OUTPUT_DIRECTORY)
    set_target_properties(${name} PROPERTIES LIBRARY_OUTPUT_DIRECTORY ${EPURA_PLUGIN_OUTPUT_DIRECTORY})
  endif()
  install(TARGETS ${name} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/epura/projections)
endfunction()
