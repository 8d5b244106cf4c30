sectile_test(primitives_test SOURCES primitives_test.cpp)
sectile_test(transform_test SOURCES transform_test.cpp)
