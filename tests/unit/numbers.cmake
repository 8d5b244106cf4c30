find_package(Boost 1.74 REQUIRED)
sectile_test(bounded_test SOURCES bounded_test.cpp)
sectile_test(dyadic_test COMPUTES SOURCES dyadic_test.cpp dyadic_exactness_test.cpp sign_of_dot_test.cpp
             LIBRARIES Boost::headers)
sectile_test(disjoint_sets_test SOURCES disjoint_sets_test.cpp concurrent_sets_test.cpp)
sectile_test(table_test SOURCES table_test.cpp)
sectile_test(parallel_test SOURCES parallel_test.cpp once_alone_test.cpp)
