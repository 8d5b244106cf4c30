# Elements have other numbers in the small blocks that the sanitizers look at.
sectile_test(story_test SOURCES story_test.cpp story_figures_test.cpp teaching_test.cpp
  LIBRARIES sectile_viewer_story sectile::samples TOGETHER_BUT StoryFigures.*)
if(TARGET sectile_viewer_program)
  sectile_test(tour_test SOURCES tour_test.cpp LIBRARIES sectile_viewer_program)
endif()
