// What all parts of the drawing know about the picture that is being drawn.
#pragma once

#include "picture/picture.h"

namespace sectile::viewer {

struct View {
  const Picture& picture;
  glm::dmat4 to_clip;
  glm::dvec2 size;  ///< in pixels
  float scale = 1;  ///< pixels for each unit of widths and sizes
  glm::dvec3 key_light;

  bool is_fast() const { return picture.quality == Quality::fast; }

  /// The section's plane for shaders, in the coordinates of a model: what is on its negative side
  /// is cut away.
  glm::vec4 kept_side(const glm::dmat4& model = glm::dmat4(1)) const {
    if (!picture.section.active) return {0, 0, 0, 1};
    return glm::vec4(-(glm::transpose(model) * picture.section.plane));
  }
};

}  // namespace sectile::viewer
