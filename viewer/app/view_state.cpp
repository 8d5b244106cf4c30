#include "app/view_state.h"

#include <cmath>

namespace sectile::viewer {

glm::dvec4 ViewState::section_plane() const {
  glm::dvec4 plane{0, 0, 0, -section_place};
  if (section_oblique)
    plane = {section_normal, -section_place};
  else
    plane[section_axis] = 1;
  return section_flipped ? -plane : plane;
}

void ViewState::look_at(const Bounds& bounds) {
  if (!bounds.is_empty()) camera.look_at(bounds, picture_size.x / picture_size.y);
}

void ViewSettings::set_section(const glm::dvec3& normal, double place) {
  section_oblique = true;
  section_normal = normal;
  section_place = place;
  section_flipped = false;
  for (int axis = 0; axis < 3; ++axis)
    if (std::abs(normal[axis]) == 1) {
      section_oblique = false;
      section_axis = axis;
      section_flipped = normal[axis] < 0;
      section_place = normal[axis] * place;
    }
}

}  // namespace sectile::viewer
