// Where a ray in direction +x meets something, as far as doubles tell.
#pragma once

#include <optional>

#include "geometry/plane_value.h"
#include "numbers/sign.h"
#include "search/oriented_box.h"

namespace sectile {

class XRayBounds {
 public:
  /// The start is known up to half an ulp in each coordinate.
  explicit XRayBounds(const Vec3& start) : start_(start) {}
  const Vec3& start() const { return start_; }

  /// What is in a box is met at no smaller x; infinity if it certainly is not met.
  double begin(const Box& box) const;
  double begin(const OrientedBox& box) const;

  /// A part of the ray's line.
  struct Stretch {
    double from, to;
    bool is_before(double x) const { return to < x; }
  };
  /// On which the line meets a plane; all of it where they are nearly parallel.
  Stretch meeting(const PlaneValue& plane) const;

 private:
  Vec3 start_;
  mutable std::optional<double> slack_;  // of tests with oriented boxes, if there were any
};

/// That of the first component of a plane's normal; zero if doubles do not tell.
Sign x_of_normal(const PlaneValue& plane);

}  // namespace sectile
