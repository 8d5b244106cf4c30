sectile_test(rounding_test ORACLE SOURCES rounding_test.cpp)
sectile_test(clear_pairs_test SOURCES clear_pairs_test.cpp clear_star_test.cpp clear_stars_test.cpp flat_groups_test.cpp)
sectile_test(touching_cones_test ORACLE SOURCES touching_cones_test.cpp)
sectile_test(common_lines_test ORACLE SOURCES common_lines_test.cpp)
