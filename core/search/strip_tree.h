// A tree over edges in one plane, in a given order: boxes around those that follow each other and,
// where edges are long and slanted, strips along them.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "geometry/axes.h"
#include "search/box.h"
#include "search/face_slab.h"

namespace sectile {

class StripTree {
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

  /// Its ends, known up to half an ulp in each coordinate.
  struct Edge {
    Vec3 from, to;
  };

  /// At least one edge, in planes that are not parallel to the axis.
  StripTree(std::span<const Edge> edges, int axis);

  /// Do stretches of edges that follow each other lie around each other, or cross, many times over?
  bool is_crowded() const;

  struct Node {
    std::uint32_t level, index;
  };
  Node root() const { return {static_cast<std::uint32_t>(boxes_.size() - 1), 0}; }
  Node child(Node n, std::uint32_t which) const { return {n.level - 1, 2 * n.index + which}; }
  std::uint32_t child_count(Node n) const {
    return 2 * std::size_t(n.index) + 1 < boxes_[n.level - 1].size() ? 2 : 1;
  }
  /// The edges under a node.
  std::uint32_t begin(Node n) const { return (n.index * leaf_size) << n.level; }
  std::uint32_t end(Node n) const {
    const std::size_t end = (std::size_t(n.index) + 1) * leaf_size << n.level;
    return static_cast<std::uint32_t>(std::min(end, edge_boxes_.size()));
  }

  /// Calls visit(edge) for all that come near a target and for few others.
  template <class Visit>
  void query(const Target& target, const Visit& visit) const {
    query(root(), target, visit);
  }

  /// Of a ray in direction +i from a place: where is what it is about? All of it behind the place
  /// or beside the ray's line; ahead of the place, if anything of it is on the line; or near it.
  enum class Side { around, ahead, aside };
  Side side(Node n, const Place& place) const {
    return side(boxes_[n.level][n.index], strips_.empty() ? nullptr : &strips_[n.level][n.index],
                place);
  }
  Side side(std::uint32_t e, const Place& place) const {
    return side(edge_boxes_[e], edge_strips_.empty() ? nullptr : &edge_strips_[e], place);
  }

  /// For a ray in direction +i from a place: calls crosses(edge), which tells whether the ray
  /// crosses an edge, for all that come near the place and, near ones first, for others until one
  /// is crossed. Returns the one that is crossed first, or no_edge if none is; nothing if that is
  /// not certain.
  template <class Crosses>
  std::optional<std::uint32_t> first_on_ray(const Place& place, const Crosses& crosses) const {
    FirstOnRay first;
    first_on_ray(root(), place, crosses, first);
    if (first.edge != no_edge && !(first.to < first.next_from)) return {};
    return first.edge;
  }
  static constexpr std::uint32_t no_edge = 0xFFFFFFFFu;

 private:
  static constexpr std::uint32_t leaf_size = 8;

  /// low <= x·i + y·j <= high for all points.
  struct Strip {
    double x, y, low, high;
  };
  /// Where something is met by a ray in direction +i, if at all.
  struct Stretch {
    double from, to;
  };
  struct FirstOnRay {
    static constexpr double infinity = std::numeric_limits<double>::infinity();
    std::uint32_t edge = no_edge;
    double from = infinity;       // where it is met at the earliest
    double to = infinity;         // where it is met at the latest
    double next_from = infinity;  // where others that are crossed are met at the earliest

    void add(std::uint32_t crossed, const Stretch& at);
  };

  void build_boxes(std::span<const Edge> edges);
  void build_strips(std::span<const Edge> edges);
  double area(const Box& box) const;
  double area(const Box& box, const Strip& strip) const;
  Strip strip_around(std::span<const Edge> edges) const;

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
  Side side(const Box& box, const Strip* strip, const Place& place) const;

  template <class Visit>
  void query(Node n, const Target& target, const Visit& visit) const {
    if (!is_near(n, target)) return;
    if (n.level > 0) {
      for (std::uint32_t i = 0; i < child_count(n); ++i) query(child(n, i), target, visit);
      return;
    }
    for (std::uint32_t e = begin(n); e < end(n); ++e)
      if (is_near(e, target)) visit(e);
  }

  /// If it comes near the line of the ray.
  Stretch on_ray(Node n, const Place& place) const {
    return on_ray(boxes_[n.level][n.index], strips_.empty() ? nullptr : &strips_[n.level][n.index],
                  place);
  }
  Stretch on_ray(std::uint32_t e, const Place& place) const {
    return on_ray(edge_boxes_[e], edge_strips_.empty() ? nullptr : &edge_strips_[e], place);
  }
  Stretch on_ray(const Box& box, const Strip* strip, const Place& place) const;

  template <class Crosses>
  void first_on_ray(Node n, const Place& place, const Crosses& crosses, FirstOnRay& first) const {
    if (n.level == 0) {
      for (std::uint32_t e = begin(n); e < end(n); ++e) {
        if (side(e, place) == Side::aside) continue;
        const Stretch at = on_ray(e, place);
        if (at.from <= first.to && crosses(e)) first.add(e, at);
      }
      return;
    }
    const std::uint32_t count = child_count(n);
    double from[2];
    bool aside[2];
    for (std::uint32_t i = 0; i < count; ++i) {
      aside[i] = side(child(n, i), place) == Side::aside;
      from[i] = on_ray(child(n, i), place).from;
    }
    const std::uint32_t near = count == 2 && from[1] < from[0] ? 1 : 0;
    for (std::uint32_t k = 0; k < count; ++k) {
      const std::uint32_t i = k ^ near;
      if (!aside[i] && from[i] <= first.to) first_on_ray(child(n, i), place, crosses, first);
    }
  }

  int i_, j_;
  std::vector<Box> edge_boxes_;
  std::vector<std::vector<Box>> boxes_;     // leaves first, the root last
  std::vector<Strip> edge_strips_;          // none where boxes do
  std::vector<std::vector<Strip>> strips_;  // as boxes; none where boxes do
};

}  // namespace sectile
