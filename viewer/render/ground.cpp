#include "render/ground.h"

#include <algorithm>
#include <cmath>

namespace sectile::viewer {

Ground Ground::of(const Picture& picture, glm::dvec2 size) {
  const Camera& camera = picture.camera;
  Ground ground;
  ground.reach = camera.distance * 3;
  const double pixel = camera.pixel_length(camera.target, size);
  // Steps get ten times longer when the lines would be closer than a few pixels.
  const double wished = 9 * pixel / picture.surroundings.grid_step;
  const double tens = std::max(0.0, std::log10(std::max(wished, 1e-300)));
  ground.step = picture.surroundings.grid_step * std::pow(10, std::floor(tens));
  ground.fine = 1 - (tens - std::floor(tens));
  const double coarse = 10 * ground.step;
  ground.centre = glm::round(glm::dvec2(camera.target) / coarse) * coarse;
  return ground;
}

Bounds Ground::bounds() const {
  Bounds box;
  box.add(glm::dvec3(centre - reach, 0));
  box.add(glm::dvec3(centre + reach, 0));
  return box;
}

GroundDrawer::GroundDrawer()
    : background_("whole_picture.vert", "background.frag"), ground_("ground.vert", "ground.frag") {}

void GroundDrawer::draw_background(const View& view) {
  const Surroundings& around = view.picture.surroundings;
  glDisable(GL_DEPTH_TEST);
  background_.use();
  background_.set("top", glm::vec3(around.background_top));
  background_.set("bottom", glm::vec3(around.background_bottom));
  glBindVertexArray(nothing_.id());
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glEnable(GL_DEPTH_TEST);
}

void GroundDrawer::draw_ground(const View& view, const Ground& ground, MarkDrawer& marks) {
  const Surroundings& around = view.picture.surroundings;
  const Camera& camera = view.picture.camera;
  if (!around.show_grid && !around.show_axes) return;
  ground_.use();
  ground_.set("to_clip", glm::mat4(view.to_clip));
  ground_.set("centre", glm::vec2(ground.centre));
  ground_.set("target", glm::vec2(glm::dvec2(camera.target) - ground.centre));
  ground_.set("reach", static_cast<float>(ground.reach));
  // Behind faces that lie in the ground.
  ground_.set("depth_shift", 4e-4f);
  ground_.set("step_size", static_cast<float>(ground.step));
  ground_.set("fine", static_cast<float>(ground.fine));
  ground_.set("line_width", view.scale);
  ground_.set("show_grid", around.show_grid ? 1 : 0);
  ground_.set("show_axes", around.show_axes ? 1 : 0);
  ground_.set("grid_colour", around.grid);
  ground_.set("x_colour", glm::vec3(around.axis_x));
  ground_.set("y_colour", glm::vec3(around.axis_y));
  // Seen from the side the lines would run together, and from below they are in the way.
  const double steepness = std::clamp(std::abs(camera.forward().z) * 6 - 0.1, 0.0, 1.0);
  const double strength = camera.position().z < 0 ? 0.45 : 1.0;
  ground_.set("strength", static_cast<float>(steepness * strength));
  glEnable(GL_BLEND);
  glDepthMask(GL_FALSE);
  glBindVertexArray(nothing_.id());
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
  if (around.show_axes) draw_vertical_axis(view, ground, marks);
}

// Fades upwards, in pieces.
void GroundDrawer::draw_vertical_axis(const View& view, const Ground& ground, MarkDrawer& marks) {
  const double length = ground.reach * 0.12;
  const int pieces = 12;
  for (int i = 0; i < pieces; ++i) {
    const auto at = [&](int k) { return glm::vec3(0, 0, static_cast<float>(length * k / pieces)); };
    Colour colour = view.picture.surroundings.axis_z;
    colour.a *= 0.9f * (1 - static_cast<float>(i) / pieces);
    marks.draw_line(view, {at(i), at(i + 1)}, colour, 1.6f);
  }
}

}  // namespace sectile::viewer
