sectile_test(arrangement_test SOURCES arrangement_test.cpp)
sectile_test(repair_test SOURCES repair_test.cpp repair_cases_test.cpp repair_large_test.cpp
             repair_polygons_test.cpp)
sectile_test(cancel_tenths_test SOURCES cancel_tenths_test.cpp)
