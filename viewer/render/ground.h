// What is around the solids: background, ground grid and axes.
#pragma once

#include "render/marks.h"
#include "render/shader_program.h"
#include "render/view.h"

namespace sectile::viewer {

/// How the grid lies for a camera: on the ground, or across the view where that is along x or y.
struct Ground {
  int first = 0, second = 1;  ///< the axes of its plane
  glm::dvec3 base{0};         ///< a point of the plane; zero along its axes
  glm::dvec2 centre{0};       ///< a grid point near the camera's target
  double reach = 1;           ///< half the length of the square; the lines have faded there
  double step = 1;
  double fine = 1;  ///< how visible the lines of `step` are; those of ten steps are always

  static Ground of(const Picture& picture, glm::dvec2 size);
  bool is_upright() const { return second == 2; }
  Bounds bounds() const;
};

class GroundDrawer {
 public:
  GroundDrawer();
  void draw_background(const View& view);
  /// On the ground it has the depth of the opaque faces; upright, it lies behind everything.
  void draw_ground(const View& view, const Ground& ground, MarkDrawer& marks);

 private:
  void draw_vertical_axis(const View& view, const Ground& ground, MarkDrawer& marks);

  ShaderProgram background_, ground_;
  GlVertexArray nothing_;
};

}  // namespace sectile::viewer
