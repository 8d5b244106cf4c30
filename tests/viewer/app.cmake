if(TARGET sectile_viewer_app)
  sectile_test(viewer_app_test
    LABEL viewer
    SOURCES app_driver.cpp app_test.cpp app_drag_test.cpp app_habits_test.cpp app_measure_test.cpp
            app_output_test.cpp app_pattern_test.cpp app_place_test.cpp app_profile_test.cpp app_repair_test.cpp app_rest_test.cpp
            app_select_test.cpp app_tour_test.cpp app_transform_test.cpp app_tree_test.cpp app_work_test.cpp
            app_sizes_test.cpp document_test.cpp random_events_test.cpp random_person.cpp
            typed_number_test.cpp
    LIBRARIES sectile_viewer_app)
endif()

# Killed at any moment.
if(TARGET sectile_viewer_app)
  add_executable(crash_victim app_driver.cpp crash_victim.cpp random_person.cpp)
  sectile_target(crash_victim)
  target_include_directories(crash_victim PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  target_link_libraries(crash_victim PRIVATE sectile_viewer_app)
  sectile_test(viewer_crash_test LABEL viewer SOURCES crash_test.cpp LIBRARIES sectile_viewer_scene)
  target_compile_definitions(viewer_crash_test
    PRIVATE SECTILE_CRASH_VICTIM="$<TARGET_FILE:crash_victim>")
  add_dependencies(viewer_crash_test crash_victim)
endif()

# The program without a display: what it draws, and its exit codes.
if(TARGET sectile_viewer)
  sectile_test(viewer_program_test LABEL viewer SOURCES viewer_program_test.cpp
               LIBRARIES sectile_viewer_render)
  target_compile_definitions(viewer_program_test
    PRIVATE SECTILE_VIEWER_PROGRAM="$<TARGET_FILE:sectile_viewer>")
  add_dependencies(viewer_program_test sectile_viewer)
endif()

# The program itself with a real mouse and real keys, on a display that nobody sees.
find_program(XVFB_RUN xvfb-run)
find_program(XDOTOOL xdotool)
if(TARGET sectile_viewer)
  add_executable(program_in_window_test app_driver.cpp program_in_window_test.cpp real_window.cpp
                 scripted_person_test.cpp)
  sectile_target(program_in_window_test)
  target_include_directories(program_in_window_test PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  target_compile_definitions(program_in_window_test
    PRIVATE SECTILE_VIEWER_PROGRAM="$<TARGET_FILE:sectile_viewer>")
  target_link_libraries(program_in_window_test PRIVATE sectile_viewer_app GTest::gtest_main)
  add_dependencies(program_in_window_test sectile_viewer)
  if(XVFB_RUN AND XDOTOOL)
    add_test(NAME program_in_window_test
             COMMAND ${XVFB_RUN} -a -s "-screen 0 1400x1000x24 -noreset"
                     $<TARGET_FILE:program_in_window_test>)
  else()
    add_test(NAME program_in_window_test
             COMMAND ${CMAKE_COMMAND} -E echo "Xvfb or xdotool is not installed")
    set_tests_properties(program_in_window_test PROPERTIES SKIP_REGULAR_EXPRESSION "not installed")
  endif()
  # The longest: begun first, so that nothing waits for it.
  set_tests_properties(program_in_window_test PROPERTIES LABELS xvfb TIMEOUT 600 COST 1000)
endif()

# Films from the command line.
if(TARGET sectile_viewer)
  foreach(film turntable film-steps)
    add_test(NAME viewer_${film}_test
             COMMAND sectile_viewer --sample fig01 --${film} ${CMAKE_CURRENT_BINARY_DIR}/${film}.gif
                     --size 96x64)
    set_tests_properties(viewer_${film}_test PROPERTIES LABELS viewer TIMEOUT 300
                         PASS_REGULAR_EXPRESSION "/${film}.gif")
  endforeach()
endif()
