if(TARGET sectile_viewer_app)
  sectile_test(viewer_app_test
    LABEL viewer
    SOURCES app_driver.cpp app_test.cpp app_drag_test.cpp app_tree_test.cpp app_work_test.cpp
    LIBRARIES sectile_viewer_app)
endif()
