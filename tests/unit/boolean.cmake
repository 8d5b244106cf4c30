sectile_test(hubs_test SOURCES hubs_test.cpp)
sectile_test(face_parts_test SOURCES face_parts_test.cpp)
sectile_test(contacts_in_points_test SOURCES contacts_in_points_test.cpp)
sectile_test(slit_test SOURCES slit_test.cpp)
