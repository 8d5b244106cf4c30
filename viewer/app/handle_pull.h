// The handles of the selected solids, and a drag of one of them from press to release.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "app/session.h"
#include "app/snap_scene.h"
#include "scene/handles.h"

namespace sectile::viewer {

/// At the solid selected last; none without a selection, and none in the steps.
std::optional<Handles> handles_of(const Session& session);
std::optional<Handles> handles_of(const Session& session, bool own_axes);

/// What a drag has come to.
struct PullState {
  std::string text;               ///< how far, and what it touches
  std::vector<glm::vec3> edges;   ///< of what it touches: two ends for each
  std::vector<glm::vec3> points;  ///< where it touches
  bool is_contact = false, is_exact = false;
  bool leaves_axis = false;  ///< to be exact, the contact would need more than this handle does
};

/// Draws what a drag touches, and how far it came above the handles.
void add_marks(Picture& picture, const ViewState& view, const Handles& handles,
               const PullState& state);

class HandlePull {
 public:
  HandlePull(const Session& session, const Handles& handles, HandlePart part, glm::dvec2 pixel);
  HandlePull(const Session& session, const Handles& handles, HandlePart part, glm::dvec2 pixel,
             bool own_axes);
  /// Shows the scene with the handle pulled to the pointer, as a draft.
  void pull(Session& session, glm::dvec2 pixel, bool snapping, KnownTargets& known);
  /// The same with a change that does not come from the pointer.
  void show(Session& session, const HandleChange& change, bool snapping, KnownTargets& known);
  HandlePart part() const { return part_; }
  Handles handles() const;  ///< where they are now
  const PullState& state() const { return state_; }

 private:
  std::array<bool, 3> reached_coordinates(NodeId id) const;
  void keep_on_axis(Placement& placement, NodeId id);
  Scene moved(Session& session, const glm::dvec3& offset, bool snapping, KnownTargets& known);
  std::optional<Scene> moved_into_contact(const Session& session, const glm::dvec3& offset,
                                          SnapScene& others);
  Scene moved_by(const glm::dvec3& offset);
  Scene moved_on_grid(const Session& session, const glm::dvec3& offset);
  Scene turned_or_scaled(HandleChange change, bool snapping);
  void place_on_grid(Placement& placement, NodeId id, const std::vector<Snap>& contacts,
                     double step) const;
  bool is_along(int axis) const;
  std::string told(const glm::dvec3& offset) const;
  void show_contacts(const SnapScene& others, const std::vector<Snap>& contacts);

  Scene start_;
  Selection nodes_;
  Handles handles_;
  HandlePart part_;
  HandleDrag drag_;
  bool own_axes_;
  glm::dvec3 offset_{0};
  std::optional<SnapScene> others_;
  PullState state_;
};

}  // namespace sectile::viewer
