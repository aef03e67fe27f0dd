# SPDX-License-Identifier: Apache-2.0
# cmake -DMAKE_SAMPLES=program -DMODELS=folder -DSCRATCH=folder -P fresh.cmake
# Fails unless the committed models are, byte for byte, what the program makes now.
file(REMOVE_RECURSE ${SCRATCH})
file(MAKE_DIRECTORY ${SCRATCH})
execute_process(COMMAND ${MAKE_SAMPLES} ${SCRATCH} COMMAND_ERROR_IS_FATAL ANY)

file(GLOB committed RELATIVE ${MODELS} ${MODELS}/*)
file(GLOB made RELATIVE ${SCRATCH} ${SCRATCH}/*)
if(NOT committed STREQUAL made)
  message(FATAL_ERROR "committed: ${committed}\nmade:      ${made}")
endif()
foreach(name IN LISTS made)
  file(SHA256 ${MODELS}/${name} old)
  file(SHA256 ${SCRATCH}/${name} new)
  if(NOT old STREQUAL new)
    message(SEND_ERROR "${MODELS}/${name} differs from what make_samples makes: ${SCRATCH}/${name}")
  endif()
endforeach()
