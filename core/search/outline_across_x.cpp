#include "search/outline_across_x.h"

#include "geometry/geometry.h"
#include "geometry/kernel.h"

namespace sectile {

OutlineAcrossX::Corners::Corners(const Brep& brep, const Geometry& geometry, FaceId face) {
  for (LoopId l = brep.outer_loop[face]; l.valid(); l = brep.next_loop[l]) {
    const auto first = static_cast<std::uint32_t>(at.size());
    for_each_in_loop(brep, l, [&](HalfEdgeId h) {
      at.push_back(geometry.position(brep.point_of(brep.from(h))));
      next.push_back(static_cast<std::uint32_t>(at.size()));
    });
    next.back() = first;
    loop_ends.push_back(static_cast<std::uint32_t>(at.size()));
  }
}

OutlineAcrossX::OutlineAcrossX(const Brep& brep, const Geometry& geometry, FaceId face)
    : corners_(brep, geometry, face), tree_(corners_.at, corners_.loop_ends, 0) {}

// Edges and stretches cross the ray in the direction of y if they have ends below and above it.
std::optional<bool> OutlineAcrossX::is_met(const Vec3& p) const {
  bool certain = true, odd = false;
  const auto straddles = [&](const Vec3& u, const Vec3& v) {
    certain = certain && u.z != p.z && v.z != p.z;  // rounding to nearest is monotonic
    return (u.z > p.z) != (v.z > p.z);
  };
  const auto look = [&](std::uint32_t edge) {
    const Vec3 &u = corners_.at[edge], &v = corners_.at[corners_.next[edge]];
    if (!straddles(u, v)) return;
    const Estimate turn = Kernel::estimated_turn(u, v, p, 0, false);
    certain = certain && turn.decided();
    // What runs upwards has what is before it along y on its left.
    if ((turn.sign() == Sign::positive) == (v.z > p.z)) odd = !odd;
  };
  const auto pass = [&](std::uint32_t from, std::uint32_t to) {
    if (straddles(corners_.at[from], corners_.at[to])) odd = !odd;
  };
  tree_.cast_ray({{p.y, p.z}, {p.y, p.z}}, look, pass);
  if (!certain) return {};
  return odd;
}

}  // namespace sectile
