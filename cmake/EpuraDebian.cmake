# SPDX-License-Identifier: Apache-2.0
# Debian packages, by CPack: epura (program, projections), epura-study, importers, the library, the module for Python, and
# what is needed to build against epura.
#   cmake --preset deb && cmake --build --preset deb && (cd build/deb && cpack)
# The same sources give the same bytes, whenever and in whatever folder they are built: the time in them is that of the
# last commit, or of SOURCE_DATE_EPOCH, https://reproducible-builds.org/specs/source-date-epoch
if(NOT DEFINED ENV{SOURCE_DATE_EPOCH})
  execute_process(COMMAND git log -1 --format=%ct WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}
                  OUTPUT_VARIABLE time OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failure)
  if(NOT failure EQUAL 0)
    file(TIMESTAMP ${CMAKE_CURRENT_SOURCE_DIR}/CHANGELOG.md time %s UTC)
  endif()
  set(ENV{SOURCE_DATE_EPOCH} ${time})
endif()
set(CPACK_PROJECT_CONFIG_FILE ${CMAKE_CURRENT_BINARY_DIR}/debian/time.cmake)
file(WRITE ${CPACK_PROJECT_CONFIG_FILE} "set(ENV{SOURCE_DATE_EPOCH} $ENV{SOURCE_DATE_EPOCH})\n")

set(EPURA_MAINTAINER "The authors of epura <authors@epura.invalid>" CACHE STRING "field Maintainer of Debian packages")

set(library libepura${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
set(same_version "(= ${PROJECT_VERSION})")
set(CPACK_GENERATOR DEB)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(components epura study library development)
foreach(importer gltf 3mf om opencascade)
  if(TARGET ${importer})
    list(APPEND components ${importer})
  endif()
endforeach()
if(TARGET epura_python)
  list(APPEND components python)
endif()
set(CPACK_COMPONENTS_ALL ${components})
set(CPACK_PACKAGE_NAME epura)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_CONTACT ${EPURA_MAINTAINER})
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY ${PROJECT_DESCRIPTION})
set(CPACK_PACKAGING_INSTALL_PREFIX ${CMAKE_INSTALL_PREFIX})
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
# The module for Python needs the library, which is in another of these packages.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${CMAKE_BINARY_DIR}/lib)

set(CPACK_DEBIAN_EPURA_PACKAGE_NAME epura)
set(CPACK_DEBIAN_EPURA_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_EPURA_PACKAGE_DEPENDS fonts-osifont)
set(CPACK_DEBIAN_EPURA_PACKAGE_SUGGESTS "epura-study ${same_version}, epura-opencascade ${same_version}, epura-gltf ${same_version}, epura-3mf ${same_version}, epura-om ${same_version}")
set(CPACK_DEBIAN_EPURA_DESCRIPTION
"Any projection, exact hidden lines, dimensions and sheets after ISO; reads
OBJ, STL, PLY and OFF, writes SVG, PDF, PS, EPS, PNG, DXF, HTML and JSON.
Projections are plugins.")

set(CPACK_DEBIAN_STUDY_PACKAGE_NAME epura-study)
set(CPACK_DEBIAN_STUDY_PACKAGE_SECTION science)
set(CPACK_DEBIAN_STUDY_PACKAGE_DEPENDS "epura ${same_version}")
set(CPACK_DEBIAN_STUDY_DESCRIPTION
"How right and how fast epura draws: its error against run time, beside that
of other methods, and a table of stiff and extreme cases. `epura study`
starts it.")

set(CPACK_DEBIAN_GLTF_PACKAGE_NAME epura-gltf)
set(CPACK_DEBIAN_GLTF_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_GLTF_PACKAGE_DEPENDS "epura ${same_version}")
set(CPACK_DEBIAN_GLTF_DESCRIPTION
"glTF and GLB for epura: nodes, instances, names, units.")

set(CPACK_DEBIAN_OPENCASCADE_PACKAGE_NAME epura-opencascade)
set(CPACK_DEBIAN_OPENCASCADE_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_OPENCASCADE_PACKAGE_DEPENDS "epura ${same_version}")
set(CPACK_DEBIAN_OPENCASCADE_DESCRIPTION
"STEP, IGES and BREP for epura: exact faces and edges, assemblies, names, units.")

set(CPACK_DEBIAN_3MF_PACKAGE_NAME epura-3mf)
set(CPACK_DEBIAN_3MF_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_3MF_PACKAGE_DEPENDS "epura ${same_version}")
set(CPACK_DEBIAN_3MF_DESCRIPTION
"3MF for epura: items, components, names, units.")

set(CPACK_DEBIAN_OM_PACKAGE_NAME epura-om)
set(CPACK_DEBIAN_OM_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_OM_PACKAGE_DEPENDS "epura ${same_version}")
set(CPACK_DEBIAN_OM_DESCRIPTION
"OM, the files of OpenMesh, for epura: polygons in double precision.")

set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME ${library})
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libs)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_DEPENDS "epura ${same_version}, fonts-osifont")
set(CPACK_DEBIAN_LIBRARY_DESCRIPTION
"What the program epura does, for other programs: the library.")

set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-epura)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
    "epura ${same_version}, ${library} ${same_version}, python3 (>= 3.11), python3 (<< 3.12), python3-numpy")
set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-tqdm, python3-pytest")
set(CPACK_DEBIAN_PYTHON_DESCRIPTION
"Drawings of arrays, files and objects of other libraries; lines as arrays of
numpy, pictures in notebooks, projections written in Python, and drawings in
tests of pytest.")

# Compile the modules for whoever cannot write there, and leave nothing behind.
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA
    "${CMAKE_CURRENT_SOURCE_DIR}/cmake/debian/python/postinst;${CMAKE_CURRENT_SOURCE_DIR}/cmake/debian/python/prerm")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libepura-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "${library} ${same_version}")
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION
"Headers, CMake and pkg-config files of the library of epura, and of its
projection plugins.")

file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/debian/triggers "activate-noawait ldconfig\n")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_CONTROL_EXTRA ${CMAKE_CURRENT_BINARY_DIR}/debian/triggers)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

install(FILES cmake/debian/lintian-overrides DESTINATION ${CMAKE_INSTALL_DATADIR}/lintian/overrides RENAME epura)

# What policy wants of every package. Headers of these libraries are compiled into the program.
set(licences ${CMAKE_CURRENT_BINARY_DIR}/debian/copyright)
configure_file(cmake/debian/copyright ${licences} COPYONLY)
foreach(package libcli11-dev libeigen3-dev libglm-dev libtomlplusplus-dev libutfcpp-dev rapidjson-dev)
  file(READ /usr/share/doc/${package}/copyright text)
  file(APPEND ${licences} "\n-- ${package} --\n\n${text}")
endforeach()
string(TIMESTAMP EPURA_DATE "%a, %d %b %Y %H:%M:%S +0000" UTC)
configure_file(cmake/debian/changelog.in ${CMAKE_CURRENT_BINARY_DIR}/debian/changelog @ONLY)
execute_process(COMMAND gzip -9nf ${CMAKE_CURRENT_BINARY_DIR}/debian/changelog COMMAND_ERROR_IS_FATAL ANY)
foreach(component IN LISTS components)
  string(TOUPPER ${component} upper)
  install(FILES ${licences} ${CMAKE_CURRENT_BINARY_DIR}/debian/changelog.gz
          DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${CPACK_DEBIAN_${upper}_PACKAGE_NAME} COMPONENT ${component})
endforeach()
include(EpuraSbom)
epura_write_sbom(${CMAKE_CURRENT_BINARY_DIR}/debian/epura.spdx.json)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/debian/epura.spdx.json DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/epura)
include(CPack)
