sectile_test(viewer_scene_test SOURCES scene_test.cpp scene_file_test.cpp history_test.cpp
             recovery_test.cpp LIBRARIES sectile_viewer_scene)
sectile_test(viewer_evaluator_test SOURCES evaluator_test.cpp LIBRARIES sectile_viewer_evaluation)
