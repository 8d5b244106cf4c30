// The edges of a face of many corners, as a tree over stretches of its loops.
//
// A ray that begins outside of a convex region around a stretch crosses the stretch an odd number
// of times exactly if the stretch ends on the other side of the ray's line. So a point is located
// by looking at what is around it, however many edges the ray crosses: between the teeth of a comb,
// too. The regions are boxes and, where edges are long and slanted, strips along them.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/axes.h"
#include "search/box.h"
#include "search/face_slab.h"

namespace sectile {

class OutlineTree {
 public:
  /// A place as seen along the axis, as far as doubles know it: bounds of the coordinates on the
  /// next axis (i) and the one after it (j).
  struct Place {
    double low[2], high[2];
  };

  /// Something that edges may come near to: what is within the box and the slab.
  struct Target {
    Box box = Box::everything();
    FaceSlab slab;
    std::array<Vec3, 4> corners;     ///< what is as well in their convex hull,
    std::uint32_t corner_count = 0;  ///< if there are any

    Target() = default;
    /// A polygon of at least three corners.
    explicit Target(std::span<const Vec3> polygon);
  };

  /// Corners of a face, known up to half an ulp in each coordinate, loop after loop, and the ends
  /// of the loops among them. An edge has the number of the corner where it begins.
  OutlineTree(std::span<const Vec3> corners, std::span<const std::uint32_t> loop_ends, int axis);

  /// The face as a target of others.
  const Target& as_target() const { return as_target_; }

  /// Calls visit(edge) for all that come near a target and for few others.
  template <class Visit>
  void query(const Target& target, const Visit& visit) const {
    query(root(), target, visit);
  }

  /// For a ray in direction +i from a place: calls look(edge) for edges around the place, and
  /// pass(from, to) with the corners in which a stretch begins and ends that meets the line of the
  /// ray on the ray only. All other edges lie behind the place or aside.
  template <class Look, class Pass>
  void cast_ray(const Place& place, const Look& look, const Pass& pass) const {
    cast_ray(root(), place, look, pass);
  }

 private:
  static constexpr std::uint32_t leaf_size = 8;

  struct Node {
    std::uint32_t level, index;
  };
  /// low <= x·i + y·j <= high for all points.
  struct Strip {
    double x, y, low, high;
  };
  enum class Side { around, ahead, aside };

  void sort_loops(std::span<const Vec3> corners, std::span<const std::uint32_t> loop_ends);
  void build_boxes(std::span<const Vec3> corners);
  bool is_slanted() const;
  void build_strips(std::span<const Vec3> corners);
  std::uint32_t next(std::uint32_t e) const;
  Strip strip_around(std::span<const Vec3> corners, std::uint32_t from, std::uint32_t to) const;

  Node root() const { return {static_cast<std::uint32_t>(boxes_.size() - 1), 0}; }
  Node child(Node n, std::uint32_t which) const { return {n.level - 1, 2 * n.index + which}; }
  std::uint32_t child_count(Node n) const {
    return 2 * std::size_t(n.index) + 1 < boxes_[n.level - 1].size() ? 2 : 1;
  }
  std::uint32_t begin(Node n) const { return (n.index * leaf_size) << n.level; }
  std::uint32_t end(Node n) const {
    const std::size_t end = (std::size_t(n.index) + 1) * leaf_size << n.level;
    return static_cast<std::uint32_t>(std::min(end, order_.size()));
  }

  bool is_near(Node n, const Target& target) const {
    const Box& box = boxes_[n.level][n.index];
    return box.overlaps(target.box) && !apart(target.slab, box) &&
           (strips_.empty() || is_near(strips_[n.level][n.index], target));
  }
  bool is_near(std::uint32_t e, const Target& target) const {
    return edge_boxes_[e].overlaps(target.box) &&
           (edge_strips_.empty() || is_near(edge_strips_[e], target));
  }
  bool is_near(const Strip& strip, const Target& target) const;

  Side side(Node n, const Place& place) const {
    return side(boxes_[n.level][n.index], strips_.empty() ? nullptr : &strips_[n.level][n.index],
                place);
  }
  Side side(std::uint32_t e, const Place& place) const {
    return side(edge_boxes_[e], edge_strips_.empty() ? nullptr : &edge_strips_[e], place);
  }
  Side side(const Box& box, const Strip* strip, const Place& place) const;

  template <class Visit>
  void query(Node n, const Target& target, const Visit& visit) const {
    if (!is_near(n, target)) return;
    if (n.level > 0) {
      for (std::uint32_t i = 0; i < child_count(n); ++i) query(child(n, i), target, visit);
      return;
    }
    for (std::uint32_t e = begin(n); e < end(n); ++e)
      if (is_near(e, target)) visit(order_[e]);
  }

  template <class Look, class Pass>
  void cast_ray(Node n, const Place& place, const Look& look, const Pass& pass) const {
    const Side where = side(n, place);
    if (where == Side::aside) return;
    if (where == Side::ahead) {
      pass_stretch(begin(n), end(n), pass);
    } else if (n.level > 0) {
      for (std::uint32_t i = 0; i < child_count(n); ++i) cast_ray(child(n, i), place, look, pass);
    } else {
      for (std::uint32_t e = begin(n); e < end(n); ++e) cast_ray_at(e, place, look, pass);
    }
  }

  template <class Look, class Pass>
  void cast_ray_at(std::uint32_t e, const Place& place, const Look& look, const Pass& pass) const {
    const Side where = side(e, place);
    if (where == Side::ahead)
      pass_stretch(e, e + 1, pass);
    else if (where == Side::around)
      look(order_[e]);
  }

  // Whole loops end where they begin; what counts is the loop in which the stretch begins and the
  // one in which it ends.
  template <class Pass>
  void pass_stretch(std::uint32_t from, std::uint32_t to, const Pass& pass) const {
    const bool at_end = to == order_.size();
    const std::uint32_t loop = loop_begin_[from], last_loop = at_end ? to : loop_begin_[to];
    if (loop == last_loop) {
      pass(order_[from], order_[to]);
      return;
    }
    if (from != loop) pass(order_[from], order_[loop]);
    if (to != last_loop) pass(order_[last_loop], order_[to]);
  }

  int i_, j_;
  std::vector<std::uint32_t> order_;        // the numbers of the edges, loop after loop
  std::vector<std::uint32_t> loop_begin_;   // per edge in this order
  std::vector<Box> edge_boxes_;             // per edge in this order
  std::vector<std::vector<Box>> boxes_;     // leaves first, the root last
  std::vector<Strip> edge_strips_;          // per edge in this order; none where boxes do
  std::vector<std::vector<Strip>> strips_;  // as boxes; none where boxes do
  Target as_target_;
};

}  // namespace sectile
