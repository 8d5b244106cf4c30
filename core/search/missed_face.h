// Does a line along the x axis go through a face, as far as doubles tell?
#pragma once

#include <optional>

#include "geometry/kernel.h"
#include "geometry/x_ray.h"
#include "topology/brep.h"

namespace sectile {

/// Nothing if that is not certain. The line goes through a point that is known, as the corners are,
/// up to half an ulp in each coordinate.
inline std::optional<bool> goes_through(const Brep& brep, const Geometry& geometry, FaceId face,
                                        const Vec3& p) {
  const auto at = [&](VertexId v) -> const Vec3& { return geometry.position(brep.point_of(v)); };
  XRayParity parity;
  bool certain = true;
  for_each_in_face(brep, face, [&](HalfEdgeId h) {
    const Vec3 &u = at(brep.from(h)), &v = at(brep.to(h));
    certain = certain && u.y != p.y;  // rounding to nearest is monotonic
    parity.add(u.y > p.y, v.y > p.y, [&] {
      const Estimate turn = Kernel::estimated_turn(u, v, p, 0, false);
      certain = certain && turn.decided();
      return turn.sign();
    });
  });
  if (!certain) return {};
  return parity.odd();
}

/// Does it certainly miss the face?
inline bool is_missed(const Brep& brep, const Geometry& geometry, FaceId face, const Vec3& p) {
  return goes_through(brep, geometry, face, p) == false;
}

}  // namespace sectile
