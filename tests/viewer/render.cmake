# Draws the pictures that the tests use into a folder, and measures frame times.
add_executable(render_pictures render_pictures.cpp demo_pictures.cpp)
sectile_target(render_pictures)
target_link_libraries(render_pictures PRIVATE sectile_viewer_render sectile::samples)
