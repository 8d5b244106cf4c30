#include "primitives/arguments.h"

#include <cmath>
#include <stdexcept>

namespace sectile {

void require(bool condition, const std::string& sentence) {
  if (!condition) throw std::invalid_argument(sentence);
}

void require_length(double value, const char* name) {
  if (std::isfinite(value) && value > 0) return;
  throw std::invalid_argument(std::string("The ") + name + " is " + std::to_string(value) +
                              "; it must be positive and finite.");
}

void require_count(std::uint32_t value, std::uint32_t least, const char* name) {
  if (value >= least) return;
  throw std::invalid_argument("The number of " + std::string(name) + " is " +
                              std::to_string(value) + "; it must be at least " +
                              std::to_string(least) + ".");
}

void require_size(std::uint64_t positions) {
  // Half-edges are numbered with 32 bits; a closed triangle mesh has six of them for each vertex.
  constexpr std::uint64_t most = (std::uint64_t{1} << 32) / 8;
  if (positions <= most) return;
  throw std::invalid_argument("The solid would have " + std::to_string(positions) +
                              " vertices; at most " + std::to_string(most) + " are possible.");
}

}  // namespace sectile
