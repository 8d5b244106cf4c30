sectile_test(files_test SOURCES files_test.cpp files_test_malformed.cpp files_test_obj.cpp
             files_test_ply.cpp files_test_truncated.cpp files_test_writing.cpp)
sectile_test(files_memory_test SOURCES files_memory_test.cpp)
