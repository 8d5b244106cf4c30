find_package(nlohmann_json 3.11 REQUIRED)
sectile_test(trace_test SOURCES trace_test.cpp
  LIBRARIES sectile::samples nlohmann_json::nlohmann_json)
