#include "search/arc_partition.h"

#include <algorithm>
#include <cmath>

#include "numbers/rounding.h"
#include "numbers/threshold.h"
#include "search/approximate.h"
#include "search/box_tree.h"

namespace sectile {

using namespace approximate;

namespace {

using rounding::unit;

Vec3 on_cube(const Vec3& direction) {
  return (1 / max_norm(direction)) * direction;
}

// Where on the way from one direction to another one the cube may have edges.
std::vector<double> bends(const Vec3& from, const Vec3& to) {
  std::vector<double> bends;
  const auto add = [&](double start, double end) {
    const double share = start / (start - end);
    if (share > 0 && share < 1) bends.push_back(share);
  };
  add(from.x - from.y, to.x - to.y);
  add(from.x + from.y, to.x + to.y);
  add(from.y - from.z, to.y - to.z);
  add(from.y + from.z, to.y + to.z);
  add(from.z - from.x, to.z - to.x);
  add(from.z + from.x, to.z + to.x);
  std::ranges::sort(bends);
  return bends;
}

// The radius is greater than what is rounded here.
Box box_around(const SpacePartition::Rod& r) {
  Bounds bounds;
  for (const auto& [p, radius] : {std::pair(r.from, r.radius[0]), {r.to, r.radius[1]}})
    for (const double by : {-radius, radius}) bounds.add({p.x + by, p.y + by, p.z + by});
  return bounds.box();
}

// From the lowest to the highest value along a normal of some length.
struct Range {
  double low, high;
};
Range range(const SpacePartition::Rod& r, const Vec3& normal, double size) {
  const double from = dot(normal, r.from), to = dot(normal, r.to);
  const double at_from = 1.01 * r.radius[0] * size, at_to = 1.01 * r.radius[1] * size;
  return {std::min(from - at_from, to - at_to), std::max(from + at_from, to + at_to)};
}

// Does a plane of some direction have the two rods on different sides?
bool is_between(const SpacePartition::Rod& r, const SpacePartition::Rod& s, const Vec3& normal) {
  const double size = std::sqrt(dot(normal, normal));
  const Range of_r = range(r, normal, size), of_s = range(s, normal, size);
  return of_r.low > of_s.high + 64 * unit || of_s.low > of_r.high + 64 * unit;
}

// Is a rod on one side of the plane through the other one and the middle of the cube, or, if that
// one is pointed, of one along its sides?
bool is_beside(const SpacePartition::Rod& r, const SpacePartition::Rod& s) {
  const Vec3 normal = cross(s.from, s.to);
  if (is_between(r, s, normal)) return true;
  const double size = std::sqrt(dot(normal, normal)), least = std::min(s.radius[0], s.radius[1]);
  if (!(size > 0) || std::max(s.radius[0], s.radius[1]) < 2 * least) return false;
  for (const double side : {-1 / size, 1 / size}) {
    const Vec3 from = s.from + (side * s.radius[0]) * normal,
               to = s.to + (side * s.radius[1]) * normal;
    if (is_between(r, s, cross(from, to))) return true;
  }
  return false;
}

}  // namespace

// What is off a place on the way by less than 1/16, where the greatest coordinate is m, is off on
// the cube by less than 3.5 / m times as much: the length of a place is sqrt(3) m at most, and m is
// more than 0.4. That changes along a rod as the radius does. An arc that is not known is all of
// the cube.
void ArcPartition::Rods::add(const SeenArc& seen, std::uint32_t number, std::uint32_t its_label) {
  const auto add_rod = [&](const SpacePartition::Rod& made) {
    rod.push_back(made);
    arc.push_back(number);
    label.push_back(its_label);
  };
  SpacePartition::Rod next;
  next.radius = {2, 2};
  if (!seen.is_known()) return add_rod(next);
  const std::span<const Vec3> way = seen.way();
  for (std::size_t k = 1; k < way.size(); ++k) {
    const Vec3 &from = way[k - 1], &to = way[k];
    const auto end_at = [&](double share, const Vec3& place) {
      const double radius = seen.radius(k - 1) + share * (seen.radius(k) - seen.radius(k - 1));
      next.to = on_cube(place);
      next.radius[1] = 3.5 * radius / max_norm(place) + 64 * unit;
    };
    const auto begin_there = [&] {
      next.from = next.to;
      next.radius[0] = next.radius[1];
    };
    end_at(0, from);
    for (const double share : bends(from, to)) {
      begin_there();
      end_at(share, from + share * (to - from));
      add_rod(next);
    }
    begin_there();
    end_at(1, to);
    add_rod(next);
  }
}

ArcPartition::ArcPartition(std::span<const SeenArc> arcs, std::span<const std::uint32_t> labels) {
  for (std::uint32_t i = 0; i < arcs.size(); ++i)
    rods_.add(arcs[i], i, labels.empty() ? SpacePartition::no_label : labels[i]);
}

std::optional<std::vector<std::pair<std::uint32_t, std::uint32_t>>> ArcPartition::few_by_boxes()
    const {
  constexpr std::size_t for_each = threshold(16, 1), at_a_time = 64;
  std::vector<Box> boxes;
  boxes.reserve(rods_.rod.size());
  for (const SpacePartition::Rod& r : rods_.rod) boxes.push_back(box_around(r));
  const BoxTree tree(boxes);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  std::size_t overlaps = 0;
  const auto add = [&](std::uint32_t i, std::uint32_t j) {
    if (rods_.label[i] == rods_.label[j] && rods_.label[i] != SpacePartition::no_label) return;
    if (++overlaps > for_each * boxes.size() || rods_.arc[i] == rods_.arc[j]) return;
    if (!are_apart(rods_.rod[i], rods_.rod[j]))
      pairs.push_back(std::minmax(rods_.arc[i], rods_.arc[j]));
  };
  for (const BoxTree::SelfPart& part : tree.self_parts(at_a_time)) {
    tree.self_overlaps(part, add);
    if (overlaps > for_each * boxes.size()) return {};
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

bool ArcPartition::are_apart(const SpacePartition::Rod& r, const SpacePartition::Rod& s) {
  return is_beside(r, s) || is_beside(s, r);
}

}  // namespace sectile
