// Faces, edges and vertices under the pointer, with the coordinates that the solids really have.
#pragma once

#include <optional>
#include <vector>

#include "app/session.h"
#include "app/snap_scene.h"
#include "scene/picking.h"
#include "scene/placing.h"

namespace sectile::viewer {

struct PickedSpot {
  PickedFeature::Kind kind = PickedFeature::Kind::face;
  NodeId node = 0;   ///< what was hit
  NodeId mover = 0;  ///< what moves with it: the selected node above it, else the topmost
  std::shared_ptr<const SnapTargets> features;  ///< of the solid that was hit, in the world
  std::size_t index = 0;  ///< of the face or the edge among them; of a vertex: not used
  Vec3 point;             ///< the vertex; else the place that was hit

  const SnapFeatures::Face& face() const { return features->features().faces[index]; }
  const SnapFeatures::Edge& edge() const { return features->features().edges[index]; }
  /// What it looks like: two ends for each edge.
  std::vector<Vec3> shown() const;
};

class FeaturePicker {
 public:
  std::optional<PickedSpot> face_at(const Session& session, glm::dvec2 pixel);
  std::optional<PickedSpot> edge_at(const Session& session, glm::dvec2 pixel);
  /// The nearest vertex, else the nearest edge, else the face.
  std::optional<PickedSpot> any_at(const Session& session, glm::dvec2 pixel);

 private:
  std::optional<PickedSpot> spot_of(const Document& document, const Results& results, NodeId node);
  Picker picker_;
  KnownTargets known_;
};

/// How the solid of a node stands when `mover`, the node or one above it, is to be moved.
Standing standing_of(const Scene& scene, NodeId node, NodeId mover);
/// The box around a node in the world; empty if nothing of it is computed.
ExactBox exact_box_of(const Scene& scene, const Results& results, NodeId id);
/// Draws edges and points over everything.
void add_spot(Picture& picture, const PickedSpot& spot, const Colour& colour);

}  // namespace sectile::viewer
