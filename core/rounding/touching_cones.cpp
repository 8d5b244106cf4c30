#include "rounding/touching_cones.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_set>

#include "numbers/threshold.h"
#include "rounding/triangle_corners.h"

namespace sectile {
namespace {

// Each cone is compared with all fans of its site that have none.
constexpr std::size_t most_others = threshold(8, 1);
// Of a fan, so many planes are looked at.
constexpr std::size_t most_bounds = 64;
// What hangs on a fan is looked for among so many triangles.
constexpr std::size_t most_hanging = 64;

}  // namespace

// Within half of space, the material inside of a fan has no other fan in it, but for such as have
// the outside of more than half of space around them, and others within these: there would have to
// be outside between.
void TouchingCones::add_place(std::span<const Corner> corners) {
  std::vector<Fan> fans;
  std::vector<Bounds> bounds;
  std::array<std::size_t, 2> count{0, 0};
  for (const Corner& corner : corners) {
    fans.push_back(fan_at(corner));
    bounds.push_back(bounds_of(fans.back(), rounded_.corners[corner.triangle][corner.k]));
    for (std::size_t i = 0; i < 2; ++i) count[i] += bounds.back()[i].empty() ? 0 : 1;
  }
  const std::size_t kind = count[1] > count[0] ? 1 : 0;
  if (count[kind] < 2 || fans.size() - count[kind] > most_others) return;
  Site site;
  site.inside = kind == 0 ? Sign::negative : Sign::positive;
  std::vector<Fan> others;
  for (std::size_t i = 0; i < fans.size(); ++i)
    if (bounds[i][kind].empty()) others.push_back(fans[i]);
  const auto index = static_cast<std::uint32_t>(sites_.size());
  for (std::size_t i = 0; i < fans.size(); ++i) {
    const std::vector<PlaneId>& planes = bounds[i][kind];
    if (planes.empty() || std::any_of(others.begin(), others.end(), [&](const Fan& other) {
          return contain(planes, site.inside, other);
        }))
      continue;
    cone_at_[rounded_.corners[corners[i].triangle][corners[i].k]] = {
        index, static_cast<std::uint32_t>(site.cones.size())};
    const bool is_convex = planes.size() == fans[i].size();
    site.cones.push_back(cone_of(std::move(fans[i])));
    if (!is_convex) site.cones.back().inner = point_amid(site.cones.back().fan, corners[i]);
  }
  sites_.push_back(std::move(site));
}

// As far from a corner as the nearest other one.
PointId TouchingCones::point_amid(const Fan& fan, Corner corner) {
  const std::uint32_t vertex = rounded_.corners[corner.triangle][corner.k];
  const Vec3 at = rounded_.position(vertex);
  Vec3 way{0, 0, 0};
  double nearest = std::numeric_limits<double>::infinity();
  for (const std::uint32_t t : fan) {
    const RoundedSurface::Corners& c = rounded_.corners[t];
    const Vec3& p = rounded_.position(c[next_corner(corner_at(c, vertex))]);
    const double away = std::hypot(p.x - at.x, p.y - at.y, p.z - at.z);
    way = {way.x + (p.x - at.x) / away, way.y + (p.y - at.y) / away, way.z + (p.z - at.z) / away};
    nearest = std::min(nearest, away);
  }
  const double far = nearest / static_cast<double>(fan.size());
  return rounded_.geometry.add_point({at.x + far * way.x, at.y + far * way.y, at.z + far * way.z});
}

std::vector<TouchingCones::Member> TouchingCones::add_edge(std::span<const Corner> wedges) {
  const EdgeSectors sectors = sectors_around(wedges);
  const std::span<const std::uint32_t> order = sectors.order();
  std::vector<Member> cones(wedges.size(), {none, none});
  if (order.empty()) return cones;
  const auto index = static_cast<std::uint32_t>(sites_.size());
  Site& site = sites_.emplace_back();
  site.wedges = order.size();
  const auto add = [&](const EdgeSectors::Sector& sector) {
    Cone& cone = site.cones.emplace_back();
    cone.planes = sector.planes;
    if (!cone.planes.empty()) cone.fan.assign(sector.faces.begin(), sector.faces.end());
  };
  for (std::uint32_t i = 0; i < order.size(); ++i) {
    add(sectors.of_wedge(i));
    if (!site.cones.back().planes.empty()) cones[order[i]] = {index, i};
  }
  for (std::uint32_t i = 0; i < order.size(); ++i) add(sectors.of_gap(i));
  return cones;
}

EdgeSectors TouchingCones::sectors_around(std::span<const Corner> wedges) {
  const auto side = [&](std::uint32_t t, std::size_t k) {
    return EdgeSectors::Side{t, rounded_.surface.plane[t],
                             rounded_.surface.corners[t][previous_corner(k)]};
  };
  std::vector<EdgeSectors::Wedge> sides;
  for (const auto& [t, k] : wedges) {
    const std::uint32_t mate = rounded_.surface.mate[t][k],
                        to = rounded_.corners[t][next_corner(k)];
    sides.push_back({side(t, k), side(mate, corner_at(rounded_.corners[mate], to))});
  }
  const auto& [t, k] = wedges.front();
  const auto& corners = rounded_.surface.corners[t];
  return {corners[k], corners[next_corner(k)], sides, rounded_.geometry, kernel_};
}

TouchingCones::Fan TouchingCones::fan_at(Corner corner) const {
  const std::uint32_t vertex = rounded_.corners[corner.triangle][corner.k];
  Fan fan;
  std::uint32_t t = corner.triangle;
  do {
    fan.push_back(t);
    t = rounded_.surface.mate[t][corner_at(rounded_.corners[t], vertex)];
  } while (t != corner.triangle);
  return fan;
}

// Planes of some of its triangles that have all of the fan on one side.
TouchingCones::Bounds TouchingCones::bounds_of(const Fan& fan, std::uint32_t vertex) const {
  Bounds bounds;
  for (std::size_t i = 0; i < std::min(fan.size(), most_bounds); ++i) {
    const PlaneId plane = rounded_.surface.plane[fan[i]];
    bool is_below = true, is_above = true;
    for (std::size_t j = 0; j < fan.size() && (is_below || is_above); ++j) {
      const std::size_t k = next_corner(corner_at(rounded_.corners[fan[j]], vertex));
      const Sign side = kernel_.side(rounded_.surface.corners[fan[j]][k], plane);
      is_below = is_below && side != Sign::positive;
      is_above = is_above && side != Sign::negative;
    }
    if (is_below) bounds[0].push_back(plane);
    if (is_above) bounds[1].push_back(plane);
  }
  return bounds;
}

TouchingCones::Cone TouchingCones::cone_of(Fan fan) const {
  Cone cone;
  for (const std::uint32_t t : fan) cone.planes.push_back(rounded_.surface.plane[t]);
  cone.fan = std::move(fan);
  return cone;
}

bool TouchingCones::contain(std::span<const PlaneId> planes, Sign inside, const Fan& fan) const {
  return std::all_of(fan.begin(), fan.end(), [&](std::uint32_t t) {
    const auto& corners = rounded_.surface.corners[t];
    return std::all_of(corners.begin(), corners.end(), [&](PointId p) {
      return std::all_of(planes.begin(), planes.end(),
                         [&](PlaneId plane) { return kernel_.side(p, plane) != -inside; });
    });
  });
}

bool TouchingCones::is_strictly_inside(PointId point, Member member) const {
  const Site& site = sites_[member.site];
  const std::vector<PlaneId>& planes = site.cones[member.cone].planes;
  return std::all_of(planes.begin(), planes.end(),
                     [&](PlaneId plane) { return kernel_.side(point, plane) == site.inside; });
}

// Those of edges first, and of these those of the fans: so these are at home there. Of a wall from
// place to place nearly all is in its sector.
void TouchingCones::find_members() {
  kernel_.refresh();
  if (empty()) return;
  memberships_.resize(rounded_.corners.size());
  for (const bool along_edges : {true, false}) {
    const auto for_each_cone = [&](const auto& visit) {
      for (std::uint32_t s = 0; s < sites_.size(); ++s)
        for (std::uint32_t c = 0; sites_[s].is_edge() == along_edges && c < sites_[s].cones.size();
             ++c)
          visit(Member{s, c});
    };
    for_each_cone([&](Member m) {
      for (const std::uint32_t t : sites_[m.site].cones[m.cone].fan) add_member(t, m);
    });
    for_each_cone([&](Member m) { find_members(m); });
  }
}

// What is on the inner sides of all planes is in the cone only if there is something strictly so.
void TouchingCones::find_members(Member member) {
  const Site& site = sites_[member.site];
  const Cone& cone = site.cones[member.cone];
  if (cone.inner.valid() && !is_strictly_inside(cone.inner, member)) return;
  std::vector<std::uint32_t> front = cone.fan;
  std::unordered_set<std::uint32_t> seen(front.begin(), front.end());
  const std::size_t most = front.size() + std::min(4 * front.size(), most_hanging);
  for (std::size_t i = 0; i < front.size() && front.size() < most; ++i)
    for (const std::uint32_t mate : rounded_.surface.mate[front[i]])
      if (seen.insert(mate).second && contain(cone.planes, site.inside, {mate})) {
        front.push_back(mate);
        add_member(mate, member);
      }
}

void TouchingCones::add_member(std::uint32_t triangle, Member member) {
  Memberships& memberships = memberships_[triangle];
  if (memberships.cones.empty()) {
    memberships.home = member;
    sites_[member.site].cones[member.cone].at_home.push_back(triangle);
  }
  memberships.cones.push_back(member);
}

void TouchingCones::divide(std::uint32_t triangle, std::uint32_t added) {
  if (empty()) return;
  const Memberships copy = memberships_[triangle];
  if (copy.home.site != none) sites_[copy.home.site].cones[copy.home.cone].at_home.push_back(added);
  memberships_.resize(added + 1);
  memberships_[added] = copy;
}

std::size_t TouchingCones::cones_beside(std::uint32_t vertex) const {
  const auto at = cone_at_.find(vertex);
  if (at == cone_at_.end()) return 0;
  const Site& site = sites_[at->second.site];
  return (site.is_edge() ? site.wedges : site.cones.size()) - 1;
}

bool TouchingCones::seems_inside(std::uint32_t vertex, Vec3 way) const {
  const Member own = cone_at_.at(vertex);
  const Site& site = sites_[own.site];
  const std::vector<PlaneId>& planes = site.cones[own.cone].planes;
  // Products with the least doubles would be zero.
  const double size = std::max({std::abs(way.x), std::abs(way.y), std::abs(way.z)});
  way = {way.x / size, way.y / size, way.z / size};
  return std::all_of(planes.begin(), planes.end(), [&](PlaneId plane) {
    const auto& n = kernel_.value(plane).n;
    return sign_of(n[0] * way.x + n[1] * way.y + n[2] * way.z) == site.inside;
  });
}

std::vector<Vec3> TouchingCones::inward(std::uint32_t vertex) const {
  const Member own = cone_at_.at(vertex);
  const Site& site = sites_[own.site];
  std::vector<Vec3> inward;
  for (const PlaneId plane : site.cones[own.cone].planes) {
    const auto& n = kernel_.value(plane).n;
    const double size = std::hypot(n[0], n[1], n[2]),
                 way = site.inside == Sign::positive ? 1 / size : -1 / size;
    inward.push_back({way * n[0], way * n[1], way * n[2]});
  }
  return inward;
}

// Members may touch along a line through the site, and the material must alternate around it: so an
// edge that stays on the boundary of the cone must be on such a line with a neighbour in the cone,
// and the wedge between them must be convex. An edge across the tip of a fan is on no such line.
void TouchingCones::note_move(std::uint32_t vertex, std::span<const std::uint32_t> star) {
  moving_.clear();
  has_moved_inside_ = false;
  if (empty()) return;
  const auto at = cone_at_.find(vertex);
  const Member own = at == cone_at_.end() ? Member{none, none} : at->second;
  has_moved_inside_ = own.site != none && is_strictly_inside(rounded_.point[vertex], own);
  std::vector<Member> inside, outside;
  const auto is_inside = [&](Member m) {
    if (m == own) return has_moved_inside_;
    if (std::find(inside.begin(), inside.end(), m) != inside.end()) return true;
    if (std::find(outside.begin(), outside.end(), m) != outside.end()) return false;
    const bool is = is_strictly_inside(rounded_.point[vertex], m);
    (is ? inside : outside).push_back(m);
    return is;
  };
  for (const std::uint32_t t : star) {
    const Memberships& known = memberships_[t];
    if (known.cones.empty()) continue;
    Memberships& left = moving_[t];
    for (const Member m : known.cones) {
      if (!is_inside(m) ||
          (m != own && !sites_[m.site].is_edge() && !bends_towards_mate(vertex, t, m)))
        continue;
      left.cones.push_back(m);
      if (m == known.home) left.home = m;
    }
  }
}

bool TouchingCones::is_member(std::uint32_t triangle, Member member) const {
  const std::vector<Member>& cones = memberships_[triangle].cones;
  return std::find(cones.begin(), cones.end(), member) != cones.end();
}

// Across the edge opposite to a vertex.
bool TouchingCones::bends_towards_mate(std::uint32_t vertex, std::uint32_t triangle,
                                       Member member) const {
  const std::size_t opposite = next_corner(corner_at(rounded_.corners[triangle], vertex));
  const std::uint32_t mate = rounded_.surface.mate[triangle][opposite];
  return !has_corner(rounded_.corners[mate], vertex) && is_member(mate, member) &&
         kernel_.side(rounded_.point[vertex], rounded_.surface.plane[mate]) ==
             sites_[member.site].inside;
}

void TouchingCones::keep_move() {
  for (auto& [t, left] : moving_) memberships_[t] = std::move(left);
  moving_.clear();
}

std::span<const TouchingCones::Member> TouchingCones::cones_around(std::uint32_t triangle) const {
  if (empty()) return {};
  if (!moving_.empty())
    if (const auto at = moving_.find(triangle); at != moving_.end()) return at->second.cones;
  return memberships_[triangle].cones;
}

bool TouchingCones::are_apart(std::span<const Member> cones, std::uint32_t triangle) const {
  if (cones.empty()) return false;
  const std::span<const Member> others = cones_around(triangle);
  return std::any_of(cones.begin(), cones.end(), [&](Member m) {
    return std::any_of(others.begin(), others.end(),
                       [&](Member n) { return m.site == n.site && are_apart(m, n); });
  });
}

bool TouchingCones::are_apart(Member a, Member b) const {
  const Site& site = sites_[a.site];
  return site.is_edge() ? EdgeSectors::are_apart(site.wedges, a.cone, b.cone) : a.cone != b.cone;
}

std::uint32_t TouchingCones::home(std::uint32_t triangle) const {
  if (empty()) return none;
  if (const auto at = moving_.find(triangle); at != moving_.end()) return at->second.home.site;
  return memberships_[triangle].home.site;
}

}  // namespace sectile
