#include "import/crossing.h"

#include "numbers/threshold.h"
#include "search/piece_tree.h"
#include "selftest/rim_sweep.h"

namespace sectile {
namespace {

using Edge = RimEdge;

Sign turn(const Kernel& kernel, int axis, const Edge& edge, PointId p) {
  return kernel.turn(edge.from, edge.to, p, axis);
}

bool separates(const Kernel& kernel, int axis, const Edge& line, const Edge& edge) {
  const Sign from = turn(kernel, axis, line, edge.from);
  return from != Sign::zero && from == -turn(kernel, axis, line, edge.to);
}

bool cross(const Kernel& kernel, int axis, const Edge& a, const Edge& b) {
  if (a.from == b.from || a.from == b.to || a.to == b.from || a.to == b.to) return false;
  return separates(kernel, axis, a, b) && separates(kernel, axis, b, a);
}

bool is_convex(const Kernel& kernel, int axis, const std::vector<Edge>& edges) {
  const Sign first = turn(kernel, axis, edges[0], edges[1].to);
  if (first == Sign::zero) return false;
  for (std::size_t i = 1; i < edges.size(); ++i)
    if (turn(kernel, axis, edges[i], edges[i + 1 < edges.size() ? i + 1 : 0].to) != first)
      return false;
  return true;
}

// The edges of all loops, as seen along an axis.
class Edges {
 public:
  Edges(const Kernel& kernel, int axis, std::span<const PointId> corners,
        std::span<const std::uint32_t> loop_ends, CrossingFaces how)
      : kernel_(kernel), axis_(axis), at_corners_(how == CrossingFaces::split) {
    edges_.reserve(corners.size());
    std::uint32_t begin = 0;
    for (const std::uint32_t end : loop_ends) {
      for (std::uint32_t i = begin; i < end; ++i) {
        next_.push_back(i + 1 < end ? i + 1 : begin);
        edges_.push_back({corners[i], corners[next_.back()]});
      }
      begin = end;
    }
  }

  const std::vector<Edge>& all() const { return edges_; }

  bool any_pair_crosses() const {
    for (std::size_t i = 0; i < edges_.size(); ++i)
      for (std::size_t j = i + 1; j < edges_.size(); ++j)
        if (meet(i, j)) return true;
    return false;
  }

  bool any_overlap_crosses() const {
    const Geometry& g = kernel_.geometry();
    std::vector<PieceTree::Edge> edges;
    edges.reserve(edges_.size());
    for (const Edge& e : edges_) edges.push_back({g.position(e.from), g.position(e.to)});
    bool found = false;
    PieceTree(edges).self_overlaps(
        [&](std::uint32_t i, std::uint32_t j) { found = found || meet(i, j); });
    return found;
  }

 private:
  bool meet(std::size_t i, std::size_t j) const {
    return cross(kernel_, axis_, edges_[i], edges_[j]) ||
           (at_corners_ && (passes_at_end(i, j) || passes_at_end(j, i)));
  }

  // Does the loop go from one side of an edge to the other, or along it, in a corner that lies
  // within the edge, which is where edge `to` ends?
  bool passes_at_end(std::size_t edge, std::size_t to) const {
    const Edge& e = edges_[edge];
    const PointId corner = edges_[to].to;
    if (corner == e.from || corner == e.to || turn(kernel_, axis_, e, corner) != Sign::zero ||
        !kernel_.is_between(e.from, corner, e.to))
      return false;
    const Sign before = turn(kernel_, axis_, e, edges_[to].from),
               after = turn(kernel_, axis_, e, edges_[next_[to]].to);
    return before == Sign::zero || before != after;
  }

  const Kernel& kernel_;
  int axis_;
  bool at_corners_;
  std::vector<Edge> edges_;
  std::vector<std::uint32_t> next_;
};

}  // namespace

bool edges_cross(const Kernel& kernel, int axis, bool behind, std::span<const PointId> corners,
                 std::span<const std::uint32_t> loop_ends, CrossingFaces how) {
  const Edges edges(kernel, axis, corners, loop_ends, how);
  const std::size_t count = edges.all().size();
  // Four turns to one side make one round.
  if (count == 4 && loop_ends.size() == 1 && is_convex(kernel, axis, edges.all())) return false;
  constexpr std::size_t few = threshold(16, 1);
  if (count <= few) return edges.any_pair_crosses();
  // Long slanted edges have boxes that overlap by the million; a sweep tells that nothing crosses,
  // as a rule.
  if (RimSweep(kernel).winds_once(edges.all(), axis, behind)) return false;
  return edges.any_overlap_crosses();
}

}  // namespace sectile
