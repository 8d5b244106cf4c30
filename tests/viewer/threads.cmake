# What all workers of the modeller run on, for ThreadSanitizer (preset tsan).
sectile_test(viewer_threads_test LABEL threads
             SOURCES viewer/background_test.cpp LIBRARIES sectile_viewer_events)
