// The edges of a face of many corners, as a tree over stretches of its loops.
//
// A ray that begins outside of a convex region around a stretch crosses the stretch an odd number
// of times exactly if the stretch ends on the other side of the ray's line. So a point is located
// by looking at what is around it, however many edges the ray crosses: between the teeth of a comb,
// too. The regions are boxes and, where edges are long and slanted, strips along them.
//
// Where stretches lie around each other, as rings in rings do, there is a tree over the edges by
// their places and directions as well.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "search/strip_tree.h"

namespace sectile {

class OutlineTree {
 public:
  using Place = StripTree::Place;
  using Target = StripTree::Target;

  /// Corners of a face, known up to half an ulp in each coordinate, loop after loop, and the ends
  /// of the loops among them. An edge has the number of the corner where it begins.
  OutlineTree(std::span<const Vec3> corners, std::span<const std::uint32_t> loop_ends, int axis);

  /// The face as a target of others.
  const Target& as_target() const { return as_target_; }

  /// Calls visit(edge) for all that come near a target and for few others.
  template <class Visit>
  void query(const Target& target, const Visit& visit) const {
    (by_place_ ? *by_place_ : stretches_).visit_near(target, visit);
  }

  /// Do stretches of the loops lie around each other?
  bool is_nested() const { return by_place_.has_value(); }

  /// Of a nested outline, for a ray in direction +i from a place: calls crosses(edge), which tells
  /// whether the ray crosses an edge, for all that come near the place and for some others. Returns
  /// the one that is crossed first, or StripTree::no_edge; nothing if that is not certain.
  template <class Crosses>
  std::optional<std::uint32_t> first_on_ray(const Place& place, const Crosses& crosses) const {
    const auto& [order, tree] = *by_place_;
    const auto first = tree.first_on_ray(
        place, [&, &edges = order](std::uint32_t e) { return crosses(edges[e]); });
    return first && *first != StripTree::no_edge ? order[*first] : first;
  }

  /// For a ray in direction +i from a place: calls look(edge) for edges around the place, and
  /// pass(from, to) with the corners in which a stretch begins and ends that meets the line of the
  /// ray on the ray only. All other edges lie behind the place or aside.
  template <class Look, class Pass>
  void cast_ray(const Place& place, const Look& look, const Pass& pass) const {
    cast_ray(stretches_.tree.root(), place, look, pass);
  }

 private:
  using Node = StripTree::Node;
  using Side = StripTree::Side;

  struct Edges {
    std::vector<std::uint32_t> order;  // the numbers of the edges
    StripTree tree;                    // in this order

    template <class Visit>
    void visit_near(const Target& target, const Visit& visit) const {
      tree.query(target, [&](std::uint32_t e) { visit(order[e]); });
    }
  };

  struct Loops;
  explicit OutlineTree(const Loops& loops, int axis);

  template <class Look, class Pass>
  void cast_ray(Node n, const Place& place, const Look& look, const Pass& pass) const {
    const StripTree& tree = stretches_.tree;
    const Side where = tree.side(n, place);
    if (where == Side::aside) return;
    if (where == Side::ahead) {
      pass_stretch(tree.begin(n), tree.end(n), pass);
    } else if (n.level > 0) {
      for (std::uint32_t i = 0; i < tree.child_count(n); ++i)
        cast_ray(tree.child(n, i), place, look, pass);
    } else {
      for (std::uint32_t e = tree.begin(n); e < tree.end(n); ++e) cast_ray_at(e, place, look, pass);
    }
  }

  template <class Look, class Pass>
  void cast_ray_at(std::uint32_t e, const Place& place, const Look& look, const Pass& pass) const {
    const Side where = stretches_.tree.side(e, place);
    if (where == Side::ahead)
      pass_stretch(e, e + 1, pass);
    else if (where == Side::around)
      look(stretches_.order[e]);
  }

  // Whole loops end where they begin; what counts is the loop in which the stretch begins and the
  // one in which it ends.
  template <class Pass>
  void pass_stretch(std::uint32_t from, std::uint32_t to, const Pass& pass) const {
    const std::vector<std::uint32_t>& order = stretches_.order;
    const bool at_end = to == order.size();
    const std::uint32_t loop = loop_begin_[from], last_loop = at_end ? to : loop_begin_[to];
    if (loop == last_loop) {
      pass(order[from], order[to]);
      return;
    }
    if (from != loop) pass(order[from], order[loop]);
    if (to != last_loop) pass(order[last_loop], order[to]);
  }

  Target as_target_;
  Edges stretches_;                        // loop after loop
  std::vector<std::uint32_t> loop_begin_;  // per edge in this order
  std::optional<Edges> by_place_;
};

}  // namespace sectile
