find_package(Boost 1.74 REQUIRED)
sectile_test(kernel_test COMPUTES SOURCES kernel_test.cpp LIBRARIES Boost::headers)
sectile_test(four_points_test SOURCES four_points_test.cpp)
sectile_test(shared_table_test SOURCES shared_table_test.cpp)
