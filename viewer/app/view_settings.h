// What of the scene the picture shows, and how.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

namespace sectile::viewer {

/// What is drawn of a Boolean whose operands are being worked on.
enum class Shown : std::uint8_t { both, result, operands };

struct ViewSettings {
  bool dark = false;
  bool grid = true, axes = true;
  bool wireframe = false;
  bool hidden_lines = false;  ///< edges behind faces, faintly
  bool labels = false;
  bool eight_way = false;
  double exploded = 0.2;     ///< 0 … 1, of the story's pictures
  bool section = false;      ///< the section plane cuts
  int section_axis = 0;      ///< x, y, z
  double section_place = 0;  ///< along the axis
  bool section_flipped = false;
  bool section_oblique = false;  ///< across section_normal instead of an axis
  glm::dvec3 section_normal{0, 0, 1};
  /// Cut away is what lies farther along a direction of length one than `place`.
  void set_section(const glm::dvec3& normal, double place);
  Shown shown = Shown::both;
  bool follow_steps = true;  ///< the camera goes to the place of each step
  bool hints = true;
  bool dimensions = false;  ///< the box around the selection; in a drag always
  bool cube = true;         ///< the view cube
  // Sizes that a person dragged panels to; 0: as usual.
  double left_model = 0, left_steps = 0, right_steps = 0, sphere = 0;
};

}  // namespace sectile::viewer
