// Placements that make solids touch or line up: face on face, edge on edge, boxes aligned. Pure
// functions; exact where doubles can say it, and they tell whether it is.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "scene/snapping.h"

namespace sectile::viewer {

/// How a solid stands that is to be placed by its node.
struct Standing {
  Placement placement;  ///< of the node
  Transform parent;     ///< Scene::world_of_parent of the node
  Transform below;      ///< from the solid's coordinates to the node's
  /// Where a point of the solid is in the world, rounded as the evaluator does it.
  Vec3 image(const Vec3& local) const { return map()(local); }
  Transform map() const;
  Standing with(const Placement& other) const { return {other, parent, below}; }
};

/// A plane face: its normal in the world (of length one, outwards) and its corners, which are the
/// solid's own for what is to be moved and the world's for what stands still.
struct FlatFace {
  Vec3 normal;
  std::vector<Vec3> corners;
};

struct FlushOptions {
  bool centred = false;    ///< the middles of the faces' boxes meet
  bool same_side = false;  ///< both solids lie on the same side of the plane: level, not touching
};

/// The solid turned, by the smallest angle, and moved so that its face lies in the plane of
/// another. Turns that are right angles about the axes are exact, others nearly so.
Landing flush(const Standing& start, const FlatFace& moved, const FlatFace& fixed,
              const FlushOptions& options = {});

/// The solid turned and moved so that its edge lies on another one, `from` on `from`.
struct PlacedEdge {
  Vec3 from, to;  ///< as the corners of a FlatFace
};
Landing edge_on_edge(const Standing& start, const PlacedEdge& moved, const PlacedEdge& fixed);

/// The box around some solids in the world, with the points that reach farthest.
struct ExactBox {
  struct Side {
    Standing standing;
    Vec3 local;
    double value = 0;
  };
  std::array<std::optional<Side>, 3> low, high;
  bool is_empty() const { return !low[0]; }
  void add(const Standing& standing, std::span<const Vec3> points);
};

enum class BoxPlace : std::uint8_t { low, centre, high };

/// The node moved along one axis so that a place of its box comes to `value`, or to the middle
/// between two values.
Landing aligned(const ExactBox& box, int axis, BoxPlace place, double value);
Landing centred(const ExactBox& box, int axis, double low, double high);

}  // namespace sectile::viewer
