// How far the corners of a mesh are from the solid's.
#pragma once

#include <array>
#include <map>

#include "sectile/rounding.h"

namespace sectile {

/// Bounds for the places of a surface that was made by moving the solid's corners.
class Displacement {
 public:
  /// A corner came to a place.
  void add(const Vec3& place, double distance) {
    double& at = distance_[{place.x, place.y, place.z}];
    at = std::max(at, distance);
    if (distance <= largest_) return;
    largest_ = distance;
    largest_at_ = place;
  }
  /// Where no corner came to, moved faces cross: no point of a face moved farther than its corners.
  double at(const Vec3& place) const {
    const auto known = distance_.find({place.x, place.y, place.z});
    return known == distance_.end() ? largest_ : known->second;
  }
  double largest() const { return largest_; }
  const Vec3& largest_at() const { return largest_at_; }

 private:
  std::map<std::array<double, 3>, double> distance_;
  double largest_ = 0;
  Vec3 largest_at_;
};

}  // namespace sectile
