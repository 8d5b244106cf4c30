sectile_test(volume_sum_test SOURCES volume_sum_test.cpp)
sectile_test(import_test SOURCES import_test.cpp import_flat_test.cpp import_open_edges_test.cpp
             import_join_test.cpp import_nesting_test.cpp shell_boxes_test.cpp import_refusal_test.cpp import_soup_test.cpp import_triangles_test.cpp
             cell_mesh.cpp)
sectile_test(triangle_chunks_test SOURCES triangle_chunks_test.cpp)
sectile_test(self_test_test ORACLE SOURCES self_contacts_test.cpp self_test_test.cpp)
find_package(Boost 1.74 REQUIRED)
sectile_test(measure_test SOURCES measure_test.cpp LIBRARIES Boost::headers)
