# The modeller's workers, for ThreadSanitizer (preset tsan).
sectile_test(viewer_threads_test LABEL threads
             SOURCES viewer/background_test.cpp viewer/evaluator_test.cpp viewer/recovery_test.cpp
             LIBRARIES sectile_viewer_evaluation)
