sectile_test(euler_test SOURCES euler_test.cpp)
