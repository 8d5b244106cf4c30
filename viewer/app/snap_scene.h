// What a drag of solids can snap to: all other solids that are shown. Contacts are found in the
// coordinates in which they will be computed: those of the operation that the dragged solids are
// operands of, else the world's.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "app/results.h"
#include "scene/snapping.h"

namespace sectile::viewer {

/// Features of solids standing still, kept from one drag to the next.
class KnownTargets {
 public:
  std::shared_ptr<const SnapTargets> of(const Solid& inside, const ExactTransform& place);
  /// Forgets what nobody asked for since the last call.
  void forget_unused();

 private:
  struct Known {
    Solid inside;  // holds on to the address that names it
    std::shared_ptr<const SnapTargets> targets;
    bool used = true;
  };
  std::map<std::pair<const void*, std::array<double, 12>>, Known> known_;
};

class SnapScene {
 public:
  /// `nodes` are dragged; `known` outlives this.
  SnapScene(const Scene& scene, const Results& results, const Selection& nodes,
            KnownTargets& known);

  /// From the coordinates of the contacts to the world's, and from those that a dragged node's
  /// placement stands in.
  const Transform& frame() const { return frame_; }
  /// In the order in which the nodes were given.
  std::vector<DraggedNode> dragged_nodes(const Scene& scene) const;

  /// Offsets, reach and directions as in the world.
  Snaps find(const glm::dvec3& offset, double reach, const SnapDirections& directions);
  glm::dvec3 to_world(const Vec3& vector) const;  ///< of a move
  glm::dvec3 from_world(const glm::dvec3& vector) const;
  /// Is it known exactly where the solid that a contact is with stands?
  bool is_known(const Snap& contact) const;

 private:
  struct Part {
    std::size_t node;
    ExactTransform way;  // to the node's own coordinates
  };
  struct Other {
    Solid inside;
    ExactTransform place;
    Bounds bounds;  // in the world
    bool is_known = true;
    std::shared_ptr<const SnapTargets> targets;  // once it came near
  };
  void add_dragged(const Scene& scene, const Results& results, NodeId id, std::size_t node,
                   const ExactTransform& way);
  void add_others(const Scene& scene, const Results& results, NodeId id, bool in_frame);
  ExactTransform place_in_frame(const Scene& scene, NodeId id, bool in_frame) const;

  KnownTargets& known_;
  Selection nodes_;
  NodeId operation_ = 0;  // whose coordinates the frame is
  Transform frame_;
  std::optional<ExactTransform> into_frame_;  // if doubles can say it
  std::vector<ExactTransform> parents_;
  std::vector<Part> parts_;
  SnapFeatures dragged_;
  Bounds bounds_;  // of what is dragged, in the world
  std::vector<Other> others_;
  std::vector<std::size_t> searched_;  // the others of the last search
};

}  // namespace sectile::viewer
