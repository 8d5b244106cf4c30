// Triangles of a loop with few corners.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "numbers/sign.h"

namespace sectile {

template <class Predicates>
class EarClipping {
 public:
  using Triangles = std::vector<std::array<std::uint32_t, 3>>;
  static constexpr std::uint32_t most_corners = 12;

  /// For the loop of the corners 0 to corners - 1.
  EarClipping(const Predicates& exact, std::uint32_t corners) : exact_(exact), size_(corners) {
    for (std::uint32_t i = 0; i < size_; ++i) ring_[i] = i;
    for (std::uint32_t i = 0; i < size_; ++i) {
      update_turn(i);
      convex_ = convex_ && turn_[i] == Sign::positive;
    }
  }

  /// Cuts ears one by one; false, with nothing added, if only ears remain that a corner touches.
  bool run(Triangles& triangles) {
    const std::size_t before = triangles.size();
    // After an ear its neighbour is left out, so that a convex loop is not cut into a fan.
    for (std::uint32_t from = 0; size_ > 3;) {
      const std::uint32_t ear = find_ear(from);
      if (ear == size_) {
        triangles.resize(before);
        return false;
      }
      triangles.push_back({ring_[before_of(ear)], ring_[ear], ring_[after(ear)]});
      from = cut(ear);
    }
    if (turn_[0] != Sign::positive) {
      triangles.resize(before);
      return false;
    }
    triangles.push_back({ring_[0], ring_[1], ring_[2]});
    return true;
  }

 private:
  std::uint32_t after(std::uint32_t i) const { return i + 1 == size_ ? 0 : i + 1; }
  std::uint32_t before_of(std::uint32_t i) const { return i == 0 ? size_ - 1 : i - 1; }

  void update_turn(std::uint32_t i) {
    turn_[i] = exact_.turn(ring_[before_of(i)], ring_[i], ring_[after(i)]);
  }

  std::uint32_t find_ear(std::uint32_t from) const {
    for (std::uint32_t k = 0, i = from; k < size_; ++k, i = after(i)) {
      if (turn_[i] == Sign::positive && is_free(i)) return i;
    }
    return size_;
  }

  /// No other corner lies in the triangle or on its border. What reaches into a triangle without
  /// crossing the two edges of the ear does so with a corner of 180° or more.
  bool is_free(std::uint32_t ear) const {
    const std::uint32_t a = before_of(ear), c = after(ear);
    if (convex_) return true;
    for (std::uint32_t i = after(c); i != a; i = after(i)) {
      if (turn_[i] != Sign::positive && !is_outside(ring_[i], ring_[a], ring_[ear], ring_[c])) {
        return false;
      }
    }
    return true;
  }
  bool is_outside(std::uint32_t q, std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    return exact_.turn(c, a, q) == Sign::negative || exact_.turn(a, b, q) == Sign::negative ||
           exact_.turn(b, c, q) == Sign::negative;
  }

  /// Returns where to look for the next ear.
  std::uint32_t cut(std::uint32_t ear) {
    std::copy(ring_.begin() + ear + 1, ring_.begin() + size_, ring_.begin() + ear);
    std::copy(turn_.begin() + ear + 1, turn_.begin() + size_, turn_.begin() + ear);
    --size_;
    const std::uint32_t next = ear == size_ ? 0 : ear;
    if (!convex_) {  // else it stays so
      update_turn(before_of(next));
      update_turn(next);
    }
    return after(next);
  }

  const Predicates& exact_;
  std::uint32_t size_;
  bool convex_ = true;
  std::array<std::uint32_t, most_corners> ring_;
  std::array<Sign, most_corners> turn_;
};

}  // namespace sectile
