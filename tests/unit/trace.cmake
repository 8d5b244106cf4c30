find_package(nlohmann_json 3.11 REQUIRED)
sectile_test(cancel_test SOURCES cancel_test.cpp)
sectile_test(trace_test SOURCES trace_test.cpp
  LIBRARIES sectile::samples nlohmann_json::nlohmann_json)
