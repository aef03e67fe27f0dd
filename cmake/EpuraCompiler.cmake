# SPDX-License-Identifier: Apache-2.0
# Settings shared by everything that is compiled here.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()

# Contraction to fused multiply-add would make results depend on compiler and processor.
add_compile_options(-ffp-contract=off -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion)
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  # Functions of one file may call each other directly, as Clang lets them: no library replaces any.
  add_compile_options(-fno-semantic-interposition)
  # GCC 12 sees overlapping copies in plain string concatenation (GCC bug 105651).
  add_compile_options($<$<COMPILE_LANGUAGE:CXX>:-Wno-restrict>)
endif()
if(EPURA_WERROR)
  add_compile_options(-Werror)
endif()
# For programs that strangers' files reach: as in Debian's own packages.
if(EPURA_HARDENED)
  add_compile_options(-D_FORTIFY_SOURCE=2 -fstack-protector-strong -fstack-clash-protection)
  if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|i.86")
    add_compile_options(-fcf-protection)
  endif()
  add_link_options(-Wl,-z,relro,-z,now,-z,noexecstack)
endif()
if(EPURA_SANITIZE)
  add_compile_options(-fsanitize=${EPURA_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${EPURA_SANITIZE})
endif()

# epura_compile_together(TARGET): several of its sources at once, if EPURA_UNITY says so.
function(epura_compile_together target)
  if(EPURA_UNITY)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON)
    # A local name may be that of a constant of another source; to GCC, sources that are included are headers.
    target_compile_options(${target} PRIVATE -Wno-shadow $<$<COMPILE_LANG_AND_ID:CXX,GNU>:-Wno-subobject-linkage>)
  endif()
endfunction()

# Headers are named by their folders: "base/text.hpp" is in src/ground.
set(EPURA_DISTRICTS ground input model view sheet run)
list(TRANSFORM EPURA_DISTRICTS PREPEND ${PROJECT_SOURCE_DIR}/src/)

# epura_stage(NAME [FAST_TO_BUILD] sources... [LINK libraries...]): one folder of a district of src/ as one static library.
# What reads options and starts others takes no time itself; nearly half of its compiling would go into optimizing it.
function(epura_stage name)
  cmake_parse_arguments(STAGE "FAST_TO_BUILD" "" "LINK" ${ARGN})
  add_library(epura_${name} STATIC ${STAGE_UNPARSED_ARGUMENTS})
  epura_compile_together(epura_${name})
  target_include_directories(epura_${name} PUBLIC ${EPURA_DISTRICTS} ${PROJECT_SOURCE_DIR}/include)
  target_link_libraries(epura_${name} PUBLIC ${STAGE_LINK})
  # A fifth of the time that a stage takes to compile goes into what nearly every source includes.
  if(EPURA_UNITY)
    if(name STREQUAL base)
      target_precompile_headers(epura_base PRIVATE
        <algorithm> <array> <cmath> <filesystem> <functional> <map> <memory> <numbers> <optional> <random> <set> <span> <string>
        <string_view> <tuple> <utility> <vector> <base/error.hpp> <base/text.hpp> <base/vec.hpp>)
    else()
      target_precompile_headers(epura_${name} REUSE_FROM epura_base)
    endif()
    # GCC 12 sees overflows in strings that are put together in precompiled headers.
    target_compile_options(epura_${name} PRIVATE $<$<COMPILE_LANG_AND_ID:CXX,GNU>:-Wno-array-bounds;-Wno-stringop-overflow>)
  endif()
  # Where nothing is optimized, this would be more.
  if(STAGE_FAST_TO_BUILD AND NOT CMAKE_CXX_FLAGS_RELEASE MATCHES "-O0")
    target_compile_options(epura_${name} PRIVATE -O1)
  endif()
  if(EPURA_COVERAGE STREQUAL "all" OR name IN_LIST EPURA_COVERAGE)
    # Optimized as far as lines keep code of their own.
    target_compile_options(epura_${name} PRIVATE --coverage -Og -Wno-error)
    target_link_options(epura_${name} PUBLIC --coverage)
  endif()
endfunction()
