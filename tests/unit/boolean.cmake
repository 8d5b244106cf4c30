sectile_test(hubs_test SOURCES hubs_test.cpp LIBRARIES sectile::core)
