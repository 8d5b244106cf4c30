// What the triangulation asks, answered for points seen along an axis.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "geometry/axes.h"
#include "geometry/kernel.h"

namespace sectile {

class FacePredicates {
 public:
  /// Seen against the axis, or along it (from behind).
  FacePredicates(const Kernel& kernel, int axis, bool behind, std::span<const PointId> corners)
      : kernel_(kernel),
        axis_(axis),
        u_((axis + (behind ? 2 : 1)) % 3),
        v_((axis + (behind ? 1 : 2)) % 3),
        behind_(behind),
        corners_(corners) {}

  Sign compare(std::uint32_t i, std::uint32_t j) const {
    const Sign first = kernel_.compare(corners_[i], corners_[j], u_);
    return first != Sign::zero ? first : kernel_.compare(corners_[i], corners_[j], v_);
  }
  Sign turn(std::uint32_t i, std::uint32_t j, std::uint32_t k) const {
    const Sign sign = kernel_.turn(corners_[i], corners_[j], corners_[k], axis_);
    return behind_ ? -sign : sign;
  }
  /// Zero if doubles do not tell.
  Sign clear_turn(std::uint32_t i, std::uint32_t j, std::uint32_t k) const {
    const Geometry& g = kernel_.geometry();
    const PointId p = corners_[i], q = corners_[j], r = corners_[k];
    const Estimate turn =
        Kernel::estimated_turn(g.position(p), g.position(q), g.position(r), axis_,
                               g.is_explicit(p) && g.is_explicit(q) && g.is_explicit(r));
    if (!turn.decided()) return Sign::zero;
    return behind_ ? -turn.sign() : turn.sign();
  }
  /// About where a corner is seen.
  std::array<double, 2> seen(std::uint32_t i) const {
    const Vec3& p = kernel_.geometry().position(corners_[i]);
    return {component(p, u_), component(p, v_)};
  }

 private:
  const Kernel& kernel_;
  int axis_, u_, v_;
  bool behind_;
  std::span<const PointId> corners_;
};

}  // namespace sectile
