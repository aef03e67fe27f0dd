# SPDX-License-Identifier: Apache-2.0
# Tests of the tree itself. Included by CMakeLists.txt beside it.
add_test(NAME layers COMMAND ${CMAKE_COMMAND} -P ${CMAKE_CURRENT_LIST_DIR}/layers.cmake)
add_test(NAME checks_can_fail COMMAND ${CMAKE_CURRENT_LIST_DIR}/checks_test.sh)
add_test(NAME readme_runs COMMAND ${CMAKE_CURRENT_LIST_DIR}/readme.sh $<TARGET_FILE:epura>)
add_test(NAME batch_on_slurm COMMAND ${CMAKE_CURRENT_LIST_DIR}/slurm.sh $<TARGET_FILE:epura>)
set_tests_properties(batch_on_slurm PROPERTIES SKIP_RETURN_CODE 77)
add_test(NAME gallery_page_is_fresh
         COMMAND bash -c "diff <(samples/draw --gallery-page) samples/gallery.md" WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
# Whatever links to a sanitized library must be sanitized, too: strangers' projects are not.
if(NOT EPURA_SANITIZE)
  add_test(NAME library_symbols COMMAND ${CMAKE_CURRENT_LIST_DIR}/symbols.sh $<TARGET_FILE:epura_library>
           libepura.so.${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR} library.symbols)
  add_test(NAME hlr_symbols COMMAND ${CMAKE_CURRENT_LIST_DIR}/symbols.sh $<TARGET_FILE:epura_hlr> libepura-hlr.so.1
           hlr.symbols)
  add_test(NAME hlr_draws_no_sheets
           COMMAND sh -c "! readelf -d $<TARGET_FILE:epura_hlr> | grep -E 'NEEDED.*(cairo|font|freetype|harfbuzz|qpdf)'")
  add_test(NAME cpp_page_runs COMMAND ${CMAKE_CURRENT_LIST_DIR}/cpp_page.sh $<TARGET_FILE:epura_library>
           ${PROJECT_BINARY_DIR}/include)
  add_test(NAME sdk_works COMMAND ${CMAKE_CURRENT_LIST_DIR}/sdk.sh ${CMAKE_BINARY_DIR})
endif()
# Debugging and counting need the places of sources.
if(CMAKE_BUILD_TYPE STREQUAL Release AND NOT EPURA_COVERAGE AND NOT EPURA_SANITIZE)
  add_test(NAME programs_hold_no_traces COMMAND ${CMAKE_CURRENT_LIST_DIR}/traces.sh $<TARGET_FILE:epura>
           $<TARGET_FILE:epura_library> $<TARGET_FILE:epura_hlr> ${CMAKE_BINARY_DIR}/lib/epura)
endif()
add_test(NAME accuracy_page_is_fresh COMMAND ${CMAKE_CURRENT_LIST_DIR}/accuracy.sh $<TARGET_FILE:epura>)
add_test(NAME manual_is_sound COMMAND ${CMAKE_CURRENT_LIST_DIR}/manual.sh $<TARGET_FILE:epura>)
find_package(Python3 COMPONENTS Interpreter REQUIRED)
add_test(NAME planted_faults_have_places
         COMMAND ${Python3_EXECUTABLE} -B ${CMAKE_CURRENT_LIST_DIR}/mutants/run --check)
add_test(NAME functions_state_what_holds COMMAND ${Python3_EXECUTABLE} -B ${CMAKE_CURRENT_LIST_DIR}/invariants)
if(TARGET epura-faults)
  add_test(NAME faults COMMAND ${Python3_EXECUTABLE} -B ${CMAKE_CURRENT_LIST_DIR}/faults/run --sample --jobs 2
           $<TARGET_FILE:epura> $<TARGET_FILE:epura-faults>)
  set_tests_properties(faults PROPERTIES TIMEOUT 900)
endif()
# In a browser, where there is one (package chromium).
foreach(test page payload element play tree)
  add_test(NAME ${test}_in_browser COMMAND ${Python3_EXECUTABLE} -B ${CMAKE_CURRENT_LIST_DIR}/browser/${test}_test.py
           $<TARGET_FILE:epura> ${CMAKE_BINARY_DIR}/share/epura/epura-drawing.js ${CMAKE_BINARY_DIR}/tests/bad-plugins)
  set_tests_properties(${test}_in_browser PROPERTIES SKIP_RETURN_CODE 77 TIMEOUT 300)
endforeach()
add_test(NAME archive_keeps_standards COMMAND ${Python3_EXECUTABLE} -B ${CMAKE_CURRENT_LIST_DIR}/archive.py $<TARGET_FILE:epura>)
set_tests_properties(archive_keeps_standards PROPERTIES SKIP_RETURN_CODE 77)
add_test(NAME serve_is_guarded COMMAND ${Python3_EXECUTABLE} -B ${CMAKE_CURRENT_LIST_DIR}/serve_test.py
         $<TARGET_FILE:epura> ${CMAKE_BINARY_DIR}/tests/bad-plugins)
set_tests_properties(serve_is_guarded PROPERTIES TIMEOUT 300)
add_test(NAME batch_survives COMMAND ${Python3_EXECUTABLE} -B ${CMAKE_CURRENT_LIST_DIR}/batch_trials.py $<TARGET_FILE:epura>)
set_tests_properties(batch_survives PROPERTIES TIMEOUT 300)
add_test(NAME completion_in_shells COMMAND ${CMAKE_CURRENT_LIST_DIR}/completion.sh $<TARGET_FILE:epura>)
# The longest first: the last one to start runs alone at the end.
foreach(test accuracy_page_is_fresh batch_survives batch_on_slurm faults sdk_works payload_in_browser)
  if(TEST ${test})
    set_tests_properties(${test} PROPERTIES COST 100)
  endif()
endforeach()
