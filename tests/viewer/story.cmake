sectile_test(story_test SOURCES story_test.cpp story_figures_test.cpp
  LIBRARIES sectile_viewer_story sectile::samples)
