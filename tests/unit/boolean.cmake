sectile_test(books_test SOURCES books_test.cpp crowded_books_test.cpp crossing_books_test.cpp)
sectile_test(far_loops_test SOURCES far_loops_test.cpp)
sectile_test(hubs_test SOURCES hubs_test.cpp)
sectile_test(face_parts_test SOURCES face_parts_test.cpp)
sectile_test(contacts_in_points_test SOURCES contacts_in_points_test.cpp)
sectile_test(slit_test SOURCES slit_test.cpp)
sectile_test(crossing_edges_test SOURCES crossing_edges_test.cpp)
sectile_test(equality_test SOURCES boolean/equality_test.cpp)
sectile_test(crowded_faces_test SOURCES boolean/crowded_faces_test.cpp)
# Each phase by itself.
sectile_test(boolean_phases_test SOURCES boolean/reduction_test.cpp boolean/neighborhoods_test.cpp
             boolean/null_edges_test.cpp boolean/joining_test.cpp boolean/components_test.cpp
             boolean/gluing_test.cpp boolean/patch_euler_test.cpp boolean/equal_planes_test.cpp
             boolean/direction_test.cpp boolean/crowded_lines_test.cpp
             boolean/part_loader_test.cpp boolean/point_in_solid_test.cpp)
sectile_test(common_faces_test SOURCES boolean/common_faces_test.cpp boolean/face_match_test.cpp)
sectile_test(same_bits_test LABEL slow SOURCES same_bits_test.cpp)
