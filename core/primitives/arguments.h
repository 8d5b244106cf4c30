// Checks of the arguments of primitives and transforms: std::invalid_argument with a sentence.
#pragma once

#include <cstdint>
#include <string>

namespace sectile {

void require(bool condition, const std::string& sentence);
/// Positive and finite.
void require_length(double value, const char* name);
/// At least `least`, and few enough for 32-bit ids.
void require_count(std::uint32_t value, std::uint32_t least, const char* name);
/// Few enough positions for 32-bit ids.
void require_size(std::uint64_t positions);

}  // namespace sectile
