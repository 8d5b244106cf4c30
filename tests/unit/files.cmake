find_package(Lib3MF REQUIRED)
sectile_test(files_test SOURCES files_test.cpp files_test_malformed.cpp files_test_obj.cpp
             files_test_ply.cpp files_test_three_mf.cpp files_test_truncated.cpp
             files_test_writing.cpp LIBRARIES Lib3MF::Lib3MF)
sectile_test(files_memory_test SOURCES files_memory_test.cpp)
