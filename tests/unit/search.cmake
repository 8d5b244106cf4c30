sectile_test(box_tree_test SOURCES box_tree_test.cpp bucket_sort_test.cpp box_search_test.cpp edges_by_line_test.cpp)
sectile_test(curve_order_test SOURCES curve_order_test.cpp)
sectile_test(hull_test SOURCES hull_test.cpp)
sectile_test(outline_tree_test SOURCES outline_tree_test.cpp)
