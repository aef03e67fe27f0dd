# SPDX-License-Identifier: Apache-2.0
# The bill of materials of the Debian packages: what they are made of, in which version, as SPDX 2.3.
# A line: Debian package, licence as in CONTRIBUTING.md, how it is used.
set(materials
  "libcairo2-dev|LGPL-2.1-only OR MPL-1.1|DYNAMIC_LINK"
  "libfontconfig-dev|MIT|DYNAMIC_LINK"
  "libfreetype-dev|FTL OR GPL-2.0-or-later|DYNAMIC_LINK"
  "libfribidi-dev|LGPL-2.1-or-later|DYNAMIC_LINK"
  "libgmp-dev|LGPL-3.0-or-later OR GPL-2.0-or-later|DYNAMIC_LINK"
  "libharfbuzz-dev|MIT|DYNAMIC_LINK"
  "libmicrohttpd-dev|LGPL-2.1-or-later|DYNAMIC_LINK"
  "libpugixml-dev|MIT|DYNAMIC_LINK"
  "nettle-dev|LGPL-3.0-or-later OR GPL-2.0-or-later|DYNAMIC_LINK"
  "libqpdf-dev|Apache-2.0|DYNAMIC_LINK"
  "libseccomp-dev|LGPL-2.1-only|DYNAMIC_LINK"
  "libtbb-dev|Apache-2.0|DYNAMIC_LINK"
  "libzip-dev|BSD-3-Clause|DYNAMIC_LINK"
  "libtinygltf-dev|MIT|DYNAMIC_LINK"
  "libdraco-dev|Apache-2.0|DYNAMIC_LINK"
  "libmeshoptimizer-dev|MIT|DYNAMIC_LINK"
  "libocct-foundation-dev|LGPL-2.1-only WITH OCCT-exception-1.0|DYNAMIC_LINK"
  "libcli11-dev|BSD-3-Clause|STATIC_LINK"
  "libeigen3-dev|MPL-2.0|STATIC_LINK"
  "libglm-dev|MIT|STATIC_LINK"
  "libtomlplusplus-dev|MIT|STATIC_LINK"
  "libutfcpp-dev|BSL-1.0|STATIC_LINK"
  "rapidjson-dev|MIT|STATIC_LINK"
  "fonts-osifont|GPL-3.0-only WITH Font-exception-2.0|RUNTIME_DEPENDENCY_OF")

# Returns the version of an installed Debian package; empty if it is not installed.
function(debian_version package result)
  execute_process(COMMAND dpkg-query --show --showformat=\${Version} ${package}
                  OUTPUT_VARIABLE version ERROR_QUIET RESULT_VARIABLE failure)
  if(failure)
    set(version "")
  endif()
  set(${result} "${version}" PARENT_SCOPE)
endfunction()

# Writes the bill to a file.
function(epura_write_sbom file)
  set(packages "{\"SPDXID\": \"SPDXRef-epura\", \"name\": \"epura\", \"versionInfo\": \"${PROJECT_VERSION}\",
   \"licenseConcluded\": \"Apache-2.0\", \"licenseDeclared\": \"Apache-2.0\", \"copyrightText\": \"the epura authors\",
   \"downloadLocation\": \"NOASSERTION\", \"filesAnalyzed\": false}")
  set(relations "{\"spdxElementId\": \"SPDXRef-DOCUMENT\", \"relationshipType\": \"DESCRIBES\",
   \"relatedSpdxElement\": \"SPDXRef-epura\"}")
  foreach(material IN LISTS materials)
    string(REPLACE "|" ";" material "${material}")
    list(GET material 0 name)
    list(GET material 1 licence)
    list(GET material 2 use)
    debian_version(${name} version)
    if(version STREQUAL "")
      continue()
    endif()
    string(APPEND packages ",\n  {\"SPDXID\": \"SPDXRef-${name}\", \"name\": \"${name}\", \"versionInfo\": \"${version}\",
   \"licenseConcluded\": \"${licence}\", \"licenseDeclared\": \"${licence}\", \"copyrightText\": \"NOASSERTION\",
   \"downloadLocation\": \"NOASSERTION\", \"filesAnalyzed\": false,
   \"externalRefs\": [{\"referenceCategory\": \"PACKAGE-MANAGER\", \"referenceType\": \"purl\",
    \"referenceLocator\": \"pkg:deb/debian/${name}@${version}\"}]}")
    if(use STREQUAL RUNTIME_DEPENDENCY_OF)
      set(ends "\"SPDXRef-${name}\"" "\"SPDXRef-epura\"")
    else()
      set(ends "\"SPDXRef-epura\"" "\"SPDXRef-${name}\"")
    endif()
    list(GET ends 0 from)
    list(GET ends 1 to)
    string(APPEND relations ",\n  {\"spdxElementId\": ${from}, \"relationshipType\": \"${use}\", \"relatedSpdxElement\": ${to}}")
  endforeach()
  string(TIMESTAMP now "%Y-%m-%dT%H:%M:%SZ" UTC)
  file(WRITE ${file} "{\"spdxVersion\": \"SPDX-2.3\", \"dataLicense\": \"CC0-1.0\", \"SPDXID\": \"SPDXRef-DOCUMENT\",
 \"name\": \"epura-${PROJECT_VERSION}\", \"documentNamespace\": \"https://epura.invalid/spdx/${PROJECT_VERSION}/${now}\",
 \"creationInfo\": {\"created\": \"${now}\", \"creators\": [\"Organization: the epura authors\"]},
 \"packages\": [\n  ${packages}],\n \"relationships\": [\n  ${relations}]}\n")
endfunction()
