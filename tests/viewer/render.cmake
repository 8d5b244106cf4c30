sectile_test(viewer_gif_test SOURCES gif_test.cpp LIBRARIES sectile_viewer_render)
sectile_test(render_test
             SOURCES camera_test.cpp image_test.cpp look_test.cpp offscreen_test.cpp
                     renderer_test.cpp surface_mesh_test.cpp demo_pictures.cpp drawn_pictures.cpp
                     leaks.cpp
             LIBRARIES sectile_viewer_render sectile::samples)

# Windows need a display: one that nobody sees. Without -noreset the server restarts between two
# clients, and now and then refuses the second.
find_program(XVFB_RUN xvfb-run REQUIRED)
add_executable(window_test window_test.cpp demo_pictures.cpp leaks.cpp)
sectile_target(window_test)
target_link_libraries(window_test PRIVATE sectile_viewer_render sectile::samples GTest::gtest_main)
add_test(NAME window_test
         COMMAND ${XVFB_RUN} -a -s "-screen 0 1400x1000x24 -noreset" $<TARGET_FILE:window_test>)
set_tests_properties(window_test PROPERTIES LABELS fast TIMEOUT 300)

# Draws the pictures that the tests use into a folder, and measures frame times.
add_executable(render_pictures render_pictures.cpp demo_pictures.cpp)
sectile_target(render_pictures)
target_link_libraries(render_pictures PRIVATE sectile_viewer_render sectile::samples)

sectile_test(screenshot_test SOURCES screenshot_test.cpp leaks.cpp LIBRARIES sectile_viewer_program)
