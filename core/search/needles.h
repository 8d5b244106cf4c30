// Needles: faces that are long and thin, and slanted, so that their boxes are mostly empty.
#pragma once

#include <cmath>

#include "search/approximate.h"
#include "search/box.h"

namespace sectile {

/// Collects the corners of a face, in their order.
class Needle {
 public:
  void add(const Vec3& p) {
    using namespace approximate;
    bounds_.add(p);
    if (corner_ == 0) first_ = p;
    if (corner_ > 1) {
      const Vec3 normal = cross(last_ - first_, p - first_);
      area_ += std::sqrt(dot(normal, normal));
    }
    last_ = p;
    ++corner_;
  }
  /// Is half the surface of the face's box much more than twice the area of the face?
  bool is_slanted() const {
    using namespace approximate;
    const Vec3 size = bounds_.high - bounds_.low;
    return size.x * size.y + size.y * size.z + size.z * size.x > slanted * area_;
  }

 private:
  // Triangles of good shape reach 8 where they lie slanted, needles their ratio of length to width.
  static constexpr double slanted = 16;

  Vec3 first_, last_;
  Bounds bounds_;
  double area_ = 0;
  int corner_ = 0;
};

/// Are more than a quarter of the faces such? for_each_corner(face, add) calls add(place).
template <class ForEachCorner>
bool has_slanted_needles(std::size_t faces, const ForEachCorner& for_each_corner) {
  std::size_t needles = 0;
  for (std::size_t f = 0; f < faces; ++f) {
    Needle needle;
    for_each_corner(static_cast<std::uint32_t>(f), [&](const Vec3& p) { needle.add(p); });
    if (needle.is_slanted()) ++needles;
  }
  return 4 * needles > faces;
}

}  // namespace sectile
