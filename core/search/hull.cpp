#include "search/hull.h"

#include "numbers/rounding.h"
#include "search/approximate.h"
#include "search/face_corners.h"
#include "search/oriented_box.h"

namespace sectile {

using namespace approximate;

namespace {

bool is_along_an_axis(const Vec3& v) {
  return (v.x != 0) + (v.y != 0) + (v.z != 0) == 1;
}

}  // namespace

Hull::Hull(std::span<const Vec3> points) {
  if (points.size() <= few) {
    count_ = static_cast<std::uint32_t>(points.size());
    std::copy(points.begin(), points.end(), points_);
    normal_ = cross(points[2] - points[0], points.back() - points[1]);
    if (count_ == 3) normal_ = cross(points[1] - points[0], points[2] - points[0]);
  } else {
    const OrientedBox box(points);
    count_ = 8;
    for (unsigned i = 0; i < 8; ++i) {
      points_[i] = box.centre;
      for (unsigned k = 0; k < 3; ++k) {
        // The slack is one for each coordinate; the axes have right angles between them.
        const double by = box.extent[k] + 2 * box.slack;
        points_[i] = points_[i] + (i >> k & 1 ? by : -by) * box.axis[k];
      }
    }
    normal_ = box.axis[2];
  }
  for (std::size_t i = 0; i < count_; ++i)
    reach_ = {std::max(reach_.x, std::abs(points_[i].x)),
              std::max(reach_.y, std::abs(points_[i].y)),
              std::max(reach_.z, std::abs(points_[i].z))};
  along_normal_ = along(normal_);
  for (std::uint32_t i = 0; i < edge_count(); ++i) along_axes_ &= is_along_an_axis(edge(i));
}

Vec3 Hull::edge(std::uint32_t i) const {
  if (count_ > few) return points_[1u << i] - points_[0];
  return points_[i + 1 == count_ ? 0 : i + 1] - points_[i];
}

inline Hull::Range Hull::along(const Vec3& direction) const {
  Range range{dot(direction, points_[0]), 0};
  range.high = range.low;
  for (std::uint32_t i = 1; i < count_; ++i) {
    const double at = dot(direction, points_[i]);
    range.low = std::min(range.low, at);
    range.high = std::max(range.high, at);
  }
  return range;
}

// Any direction may be tried: what counts is only how well the products are known. Five roundings
// for each (three products, two sums), one for a point that is rounded itself, one for each of the
// comparisons below: less than 16 on both sides together. Where that is not finite, nothing is
// separated.
inline bool Hull::separated_along(const Vec3& direction, const Range& mine,
                                  const Hull& other) const {
  const double error = 16 * rounding::unit *
                           (std::abs(direction.x) * (reach_.x + other.reach_.x) +
                            std::abs(direction.y) * (reach_.y + other.reach_.y) +
                            std::abs(direction.z) * (reach_.z + other.reach_.z)) +
                       0x1p-900 * (1 + sum_norm(direction));
  const Range theirs = other.along(direction);
  return mine.high + error < theirs.low || theirs.high + error < mine.low;
}

// Nothing separates them then: the tests that follow would all fail.
bool Hull::has_corner_of(const Hull& other) const {
  if (count_ > few || other.count_ > few) return false;
  for (std::uint32_t i = 0; i < count_; ++i)
    for (std::uint32_t j = 0; j < other.count_; ++j)
      if (points_[i] == other.points_[j]) return true;
  return false;
}

// In one plane, lines separate.
bool Hull::separated_by_side(const Hull& other) const {
  for (std::uint32_t i = 0; i < edge_count(); ++i)
    if (separated_along(cross(normal_, edge(i)), other)) return true;
  return false;
}

bool apart(const Hull& a, const Hull& b) {
  if (a.along_axes_ && b.along_axes_) return false;  // as all that follows are axes
  if (a.separated_along(a.normal_, a.along_normal_, b) ||
      b.separated_along(b.normal_, b.along_normal_, a))
    return true;
  if (a.has_corner_of(b)) return false;
  for (std::uint32_t i = 0; i < a.edge_count(); ++i)
    for (std::uint32_t j = 0; j < b.edge_count(); ++j)
      if (a.separated_along(cross(a.edge(i), b.edge(j)), b)) return true;
  return a.separated_by_side(b) || b.separated_by_side(a);
}

Hull face_hull(const Brep& brep, const Geometry& geometry, FaceId face) {
  return with_outer_corners(brep, geometry, face,
                            [](std::span<const Vec3> corners) { return Hull(corners); });
}

}  // namespace sectile
