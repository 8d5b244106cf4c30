#include "selftest/triangle_pair.h"

#include "geometry/four_points.h"
#include "selftest/triangle_chord.h"
#include "selftest/wedge_order.h"

namespace sectile {
namespace {

Vec3 half_way(const Vec3& p, const Vec3& q) {
  return {p.x / 2 + q.x / 2, p.y / 2 + q.y / 2, p.z / 2 + q.z / 2};
}

// Is the triangle, whose corners lie on these sides of a plane, on one side of it, but for a point?
bool on_one_side(const std::array<Sign, 3>& s) {
  if (s[0] == s[1]) return s[0] != Sign::zero && s[2] != -s[0];
  if (s[1] == s[2]) return s[1] != Sign::zero && s[0] == Sign::zero;
  return s[0] == s[2] && s[0] != Sign::zero && s[1] == Sign::zero;
}

bool all_zero(const std::array<Sign, 3>& s) {
  return s[0] == Sign::zero && s[1] == Sign::zero && s[2] == Sign::zero;
}

}  // namespace

std::optional<SelfContact> TrianglePairs::test(std::uint32_t s, std::uint32_t t) const {
  if (surface_.untested(s, t)) return {};
  const auto &a = surface_.corners[s], &b = surface_.corners[t];
  std::array<int, 3> shared{-1, -1, -1};  // per corner of t: the one of s
  std::array<bool, 3> in_t{false, false, false};
  int count = 0;
  for (std::size_t j = 0; j < 3; ++j)
    for (std::size_t i = 0; i < 3; ++i)
      if (a[i] == b[j]) {
        shared[j] = static_cast<int>(i);
        in_t[i] = true;
        ++count;
      }
  if (count >= 2) return test_edge(s, t, shared);
  const std::array<bool, 3> in_s{shared[0] >= 0, shared[1] >= 0, shared[2] >= 0};
  // Most pairs are apart by one of the two planes, which doubles can tell.
  if (clearly_on_one_side(t, in_s, surface_.plane[s]) ||
      clearly_on_one_side(s, in_t, surface_.plane[t]))
    return {};
  Signs sides_t, sides_s;
  for (std::size_t j = 0; j < 3; ++j)
    sides_t[j] = shared[j] >= 0 ? Sign::zero : kernel_.side(b[j], surface_.plane[s]);
  if (on_one_side(sides_t)) return {};
  if (all_zero(sides_t)) return test_plane(s, t);
  for (std::size_t i = 0; i < 3; ++i)
    sides_s[i] = in_t[i] ? Sign::zero : kernel_.side(a[i], surface_.plane[t]);
  if (on_one_side(sides_s)) return {};
  return test_chords(s, sides_s, t, sides_t);
}

bool TrianglePairs::clearly_on_one_side(std::uint32_t t, const std::array<bool, 3>& on_it,
                                        PlaneId plane) const {
  Sign side = Sign::zero;
  for (std::size_t k = 0; k < 3; ++k) {
    if (on_it[k]) continue;
    const Estimate value = kernel_.estimate(surface_.corners[t][k], plane);
    if (!value.decided() || (side != Sign::zero && side != value.sign())) return false;
    side = value.sign();
  }
  return true;
}

// Neighbours are nearly in one plane, as a rule: doubles tell that from their differences.
bool TrianglePairs::is_on_plane(PointId point, PlaneId plane) const {
  return !clearly_off_plane(kernel_.geometry(), point, plane) &&
         kernel_.side(point, plane) == Sign::zero;
}

std::optional<SelfContact> TrianglePairs::test_edge(std::uint32_t s, std::uint32_t t,
                                                    const std::array<int, 3>& shared) const {
  std::size_t single = 3;
  for (std::size_t j = 0; j < 3; ++j)
    if (shared[j] < 0) single = j;
  if (single == 3 || is_on_plane(surface_.corners[t][single], surface_.plane[s]))
    return test_plane(s, t);
  const int edge_t = static_cast<int>(single < 2 ? single + 1 : 0);
  // The corner of s that t lacks is 3 less the two others.
  const int i = shared[single < 2 ? single + 1 : 0], j = shared[single > 0 ? single - 1 : 2];
  const int lacking = 3 - i - j, edge_s = lacking < 2 ? lacking + 1 : 0;
  if (surface_.neighbour(s, edge_s) == t) return {};
  const int axis = kernel_.cross_axis(surface_.plane[s], surface_.plane[t]);
  if (alternates(s, edge_s, t, edge_t, axis)) return {};
  const Geometry& g = kernel_.geometry();
  const auto& a = surface_.corners[s];
  return contact(s, t, SelfContact::Kind::wedges,
                 half_way(g.position(a[static_cast<std::size_t>(i)]),
                          g.position(a[static_cast<std::size_t>(j)])));
}

std::optional<SelfContact> TrianglePairs::test_plane(std::uint32_t s, std::uint32_t t) const {
  const int axis = kernel_.main_axis(surface_.plane[s]);
  if (separates(s, t, axis) || separates(t, s, axis)) return {};
  const auto &a = surface_.corners[s], &b = surface_.corners[t];
  // The middle of the smaller one is in the overlap, or near it.
  const auto extent = [&](const std::array<PointId, 3>& corners) {
    Vec3 low = kernel_.geometry().position(corners[0]), high = low;
    for (const PointId p : corners) {
      const Vec3& v = kernel_.geometry().position(p);
      low = {std::min(low.x, v.x), std::min(low.y, v.y), std::min(low.z, v.z)};
      high = {std::max(high.x, v.x), std::max(high.y, v.y), std::max(high.z, v.z)};
    }
    return (high.x - low.x) + (high.y - low.y) + (high.z - low.z);
  };
  return contact(s, t, SelfContact::Kind::overlap, middle(extent(a) < extent(b) ? s : t));
}

// Is t on the right side of an edge of s, or on it?
bool TrianglePairs::separates(std::uint32_t s, std::uint32_t t, int axis) const {
  const auto &a = surface_.corners[s], &b = surface_.corners[t];
  const Sign left = kernel_.normal(surface_.plane[s], axis);
  for (std::size_t k = 0; k < 3; ++k) {
    const PointId from = a[k], to = a[k < 2 ? k + 1 : 0];
    bool apart = true;
    for (std::size_t j = 0; j < 3 && apart; ++j)
      apart = b[j] == from || b[j] == to || kernel_.turn(from, to, b[j], axis) != left;
    if (apart) return true;
  }
  return false;
}

std::optional<SelfContact> TrianglePairs::test_chords(std::uint32_t s, const Signs& sides_s,
                                                      std::uint32_t t, const Signs& sides_t) const {
  const PlaneId plane_s = surface_.plane[s], plane_t = surface_.plane[t];
  const int axis = kernel_.cross_axis(plane_s, plane_t);
  const ChordFinder finder(kernel_, axis);
  const Chord a = finder.find(surface_.corners[s], sides_s, plane_t);
  const Chord b = finder.find(surface_.corners[t], sides_t, plane_s);
  if (!finder.overlap(a, b)) return {};
  if ((a.edge >= 0 || b.edge >= 0) && alternates(s, a.edge, t, b.edge, axis)) return {};
  const auto later = [&](const ChordEnd& p, const ChordEnd& q) {
    return finder.compare(p, q) == Sign::positive ? q.near : p.near;
  };
  const auto earlier = [&](const ChordEnd& p, const ChordEnd& q) {
    return finder.compare(p, q) == Sign::positive ? p.near : q.near;
  };
  return contact(
      s, t, a.edge >= 0 && b.edge >= 0 ? SelfContact::Kind::wedges : SelfContact::Kind::crossing,
      half_way(later(a.ends[0], b.ends[0]), earlier(a.ends[1], b.ends[1])));
}

// Along a line on which both have an edge, or one of them (the other one's edge is -1).
bool TrianglePairs::alternates(std::uint32_t s, int edge_s, std::uint32_t t, int edge_t,
                               int axis) const {
  const std::uint32_t across_s = edge_s < 0 ? s : surface_.neighbour(s, edge_s),
                      across_t = edge_t < 0 ? t : surface_.neighbour(t, edge_t);
  // Two parts of one edge.
  if (surface_.face[across_s] == surface_.face[t] && surface_.face[across_t] == surface_.face[s])
    return true;
  const bool up_s = edge_s < 0 || forward(s, edge_s, axis),
             up_t = edge_t < 0 || forward(t, edge_t, axis);
  SideOfLine sides[] = {{surface_.plane[s], up_s},
                        {surface_.plane[across_s], !up_s},
                        {surface_.plane[t], up_t},
                        {surface_.plane[across_t], !up_t}};
  return sort_around(kernel_, axis, sides);
}

bool TrianglePairs::forward(std::uint32_t t, int edge, int axis) const {
  const auto& corners = surface_.corners[t];
  return kernel_.compare(corners[static_cast<std::size_t>(edge)],
                         corners[static_cast<std::size_t>(edge < 2 ? edge + 1 : 0)],
                         axis) == Sign::positive;
}

SelfContact TrianglePairs::contact(std::uint32_t s, std::uint32_t t, SelfContact::Kind kind,
                                   const Vec3& where) const {
  return {s, t, kind, where};
}

Vec3 TrianglePairs::middle(std::uint32_t t) const {
  const Geometry& g = kernel_.geometry();
  const auto& corners = surface_.corners[t];
  const Vec3 &p = g.position(corners[0]), &q = g.position(corners[1]), &r = g.position(corners[2]);
  return {p.x / 3 + q.x / 3 + r.x / 3, p.y / 3 + q.y / 3 + r.y / 3, p.z / 3 + q.z / 3 + r.z / 3};
}

}  // namespace sectile
