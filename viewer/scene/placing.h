// Placements that make solids touch or line up: face on face, edge on edge, boxes aligned. Pure
// functions; exact where sums of two doubles can say it, and they tell whether it is.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "scene/snapping.h"

namespace sectile::viewer {

/// How a solid stands that is to be placed by its node.
struct Standing {
  Placement placement;    ///< of the node
  ExactTransform parent;  ///< Scene::exact_world_of_parent of the node
  ExactTransform below;   ///< from the solid's coordinates to the node's
  /// Where a point of the solid is in the world, rounded.
  Vec3 image(const Vec3& local) const { return map()(local); }
  Transform map() const;
  ExactTransform exact_map() const;
  Standing with(const Placement& other) const { return {other, parent, below}; }
};

/// A plane face: its normal in the world (of length one, outwards) and its corners in its solid's
/// own coordinates. `place` is for what stands still: where it does.
struct FlatFace {
  Vec3 normal;
  std::vector<ExactCorner> corners;
  ExactTransform place{};
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
  ExactCorner from, to;
  ExactTransform place{};  ///< as of a FlatFace
};
Landing edge_on_edge(const Standing& start, const PlacedEdge& moved, const PlacedEdge& fixed);

/// The box around some solids in the world, with the corners that reach farthest; which do is
/// decided exactly.
class ExactBox {
 public:
  struct Side {
    Standing standing;
    ExactCorner corner;
    double value = 0;        ///< rounded
    double doubt = 0;        ///< how far it may be wrong
    ExactSum exact() const;  ///< the corner in the world
  };
  bool is_empty() const { return !low_[0]; }
  const Side& low(int axis) const { return *low_[static_cast<std::size_t>(axis)]; }
  const Side& high(int axis) const { return *high_[static_cast<std::size_t>(axis)]; }
  void add(const Standing& standing, std::span<const ExactCorner> corners);

 private:
  std::array<std::optional<Side>, 3> low_, high_;
};

enum class BoxPlace : std::uint8_t { low, centre, high };

/// The node moved along one axis so that a place of its box comes to `value`, or to the middle
/// between two values.
Landing aligned(const ExactBox& box, int axis, BoxPlace place, const ExactSum& value);
Landing centred(const ExactBox& box, int axis, const ExactSum& low, const ExactSum& high);

}  // namespace sectile::viewer
