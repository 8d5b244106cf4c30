#include "evaluation/mesh_edges.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace sectile::viewer {
namespace {

auto key(const Vec3& p) {
  return std::tuple(p.x, p.y, p.z);
}

/// For each position the first one at its place.
std::vector<std::uint32_t> points_of(const PolygonMesh& mesh) {
  std::vector<std::uint32_t> order(mesh.positions.size()), first(order.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    const auto &p = mesh.positions[a], &q = mesh.positions[b];
    return key(p) != key(q) ? key(p) < key(q) : a < b;
  });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool again = i > 0 && mesh.positions[order[i]] == mesh.positions[order[i - 1]];
    first[order[i]] = again ? first[order[i - 1]] : order[i];
  }
  return first;
}

struct HalfEdge {
  std::uint32_t low, high;
  bool forward;
  auto operator<=>(const HalfEdge&) const = default;
};

std::vector<HalfEdge> half_edges(const PolygonMesh& mesh) {
  const std::vector<std::uint32_t> point = points_of(mesh);
  std::vector<HalfEdge> found;
  found.reserve(mesh.indices.size());
  std::size_t begin = 0;
  for (const std::uint32_t size : mesh.face_sizes) {
    for (std::uint32_t i = 0; i < size; ++i) {
      const std::uint32_t p = point[mesh.indices[begin + i]],
                          q = point[mesh.indices[begin + (i + 1) % size]];
      if (p != q) found.push_back({std::min(p, q), std::max(p, q), p < q});
    }
    begin += size;
  }
  std::sort(found.begin(), found.end());
  return found;
}

/// Numbers the pieces that edges between numbered points make up.
class Pieces {
 public:
  explicit Pieces(std::size_t points) : above_(points) {
    std::iota(above_.begin(), above_.end(), 0u);
  }
  std::uint32_t of(std::uint32_t p) {
    while (above_[p] != p) p = above_[p] = above_[above_[p]];
    return p;
  }
  void join(std::uint32_t p, std::uint32_t q) {
    above_[std::max(of(p), of(q))] = std::min(of(p), of(q));
  }

 private:
  std::vector<std::uint32_t> above_;
};

}  // namespace

bool can_be_drawn(const PolygonMesh& mesh) {
  const auto finite = [](const Vec3& p) {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
  };
  return std::accumulate(mesh.face_sizes.begin(), mesh.face_sizes.end(), std::size_t(0)) ==
             mesh.indices.size() &&
         std::all_of(mesh.indices.begin(), mesh.indices.end(),
                     [&](std::uint32_t i) { return i < mesh.positions.size(); }) &&
         std::all_of(mesh.positions.begin(), mesh.positions.end(), finite);
}

OddEdges odd_edges(const PolygonMesh& mesh) {
  const std::vector<HalfEdge> all = half_edges(mesh);
  Pieces pieces(mesh.positions.size());
  std::vector<HalfEdge> borders, contradictions;
  for (std::size_t i = 0, end; i < all.size(); i = end) {
    long balance = 0;
    for (end = i; end < all.size() && all[end].low == all[i].low && all[end].high == all[i].high;
         ++end)
      balance += all[end].forward ? 1 : -1;
    if (balance == 0) continue;
    const bool odd = (end - i) % 2 == 1;
    (odd ? borders : contradictions).push_back(all[i]);
    if (odd) pieces.join(all[i].low, all[i].high);
  }
  OddEdges found;
  for (const HalfEdge& e : borders)
    found.borders.push_back({mesh.positions[e.low], mesh.positions[e.high], pieces.of(e.low)});
  for (const HalfEdge& e : contradictions)
    found.contradictions.push_back({mesh.positions[e.low], mesh.positions[e.high], 0});
  return found;
}

}  // namespace sectile::viewer
