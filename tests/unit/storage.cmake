sectile_test(blocks_test SOURCES blocks_test.cpp)
sectile_test(solid_data_test SOURCES solid_data_test.cpp)
sectile_test(exact_file_test SOURCES exact_file_test.cpp)
sectile_test(moved_solid_test SOURCES moved_solid_test.cpp)
