#include "boolean/reduction/crowded_segments.h"

#include <algorithm>

#include "boolean/entity_numbers.h"
#include "boolean/near/crowded_lines.h"
#include "search/edges_by_line.h"
#include "search/spine_lines.h"

namespace sectile {
namespace {

// Some edges of both operands, between vertices that have numbers, those of A first.
class EdgesOfBoth {
 public:
  explicit EdgesOfBoth(const Workspace& w) : w_(w) {
    for (const Operand s : both_operands) {
      const Brep& brep = w.patch[s].brep;
      first_[s] = points_.size();
      for (const VertexId v : brep.vertices()) points_.push_back(brep.point_of(v));
    }
  }

  void add(Operand s, EdgeId e) {
    const Patch& patch = w_.patch[s];
    const HalfEdgeId h = Brep::half_edge(e);
    if (!patch.is_real(patch.brep.face_of(h)) || !patch.is_real(patch.brep.face_of(Brep::twin(h))))
      return;
    edges_.push_back(
        PointPair::between(number(s, patch.brep.from(h)), number(s, patch.brep.to(h))));
  }

  /// Where many of the edges run, with all vertices there.
  SpineLines crowded() const {
    return {w_.tests(), points_,
            crowded_lines(w_.tests(), points_, edges_, CrowdedLines::many_beside)};
  }
  PointId point(std::uint32_t vertex) const { return points_[vertex]; }
  /// The mark of a vertex.
  std::uint32_t& on_line(Workspace& w, std::uint32_t vertex) const {
    const Operand s = vertex < first_[Operand::b] ? Operand::a : Operand::b;
    return w.patch[s].on_crowded_line[VertexId(vertex - first_[s])];
  }

 private:
  std::uint32_t number(Operand s, VertexId v) const {
    return static_cast<std::uint32_t>(first_[s] + v.value());
  }

  const Workspace& w_;
  PerOperand<std::size_t> first_;
  std::vector<PointId> points_;
  std::vector<PointPair> edges_;
};

bool is_along_edge(const SegmentRecord& r) {
  return r.on[Operand::a].is_edge() || r.on[Operand::b].is_edge();
}

// So many segments of one edge or face, which all are along edges, may be a crowd.
constexpr std::uint32_t many_segments = CrowdedLines::many_beside / 2;

// How many segments along edges each entity has.
class SegmentCounts {
 public:
  SegmentCounts(const Workspace& w, const Contacts& found)
      : number_{EntityNumbers(w.patch[Operand::a].brep), EntityNumbers(w.patch[Operand::b].brep)} {
    for (const Operand s : both_operands) counts_[s].resize(number_[s].size());
    for (const SegmentRecord& r : found.segments)
      if (is_along_edge(r))
        for (const Operand s : both_operands) most_ = std::max(most_, ++count(s, r.on[s]));
  }

  std::uint32_t most() const { return most_; }
  bool has_many(const SegmentRecord& r) {
    return count(Operand::a, r.on[Operand::a]) >= many_segments ||
           count(Operand::b, r.on[Operand::b]) >= many_segments;
  }

 private:
  std::uint32_t& count(Operand s, Entity e) { return counts_[s][number_[s][e]]; }

  PerOperand<EntityNumbers> number_;
  PerOperand<std::vector<std::uint32_t>> counts_;
  std::uint32_t most_ = 0;
};

// Those that share segments with something that shares some with very many.
void add_edges_beside_many(const Workspace& w, const Contacts& found, SegmentCounts& counts,
                           EdgesOfBoth& edges) {
  PerOperand<std::vector<std::uint8_t>> is_added;
  for (const Operand s : both_operands) is_added[s].resize(w.patch[s].brep.edge_count());
  for (const SegmentRecord& r : found.segments) {
    if (!counts.has_many(r)) continue;
    for (const Operand s : both_operands) {
      if (!r.on[s].is_edge() || is_added[s][r.on[s].index()] != 0) continue;
      is_added[s][r.on[s].index()] = 1;
      edges.add(s, r.on[s].edge());
    }
  }
}

}  // namespace

void mark_crowded_segments(Workspace& w, const Contacts& found) {
  if (std::ranges::count_if(found.segments, is_along_edge) < std::ptrdiff_t(many_segments)) return;
  SegmentCounts counts(w, found);
  if (counts.most() < many_segments) return;
  EdgesOfBoth edges(w);
  add_edges_beside_many(w, found, counts, edges);
  const SpineLines lines = edges.crowded();
  if (lines.count() == 0) return;
  for (std::uint32_t line = 0; line < lines.count(); ++line) {
    const auto [from, to] = lines.extent(line);
    w.crowded_lines.push_back({edges.point(from), edges.point(to)});
  }
  for (Patch& patch : w.patch) patch.on_crowded_line.assign(patch.brep.vertex_count(), 0);
  for (const SpineLines::On& on : lines.points()) {
    std::uint32_t& mark = edges.on_line(w, on.point);
    mark = mark == 0 ? 1 + on.line : Patch::several;
  }
}

}  // namespace sectile
