sectile_test(rounding_test SOURCES rounding_test.cpp)
