#include "render/ground.h"

#include <algorithm>
#include <cmath>

namespace sectile::viewer {

namespace {

constexpr double nearly_level = 0.02;  // radians

// The axis that the camera looks along from the side; -1 for all other views.
int side_view(const Camera& camera) {
  const glm::dvec3 f = glm::abs(camera.forward());
  const double least = std::cos(nearly_level);
  return f.x > least ? 0 : f.y > least ? 1 : -1;
}

glm::vec3 unit(int axis) {
  glm::vec3 v(0);
  v[axis] = 1;
  return v;
}

glm::vec3 colour_of_axis(const Surroundings& around, int axis) {
  return glm::vec3(axis == 0 ? around.axis_x : axis == 1 ? around.axis_y : around.axis_z);
}

}  // namespace

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
  if (const int along = side_view(camera); along >= 0) {
    ground.first = 1 - along;
    ground.second = 2;
    ground.base[along] = camera.target[along];
  }
  const glm::dvec2 target(camera.target[ground.first], camera.target[ground.second]);
  ground.centre = glm::round(target / coarse) * coarse;
  return ground;
}

Bounds Ground::bounds() const {
  Bounds box;
  if (is_upright()) return box;
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
  ground_.set("base", glm::vec3(ground.base));
  ground_.set("first", unit(ground.first));
  ground_.set("second", unit(ground.second));
  ground_.set("backmost", ground.is_upright() ? 1 : 0);
  const glm::dvec2 target(camera.target[ground.first], camera.target[ground.second]);
  ground_.set("target", glm::vec2(target - ground.centre));
  ground_.set("reach", static_cast<float>(ground.reach));
  // Behind faces that lie in the ground.
  ground_.set("depth_shift", 4e-4f);
  ground_.set("step_size", static_cast<float>(ground.step));
  ground_.set("fine", static_cast<float>(ground.fine));
  ground_.set("line_width", view.scale);
  ground_.set("show_grid", around.show_grid ? 1 : 0);
  ground_.set("show_axes", around.show_axes ? 1 : 0);
  ground_.set("grid_colour", around.grid);
  ground_.set("first_colour", colour_of_axis(around, ground.first));
  ground_.set("second_colour", colour_of_axis(around, ground.second));
  // Seen from the side the lines would run together, and from below they are in the way.
  const double steepness = std::clamp(std::abs(camera.forward().z) * 6 - 0.1, 0.0, 1.0);
  const double strength = camera.position().z < 0 ? 0.45 : 1.0;
  ground_.set("strength", static_cast<float>(ground.is_upright() ? 0.8 : steepness * strength));
  if (ground.is_upright()) glDisable(GL_DEPTH_TEST);
  glEnable(GL_BLEND);
  glDepthMask(GL_FALSE);
  glBindVertexArray(nothing_.id());
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
  glEnable(GL_DEPTH_TEST);
  if (around.show_axes && !ground.is_upright()) draw_vertical_axis(view, ground, marks);
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
