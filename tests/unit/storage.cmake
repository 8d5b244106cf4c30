sectile_test(blocks_test SOURCES blocks_test.cpp)
