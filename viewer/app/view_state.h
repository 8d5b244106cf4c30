// From where a person looks at the scene, what is shown of it, and how it is taken hold of.
#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <vector>

#include "app/view_settings.h"
#include "picture/camera.h"
#include "picture/picture.h"
#include "scene/handles.h"
#include "scene/scene.h"
#include "story/story.h"

namespace sectile::viewer {

/// From where the sphere of a step is seen; it turns to what is to be seen at each new step.
struct SphereTurn {
  std::shared_ptr<const Story> story;
  std::size_t step = 0;
  Camera camera;
};

struct ViewState : ViewSettings {
  /// The plane of the section in world coordinates: cut away is what lies on its positive side.
  glm::dvec4 section_plane() const;
  void look_at(const Bounds& bounds);  ///< stays if they are empty

  Camera camera;
  glm::dvec2 picture_size{800, 600};
  HandleMode handles = HandleMode::move;
  bool local_axes = false;
  bool snapping = true;
  NodeId presented = 0;  ///< of a sample: its operands are shown alone until something is selected
  std::vector<LegendKey> legend;  ///< of the picture in the last frame
  SphereTurn sphere_turn;
};

}  // namespace sectile::viewer
