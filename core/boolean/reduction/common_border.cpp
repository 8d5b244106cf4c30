#include "boolean/reduction/common_border.h"

#include <algorithm>

#include "geometry/same_definition.h"

namespace sectile {
namespace {

// The corners on the other face's plane, as a rule none.
class CornersOnPlane {
 public:
  static constexpr std::size_t most = 2;

  explicit CornersOnPlane(const std::vector<SidedHalfEdge>& half_edges) : half_edges_(half_edges) {
    for (std::size_t i = 0; i < half_edges.size(); ++i) {
      if (half_edges[i].from == Sign::positive) ++positive_;
      if (half_edges[i].from == Sign::negative) ++negative_;
      if (half_edges[i].from != Sign::zero) continue;
      if (count_ < most) at_[count_] = i;
      ++count_;
    }
  }
  std::size_t count() const { return count_; }
  HalfEdgeId half_edge(std::size_t i) const { return half_edges_[at_[i]].h; }
  /// All of a polygon is between its corners: of one that is beside a plane, nothing but what is
  /// between those on the plane is in it.
  bool others_on_one_side() const { return (positive_ == 0) != (negative_ == 0); }
  /// The half-edge between the two; invalid if there is none.
  HalfEdgeId edge() const {
    const auto& [first, second] = at_;
    if (second == first + 1) return half_edges_[first].h;
    return first == 0 && second + 1 == half_edges_.size() ? half_edges_[second].h : HalfEdgeId();
  }

 private:
  const std::vector<SidedHalfEdge>& half_edges_;
  std::array<std::size_t, most> at_{};
  std::size_t count_ = 0, positive_ = 0, negative_ = 0;
};

class BorderFinder {
 public:
  BorderFinder(const Workspace& w, const CornersOnPlane& a, const CornersOnPlane& b)
      : w_(w), a_(a), b_(b) {}

  /// Are all those of both on the other's plane the same?
  std::optional<CommonBorder> run() {
    for (std::size_t i = 0; i < a_.count(); ++i)
      for (std::size_t j = 0; j < b_.count(); ++j)
        if (are_same(a_.half_edge(i), b_.half_edge(j))) {
          if (border_.corners == a_.count()) return {};
          border_.corner[border_.corners++] = {{a_.half_edge(i), b_.half_edge(j)}};
        }
    if (border_.corners != a_.count()) return {};
    if (border_.corners == 2) border_.edge = {{a_.edge(), b_.edge()}};
    return border_;
  }

 private:
  bool are_same(HalfEdgeId of_a, HalfEdgeId of_b) const {
    const PointId p = point(Operand::a, of_a), q = point(Operand::b, of_b);
    return !w_.geometry.is_constructed(p) && !w_.geometry.is_constructed(q) &&
           clearly_same(w_.geometry, p, q);
  }
  PointId point(Operand s, HalfEdgeId h) const {
    const Brep& brep = w_.patch[s].brep;
    return brep.point_of(brep.from(h));
  }

  const Workspace& w_;
  const CornersOnPlane &a_, &b_;
  CommonBorder border_;
};

}  // namespace

std::optional<CommonBorder> only_common_border(
    const Workspace& w, const PerOperand<std::vector<SidedHalfEdge>>& half_edges) {
  constexpr std::size_t most_corners = 4;
  if (half_edges[Operand::a].size() > most_corners || half_edges[Operand::b].size() > most_corners)
    return {};
  const CornersOnPlane a(half_edges[Operand::a]), b(half_edges[Operand::b]);
  if (a.count() == 0 || a.count() > CornersOnPlane::most || a.count() != b.count()) return {};
  if (!a.others_on_one_side() && !b.others_on_one_side()) return {};
  for (const Operand s : both_operands)  // are these all that the face has?
    if (w.patch[s].outline(w.patch[s].brep.face_of(half_edges[s][0].h))) return {};
  return BorderFinder(w, a, b).run();
}

}  // namespace sectile
