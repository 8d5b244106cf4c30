sectile_test(box_tree_test SOURCES box_tree_test.cpp)
