#include "repair/stitching.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "search/box_tree.h"

namespace sectile {
namespace {

bool before(const Vec3& a, const Vec3& b) {
  return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
}

struct ClosePair {
  double distance;
  std::uint32_t p, q;
};

std::vector<ClosePair> close_pairs(std::span<const Vec3> points, double distance) {
  std::vector<Box> boxes;
  for (const Vec3& p : points) {
    Bounds bounds;
    bounds.add({p.x - distance, p.y - distance, p.z - distance});
    bounds.add(p);
    boxes.push_back(bounds.box());
  }
  const BoxTree tree(boxes);
  std::vector<ClosePair> pairs;
  for (const auto& part : tree.self_parts(1))
    tree.self_overlaps(part, [&](std::uint32_t i, std::uint32_t j) {
      const Vec3 &a = points[i], &b = points[j];
      const double apart = std::hypot(a.x - b.x, a.y - b.y, a.z - b.z);
      if (apart <= distance) pairs.push_back({apart, std::min(i, j), std::max(i, j)});
    });
  std::sort(pairs.begin(), pairs.end(), [](const ClosePair& a, const ClosePair& b) {
    return std::tie(a.distance, a.p, a.q) < std::tie(b.distance, b.p, b.q);
  });
  return pairs;
}

}  // namespace

Moves stitch(std::span<const Vec3> points,
             std::span<const std::pair<std::uint32_t, std::uint32_t>> neighbours, double distance) {
  enum class Role : std::uint8_t { open, goal, moved };
  std::vector<Role> role(points.size(), Role::open);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> apart;
  for (const auto& [i, j] : neighbours) apart.push_back({std::min(i, j), std::max(i, j)});
  std::sort(apart.begin(), apart.end());
  Moves moves;
  for (const ClosePair& pair : close_pairs(points, distance)) {
    auto [to, from] = std::pair(pair.p, pair.q);
    if (std::binary_search(apart.begin(), apart.end(), std::pair(pair.p, pair.q))) continue;
    if (role[from] == Role::goal) std::swap(to, from);
    if (role[from] != Role::open || role[to] == Role::moved) continue;
    role[to] = Role::goal;
    role[from] = Role::moved;
    moves.push_back({points[from], points[to]});
  }
  std::sort(moves.begin(), moves.end(),
            [](const auto& a, const auto& b) { return before(a.first, b.first); });
  return moves;
}

std::size_t apply(const Moves& moves, std::vector<Vec3>& positions) {
  std::size_t count = 0;
  for (Vec3& p : positions) {
    const auto at =
        std::lower_bound(moves.begin(), moves.end(), p,
                         [](const auto& move, const Vec3& v) { return before(move.first, v); });
    if (at == moves.end() || !(at->first == p)) continue;
    p = at->second;
    ++count;
  }
  return count;
}

}  // namespace sectile
