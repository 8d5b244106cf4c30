// A loop of few corners as doubles see it, along an axis: nearly all faces are cut up with nothing
// more.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "geometry/axes.h"
#include "geometry/ear_clipping.h"
#include "numbers/rounding.h"
#include "numbers/sign.h"

namespace sectile {

class SeenLoop {
 public:
  static constexpr std::uint32_t most_corners = EarClipping<SeenLoop>::most_corners;

  /// Seen against the axis, or along it (from behind).
  SeenLoop(int axis, bool behind)
      : u_(behind ? next_next_axis(axis) : next_axis(axis)),
        v_(behind ? next_axis(axis) : next_next_axis(axis)) {}

  /// The next corner, by its rounded place.
  void add(const Vec3& p) {
    at_[size_] = {component(p, u_), component(p, v_)};
    largest_u_ = std::max(largest_u_, std::abs(at_[size_][0]));
    largest_v_ = std::max(largest_v_, std::abs(at_[size_][1]));
    ++size_;
  }

  /// Positive if the path i, j, k certainly turns left; zero if doubles do not tell.
  Sign turn(std::uint32_t i, std::uint32_t j, std::uint32_t k) const {
    const auto [au, av] = at_[i];
    const double bu = at_[j][0] - au, bv = at_[j][1] - av, cu = at_[k][0] - au, cv = at_[k][1] - av;
    const double left = bu * cv, right = bv * cu, turn = left - right;
    // As Kernel::estimated_turn has it, with the largest coordinates for all.
    const double off_u = off(largest_u_), off_v = off(largest_v_);
    const double error = 8 * rounding::unit * (std::abs(left) + std::abs(right)) +
                         8 * rounding::underflow +
                         2 * (off_u * (std::abs(cv) + std::abs(bv) + off_v) +
                              off_v * (std::abs(bu) + std::abs(cu) + off_u));
    return turn > error ? Sign::positive : -turn > error ? Sign::negative : Sign::zero;
  }
  /// About where a corner is seen.
  std::array<double, 2> seen(std::uint32_t i) const { return at_[i]; }

 private:
  static double off(double largest) {
    return 12 * rounding::unit * largest + 4 * rounding::underflow;
  }

  int u_, v_;
  std::uint32_t size_ = 0;
  double largest_u_ = 0, largest_v_ = 0;
  std::array<std::array<double, 2>, most_corners> at_;
};

}  // namespace sectile
