// Axis-parallel boxes in floats, rounded outwards: whatever overlaps exactly overlaps here.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>

#include "sectile/mesh.h"

namespace sectile {

/// The largest float that is not above a value. Half of all values round up, and no processor
/// foretells which: the step to the next float below is a sum of bits. Zero has the sign of what it
/// was rounded from.
inline float round_down(double value) {
  const auto nearest = static_cast<float>(value);
  const auto bits = std::bit_cast<std::uint32_t>(nearest);
  const std::uint32_t step = static_cast<double>(nearest) > value ? 1 : 0;
  return std::bit_cast<float>(bits >> 31 ? bits + step : bits - step);
}
inline float round_up(double value) {
  return -round_down(-value);
}

struct Box {
  float low[3] = {std::numeric_limits<float>::infinity(), std::numeric_limits<float>::infinity(),
                  std::numeric_limits<float>::infinity()};
  float high[3] = {-std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity(),
                   -std::numeric_limits<float>::infinity()};

  static Box everything() {
    constexpr float all = std::numeric_limits<float>::infinity();
    return {{-all, -all, -all}, {all, all, all}};
  }

  void add(const Box& other) {
    for (int k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], other.low[k]);
      high[k] = std::max(high[k], other.high[k]);
    }
  }
  bool overlaps(const Box& other) const {
    // Not a chain of &&: which comparison fails cannot be foretold.
    bool all = true;
    for (int k = 0; k < 3; ++k) all = all & (low[k] <= other.high[k]) & (other.low[k] <= high[k]);
    return all;
  }
  bool contains(const Box& other) const {
    bool all = true;
    for (int k = 0; k < 3; ++k) all = all & (low[k] <= other.low[k]) & (other.high[k] <= high[k]);
    return all;
  }
  /// In the sum of the three edges.
  bool is_larger_than(const Box& other) const {
    return (high[0] - low[0]) + (high[1] - low[1]) + (high[2] - low[2]) >
           (other.high[0] - other.low[0]) + (other.high[1] - other.low[1]) +
               (other.high[2] - other.low[2]);
  }
  bool contains(const Vec3& p) const {
    return low[0] <= p.x && p.x <= high[0] && low[1] <= p.y && p.y <= high[1] && low[2] <= p.z &&
           p.z <= high[2];
  }
};

/// Collects points in doubles; the rounding to floats happens once.
struct Bounds {
  Vec3 low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
           std::numeric_limits<double>::infinity()};
  Vec3 high{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
            -std::numeric_limits<double>::infinity()};

  void add(const Vec3& p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  bool contains(const Vec3& p) const {
    return low.x <= p.x && p.x <= high.x && low.y <= p.y && p.y <= high.y && low.z <= p.z &&
           p.z <= high.z;
  }
  Box box() const {
    Box result;
    result.low[0] = round_down(low.x);
    result.low[1] = round_down(low.y);
    result.low[2] = round_down(low.z);
    result.high[0] = round_up(high.x);
    result.high[1] = round_up(high.y);
    result.high[2] = round_up(high.z);
    return result;
  }
};

inline Box box_around(const Vec3& p, const Vec3& q) {
  Bounds bounds;
  bounds.add(p);
  bounds.add(q);
  return bounds.box();
}

}  // namespace sectile
