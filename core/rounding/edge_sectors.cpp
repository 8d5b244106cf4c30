#include "rounding/edge_sectors.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "search/approximate.h"
#include "selftest/wedge_order.h"

namespace sectile {
namespace {

using namespace approximate;

Vec3 of_length_one(const Vec3& a) {
  return 1 / length(a) * a;
}

bool is_finite(const Vec3& a) {
  return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

// Halfway from one direction to another one, counter-clockwise around an axis, seen against it. All
// are of length 1, and both directions across the axis.
Vec3 halfway(const Vec3& first, const Vec3& last, const Vec3& axis) {
  if (dot(first, last) < 0) return cross(last - first, axis);
  return dot(cross(first, last), axis) < 0 ? -1 * (first + last) : first + last;
}

}  // namespace

EdgeSectors::EdgeSectors(PointId from, PointId to, std::span<const Wedge> wedges,
                         Geometry& geometry, Kernel& kernel)
    : geometry_(geometry), kernel_(kernel), from_(from), to_(to) {
  if (!sort(wedges)) {
    order_.clear();
    return;
  }
  find_rays();
  for (std::size_t i = 0; i < order_.size(); ++i) {
    const auto& [left, right] = wedges_[i];
    of_wedges_.push_back(sector(in_gap_[before(i)], in_gap_[i], right, left));
    of_gaps_.push_back(sector(in_wedge_[i], in_wedge_[after(i)], left, wedges_[after(i)].right));
  }
}

// As they come around the edge, wedges and gaps in turn, neighbours may overlap.
bool EdgeSectors::are_apart(std::size_t n, std::size_t a, std::size_t b) {
  const auto place = [&](std::size_t i) { return i < n ? 2 * i : 2 * (i - n) + 1; };
  const std::size_t from = place(a), to = place(b), between = from < to ? to - from : from - to;
  return between > 1 && between < 2 * n - 1;
}

// Material lies between a backward side, the right one, and the forward one that follows.
bool EdgeSectors::sort(std::span<const Wedge> wedges) {
  int axis = 0;
  Sign way = Sign::zero;
  for (int k = 0; k < 3 && way == Sign::zero; ++k) {
    axis = k;
    way = kernel_.compare(from_, to_, k);
  }
  if (way == Sign::zero) return false;
  const bool up = way == Sign::positive;
  if (!up) std::swap(from_, to_);
  const auto left = [&](std::uint32_t i) { return up ? wedges[i].left : wedges[i].right; };
  const auto right = [&](std::uint32_t i) { return up ? wedges[i].right : wedges[i].left; };
  std::vector<SideOfLine> sides;
  for (std::uint32_t i = 0; i < wedges.size(); ++i) {
    sides.push_back({right(i).plane, false, i});
    sides.push_back({left(i).plane, true, i});
  }
  if (!sort_around(kernel_, axis, sides)) return false;
  const std::size_t first = sides[0].forward ? 1 : 0;
  for (std::size_t i = first; i < first + sides.size(); i += 2) {
    const std::uint32_t wedge = sides[i].number;
    if (sides[(i + 1) % sides.size()].number != wedge) return false;
    order_.push_back(wedge);
    wedges_.push_back({left(wedge), right(wedge)});
  }
  return true;
}

void EdgeSectors::find_rays() {
  for (std::size_t i = 0; i < order_.size(); ++i) {
    const auto add = [&](std::vector<PointId>& rays, const Side& first, const Side& last) {
      const Vec3 place = place_amid(first, last);
      rays.push_back(is_finite(place) ? geometry_.add_point(place) : PointId());
    };
    add(in_wedge_, wedges_[i].right, wedges_[i].left);
    add(in_gap_, wedges_[i].left, wedges_[after(i)].right);
  }
  kernel_.refresh();
  const auto keep_if = [&](PointId& ray, Sign side, const Side& first, const Side& last) {
    if (ray.valid() &&
        (kernel_.side(ray, first.plane) != side || kernel_.side(ray, last.plane) != side))
      ray = PointId();
  };
  for (std::size_t i = 0; i < order_.size(); ++i) {
    keep_if(in_wedge_[i], Sign::negative, wedges_[i].right, wedges_[i].left);
    keep_if(in_gap_[i], Sign::positive, wedges_[i].left, wedges_[after(i)].right);
  }
}

// As far from the edge as the farther one of the corners, lest rounding turns it much.
Vec3 EdgeSectors::place_amid(const Side& first, const Side& last) const {
  const Vec3 &at = geometry_.position(from_), axis = of_length_one(geometry_.position(to_) - at);
  const auto across = [&](PointId point) {
    const Vec3 way = geometry_.position(point) - at;
    return way - dot(way, axis) * axis;
  };
  const Vec3 a = across(first.beside), b = across(last.beside);
  const Vec3 way = halfway(of_length_one(a), of_length_one(b), axis);
  return at + std::max(length(a), length(b)) * of_length_one(way);
}

// From a point in the neighbour before it to one in that after it, or from its own faces.
EdgeSectors::Sector EdgeSectors::sector(PointId first, PointId last, const Side& first_side,
                                        const Side& last_side) {
  Sector sector{planes_between(first.valid() ? first : first_side.beside,
                               last.valid() ? last : last_side.beside),
                {first_side.face, last_side.face}};
  if (sector.planes.empty()) sector.planes = planes_between(first_side.beside, last_side.beside);
  return sector;
}

// Counter-clockwise from the half-plane with one point to that with another one, seen by one to
// whom the edge comes.
std::vector<PlaneId> EdgeSectors::planes_between(PointId first, PointId last) {
  const PlaneId above = geometry_.add_plane(PlaneDefinition::through(to_, from_, first)),
                below = geometry_.add_plane(PlaneDefinition::through(from_, to_, last));
  kernel_.refresh();
  if (kernel_.side(last, above) != Sign::negative || kernel_.side(first, below) != Sign::negative)
    return {};
  return {above, below};
}

}  // namespace sectile
