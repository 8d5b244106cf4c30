sectile_test(box_tree_test SOURCES box_tree_test.cpp box_search_test.cpp)
sectile_test(hull_test SOURCES hull_test.cpp)
