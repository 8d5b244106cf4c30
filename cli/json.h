// What the program prints for other programs. The code of the library's template is compiled once,
// in json.cpp.
#pragma once

#include <nlohmann/json.hpp>

extern template class nlohmann::basic_json<nlohmann::ordered_map>;
