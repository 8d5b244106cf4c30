#include "boolean/null_edges/bridging.h"

#include <algorithm>

#include "boolean/direction.h"
#include "boolean/patch_euler.h"
#include "boolean/side_by_side.h"

namespace sectile {
namespace {

class Bridging {
 public:
  Bridging(Workspace& w, Operand operand, const CutPlan& plan, const SiteVertices& vertices)
      : operand_(operand),
        patch_(w.patch[operand]),
        kernel_(w.tests()),
        plan_(plan),
        vertices_(vertices) {}

  OperandBridges take() { return std::move(bridges_); }

  void at_place(std::span<const SiteId> sites) {
    const auto divides = [&](SiteId s) { return !plan_.sites[s].entity.is_face(); };
    if (std::ranges::count_if(sites, divides) < 2) return;
    corners_.clear();
    for (const SiteId s : sites)
      if (divides(s)) add_corners(vertices_[s].vertex);
    std::stable_sort(corners_.begin(), corners_.end(), [&](HalfEdgeId g, HalfEdgeId h) {
      return brep().face_of(g) < brep().face_of(h);
    });
    // Faces are split on the way; their corners were collected before.
    std::vector<std::vector<HalfEdgeId>> faces;
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      if (i == 0 || brep().face_of(corners_[i]) != brep().face_of(corners_[i - 1]))
        faces.emplace_back();
      faces.back().push_back(corners_[i]);
    }
    for (const auto& corners : faces)
      if (corners.size() > 1) link(corners);
  }

 private:
  struct Bound {
    Direction direction;
    HalfEdgeId h;
    bool leaves;
  };

  Brep& brep() { return patch_.brep; }

  void add_corners(VertexId v) {
    for_each_around(brep(), brep().vertex_half_edge[v], [&](HalfEdgeId h) {
      if (patch_.is_real(brep().face_of(h)) && !patch_.is_null(h)) corners_.push_back(h);
    });
  }

  // Each half-edge that arrives must be followed by the one that leaves on the other side of the
  // part of the face to its left.
  void link(const std::vector<HalfEdgeId>& corners) {
    const PlaneId plane = brep().plane_of(corners[0]);
    std::vector<Bound> bounds;
    for (const HalfEdgeId h : corners) {
      const HalfEdgeId before = previous_with_length(brep(), h);
      bounds.push_back({direction_of(kernel_, patch_, h), h, true});
      bounds.push_back({-direction_of(kernel_, patch_, before), before, false});
    }
    const Direction start = bounds[0].direction;
    // In a slit, one half-edge arrives where another one leaves: the face ends there and begins
    // again, so what arrives comes first, and last of all where the start leaves.
    const auto closes = [&](const Bound& b) {
      return !b.leaves && turn(kernel_, plane, start, b.direction) == Sign::zero &&
             same_way(kernel_, plane, start, b.direction);
    };
    std::stable_sort(bounds.begin() + 1, bounds.end(), [&](const Bound& p, const Bound& q) {
      if (closes(p) != closes(q)) return closes(q);
      if (before_counter_clockwise(kernel_, plane, start, p.direction, q.direction)) return true;
      if (before_counter_clockwise(kernel_, plane, start, q.direction, p.direction)) return false;
      return !p.leaves && q.leaves;
    });
    for (std::size_t i = 0; i < bounds.size(); ++i) {
      const Bound &leaving = bounds[i], &arriving = bounds[i + 1 < bounds.size() ? i + 1 : 0];
      if (!leaving.leaves || arriving.leaves) continue;
      if (next_with_length(brep(), arriving.h) != leaving.h)
        connect(brep().next_of(arriving.h), leaving.h);
    }
  }

  void connect(HalfEdgeId from, HalfEdgeId to) {
    const FaceId root = patch_.root_of(to);
    const HalfEdgeId made = PatchEuler(patch_).connect(from, to);
    bridges_.null_edges.push_back({operand_, Brep::edge_of(made)});
    bridges_.faces.push_back(root);
  }

  const Operand operand_;
  Patch& patch_;
  const Kernel& kernel_;
  const CutPlan& plan_;
  const SiteVertices& vertices_;
  std::vector<HalfEdgeId> corners_;
  OperandBridges bridges_;
};

}  // namespace

PerOperand<OperandBridges> bridge_touching_corners(Workspace& w, const CutPlan& plan,
                                                   const SitesByPlace& places,
                                                   const SiteVertices& vertices) {
  PerOperand<OperandBridges> bridges;
  for_both_operands(plan.sites.size(), [&](Operand s) {
    Bridging bridging(w, s, plan, vertices);
    places.for_each(s, [&](std::span<const SiteId> sites) { bridging.at_place(sites); });
    bridges[s] = bridging.take();
  });
  return bridges;
}

}  // namespace sectile
