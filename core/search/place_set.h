// A set of places by their coordinates.
#pragma once

#include <bit>
#include <cstdint>
#include <vector>

#include "sectile/mesh.h"

namespace sectile {

/// The same for equal coordinates. Of solids that are symmetric, coordinates differ in single bits
/// again and again, which must not cancel out when hashes are added up.
inline std::uint64_t hash_of(const Vec3& place) {
  std::uint64_t hash = 0;
  for (const double x : {place.x, place.y, place.z}) {
    hash += std::bit_cast<std::uint64_t>(x + 0.0);  // both zeros alike
    hash = (hash ^ hash >> 32) * 0x9E3779B97F4A7C15u;
    hash = (hash ^ hash >> 29) * 0xBF58476D1CE4E5B9u;
    hash ^= hash >> 32;
  }
  return hash;
}

class PlaceSet {
 public:
  bool empty() const { return places_.empty(); }
  void add(const Vec3& place) {
    if (2 * (places_.size() + 1) > table_.size()) grow();
    std::uint32_t& at = table_[find(place)];
    if (at != none) return;
    at = static_cast<std::uint32_t>(places_.size());
    places_.push_back(place);
  }
  bool has(const Vec3& place) const { return !empty() && table_[find(place)] != none; }

 private:
  static constexpr std::uint32_t none = 0xFFFFFFFFu;

  // Where it is in the table, or may be put.
  std::size_t find(const Vec3& place) const {
    const std::size_t mask = table_.size() - 1;
    std::size_t at = hash_of(place) & mask;
    while (table_[at] != none && !(places_[table_[at]] == place)) at = (at + 1) & mask;
    return at;
  }
  void grow() {
    table_.assign(table_.empty() ? 64 : 2 * table_.size(), none);
    for (std::uint32_t i = 0; i < places_.size(); ++i) table_[find(places_[i])] = i;
  }

  std::vector<Vec3> places_;
  std::vector<std::uint32_t> table_;  // its size is a power of two
};

}  // namespace sectile
