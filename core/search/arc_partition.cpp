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
  for (const Vec3& p : {r.from, r.to})
    for (const double by : {-r.radius, r.radius}) bounds.add({p.x + by, p.y + by, p.z + by});
  return bounds.box();
}

// Is a rod on one side of the plane through the other one and the middle of the cube?
bool is_beside(const SpacePartition::Rod& r, const SpacePartition::Rod& s) {
  const Vec3 normal = cross(s.from, s.to);
  const double reach = 1.01 * (r.radius + s.radius) * std::sqrt(dot(normal, normal)) + 64 * unit;
  const double from = dot(normal, r.from), to = dot(normal, r.to);
  return std::min(from, to) > reach || std::max(from, to) < -reach;
}

}  // namespace

// Unit vectors have a coordinate of more than 1/2: where those are off by an error, places on the
// cube are by less than 5 of it, and some roundings. An arc that is not known is all of the cube.
void ArcPartition::Rods::add(const SeenArc& seen, std::uint32_t number, std::uint32_t its_label) {
  const auto add_rod = [&](const Vec3& from, const Vec3& to, double radius) {
    SpacePartition::Rod made;
    made.from = from;
    made.to = to;
    made.radius = radius;
    rod.push_back(made);
    arc.push_back(number);
    label.push_back(its_label);
  };
  if (!seen.is_known()) return add_rod({0, 0, 0}, {0, 0, 0}, 2);
  const double radius = 5 * seen.error() + 64 * unit;
  const std::span<const Vec3> way = seen.way();
  for (std::size_t k = 1; k < way.size(); ++k) {
    const Vec3 &from = way[k - 1], &to = way[k];
    Vec3 last = on_cube(from);
    for (const double share : bends(from, to)) {
      const Vec3 next = on_cube(from + share * (to - from));
      add_rod(last, next, radius);
      last = next;
    }
    add_rod(last, on_cube(to), radius);
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
