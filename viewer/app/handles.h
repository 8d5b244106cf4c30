// The handles of the selected solids: lines to pull, circles to turn.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "app/session.h"
#include "picture/picture.h"

namespace sectile::viewer {

struct Handle {
  int axis = 0;                    ///< 0, 1, 2
  glm::dvec3 direction{1, 0, 0};   ///< of the axis, in the world
  std::vector<glm::dvec3> points;  ///< the line or the circle
  glm::dvec3 grip{0};              ///< where it is taken most easily
};

/// Where the handles stand: the origin of the solid selected last. Empty if nothing is selected.
std::optional<glm::dvec3> pivot_of(const Session& session);
std::vector<Handle> handles_of(const Session& session);
/// The handle under the pointer.
std::optional<Handle> handle_at(const Session& session, glm::dvec2 pixel);
void add_handles(Picture& picture, const Session& session, int active_axis);

/// Pulling one handle, from press to release.
class HandlePull {
 public:
  HandlePull(const Session& session, Handle handle, glm::dvec2 pixel);
  /// The scene with the handle pulled to the pointer. `uniform`: scaled along all axes.
  Scene pulled(const Session& session, glm::dvec2 pixel, bool snapping, bool uniform) const;
  const char* description() const;
  int axis() const { return handle_.axis; }

 private:
  double along(const Camera& camera, glm::dvec2 pixel, glm::dvec2 size) const;
  double angle(const Camera& camera, glm::dvec2 pixel, glm::dvec2 size) const;
  double snapped_offset(const Session& session, double offset) const;

  Scene start_;
  std::vector<NodeId> nodes_;
  Handle handle_;
  HandleMode mode_;
  glm::dvec3 pivot_;
  double began_ = 0;
  std::vector<double> own_, others_;  ///< vertices along the axis, for snapping
};

}  // namespace sectile::viewer
