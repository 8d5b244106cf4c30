sectile_test(viewer_scene_test SOURCES scene_test.cpp scene_file_test.cpp history_test.cpp
             recovery_test.cpp LIBRARIES sectile_viewer_scene)
sectile_test(viewer_evaluator_test SOURCES evaluator_test.cpp pattern_test.cpp LIBRARIES sectile_viewer_evaluation)
sectile_test(viewer_picking_test SOURCES picking_test.cpp LIBRARIES sectile_viewer_scene
             NOT_SANITIZED *.IsFast*)
sectile_test(viewer_handles_test SOURCES handles_test.cpp LIBRARIES sectile_viewer_scene)
sectile_test(viewer_background_test SOURCES background_test.cpp LIBRARIES sectile_viewer_events)
sectile_test(viewer_placing_test SOURCES placing_test.cpp chamfer_test.cpp scene_clip_test.cpp measuring_test.cpp profile_sketch_test.cpp LIBRARIES sectile_viewer_scene)
