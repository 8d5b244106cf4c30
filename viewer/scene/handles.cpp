#include "scene/handles.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <limits>

#include "scene/transforms.h"

namespace sectile::viewer {

namespace {

constexpr double plane_from = 0.25, plane_to = 0.45;  // of the size: the squares of planes
constexpr int ring_steps = 96;

bool is_axis(HandlePart part) {
  return part <= HandlePart::axis_z;
}
bool is_plane(HandlePart part) {
  return part >= HandlePart::plane_x && part <= HandlePart::plane_z;
}
int axis_of(HandlePart part) {
  return static_cast<int>(part) % 3;  // of the centre: 0, which nobody uses
}

HandlePart part_of(HandlePart first, int axis) {
  return static_cast<HandlePart>(static_cast<int>(first) + axis);
}

double pixels_to_segment(glm::dvec2 p, glm::dvec2 a, glm::dvec2 b) {
  const glm::dvec2 d = b - a;
  const double length = glm::dot(d, d);
  const double t = length > 0 ? glm::clamp(glm::dot(p - a, d) / length, 0.0, 1.0) : 0.0;
  return glm::distance(p, a + d * t);
}

std::optional<glm::dvec3> on_plane(const Ray& ray, const glm::dvec3& point, const glm::dvec3& n) {
  const double slope = glm::dot(ray.direction, n);
  if (std::abs(slope) < 1e-3) return std::nullopt;
  return ray.origin + ray.direction * (glm::dot(point - ray.origin, n) / slope);
}

std::optional<glm::dvec3> on_line(const Ray& ray, const glm::dvec3& point, const glm::dvec3& d) {
  const double across = glm::dot(ray.direction, d), rest = 1 - across * across;
  if (rest < 1e-4) return std::nullopt;
  const glm::dvec3 w = point - ray.origin;
  return point + d * ((across * glm::dot(w, ray.direction) - glm::dot(w, d)) / rest);
}

}  // namespace

Handles Handles::at(HandleMode mode, const Transform& world, bool local_axes, const Camera& camera,
                    glm::dvec2 picture_size, double pixels) {
  Handles made;
  made.mode = mode;
  made.origin = {world.m[3], world.m[7], world.m[11]};
  if (local_axes) {
    const glm::dmat4 m = matrix_of(world);
    for (int i = 0; i < 3; ++i) {
      const double length = glm::length(glm::dvec3(m[i]));
      if (length > 0) made.axes[i] = glm::dvec3(m[i]) / length;
    }
  }
  made.size = pixels * camera.pixel_length(made.origin, picture_size);
  return made;
}

std::optional<HandlePart> Handles::part_at(const Camera& camera, glm::dvec2 pixel,
                                           glm::dvec2 picture_size, double reach) const {
  const auto seen = [&](const glm::dvec3& p) { return camera.project(p, picture_size); };
  std::optional<HandlePart> found;
  double nearest = std::numeric_limits<double>::infinity();
  const auto offer = [&](HandlePart part, double depth) {
    if (depth < nearest) nearest = depth, found = part;
  };
  if (glm::distance(glm::dvec2(seen(origin)), pixel) <= reach * 1.3) return HandlePart::centre;
  const Ray ray = camera.ray(pixel, picture_size);
  for (int i = 0; i < 3; ++i) {
    const glm::dvec3 u = axes[(i + 1) % 3], v = axes[(i + 2) % 3];
    if (mode == HandleMode::rotate) {
      for (int k = 0; k < ring_steps; ++k) {
        const double a = glm::two_pi<double>() * k / ring_steps;
        const double b = glm::two_pi<double>() * (k + 1) / ring_steps;
        // The half behind is not drawn.
        if (glm::dot(std::cos(a) * u + std::sin(a) * v, camera.forward()) > 0.15) continue;
        const glm::dvec3 p = seen(origin + size * (std::cos(a) * u + std::sin(a) * v));
        const glm::dvec3 q = seen(origin + size * (std::cos(b) * u + std::sin(b) * v));
        if (pixels_to_segment(pixel, p, q) <= reach) offer(part_of(HandlePart::ring_x, i), p.z);
      }
      continue;
    }
    const glm::dvec3 tip = seen(origin + size * axes[i]);
    if (pixels_to_segment(pixel, seen(origin), tip) <= reach)
      offer(part_of(HandlePart::axis_x, i), tip.z);
    const std::optional<glm::dvec3> hit = on_plane(ray, origin, axes[i]);
    if (!hit || mode != HandleMode::move) continue;
    const double a = glm::dot(*hit - origin, u) / size, b = glm::dot(*hit - origin, v) / size;
    if (a >= plane_from && a <= plane_to && b >= plane_from && b <= plane_to)
      offer(part_of(HandlePart::plane_x, i), seen(*hit).z);
  }
  return found;
}

glm::dvec3 Handles::grip(HandlePart part, const Camera& camera) const {
  const int axis = axis_of(part);
  const glm::dvec3 u = axes[(axis + 1) % 3], v = axes[(axis + 2) % 3];
  if (part == HandlePart::centre) return origin;
  if (is_axis(part)) return origin + 0.95 * size * axes[axis];
  if (is_plane(part)) return origin + 0.5 * (plane_from + plane_to) * size * (u + v);
  // Rings cross each other on the axes: half way between is free. In front, for the rest is hidden.
  glm::dvec3 nearest = u + v;
  for (const glm::dvec3& corner : {u - v, v - u, -u - v})
    if (glm::dot(corner - nearest, camera.forward()) < 0) nearest = corner;
  return origin + size * glm::normalize(nearest);
}

HandleDrag::HandleDrag(const Handles& handles, HandlePart part, const Ray& start,
                       const Camera& camera)
    : handles_(handles), part_(part), sight_(camera.forward()), up_(camera.up()) {
  direction_ = part == HandlePart::centre ? -sight_ : handles.axes[axis_of(part)];
  // A start that says nothing: from the origin, or on the ring from any of its places.
  const std::optional<glm::dvec3> found = place(start);
  const glm::dvec3 beside = handles.axes[(axis_of(part) + 1) % 3] * handles.size;
  start_ = found ? *found : handles.origin + (is_axis(part) ? direction_ * handles.size : beside);
  last_.axis = direction_;
}

std::optional<glm::dvec3> HandleDrag::place(const Ray& ray) const {
  if (is_axis(part_)) return on_line(ray, handles_.origin, direction_);
  return on_plane(ray, handles_.origin, direction_);
}

glm::dvec3 HandleDrag::moved(const glm::dvec3& place) const {
  glm::dvec3 by = place - start_;
  if (is_axis(part_)) {
    by = direction_ * glm::dot(by, direction_);
    return by;
  }
  if (is_plane(part_)) by -= direction_ * glm::dot(by, direction_);
  return by;
}

HandleChange HandleDrag::turned(const glm::dvec3& place) {
  const glm::dvec3 from = start_ - handles_.origin, to = place - handles_.origin;
  const double angle = std::atan2(glm::dot(glm::cross(from, to), direction_), glm::dot(from, to));
  // Turning on past half a turn goes on counting.
  const double half = glm::pi<double>();
  if (angle - last_angle_ > half) turns_ -= 1;
  if (angle - last_angle_ < -half) turns_ += 1;
  last_angle_ = angle;
  HandleChange made;
  made.axis = direction_;
  made.degrees = glm::degrees(angle) + 360 * turns_;
  return made;
}

HandleChange HandleDrag::scaled(const glm::dvec3& place) const {
  HandleChange made;
  constexpr double smallest = 0.01;
  if (part_ == HandlePart::centre) {
    const double along = glm::dot(place - start_, up_ + glm::cross(sight_, up_)) / handles_.size;
    made.scale = glm::dvec3(std::max(smallest, std::exp2(along)));
    return made;
  }
  const double from = glm::dot(start_ - handles_.origin, direction_);
  const double to = glm::dot(place - handles_.origin, direction_);
  if (from != 0) made.scale[axis_of(part_)] = std::max(smallest, to / from);
  return made;
}

HandleChange HandleDrag::change(const Ray& now) {
  const std::optional<glm::dvec3> at = place(now);
  if (!at) return last_;
  switch (handles_.mode) {
    case HandleMode::move:
      last_.move = moved(*at);
      break;
    case HandleMode::rotate:
      last_ = turned(*at);
      break;
    case HandleMode::scale:
      last_ = scaled(*at);
      break;
  }
  return last_;
}

std::vector<Vec3> HandleDrag::directions() const {
  if (is_axis(part_)) return {from_glm(direction_)};
  if (!is_plane(part_)) return {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const int i = axis_of(part_);
  return {from_glm(handles_.axes[(i + 1) % 3]), from_glm(handles_.axes[(i + 2) % 3])};
}

namespace {

double& coordinate(Vec3& v, int i) {
  return i == 0 ? v.x : i == 1 ? v.y : v.z;
}

/// The axis that a direction is, or -1; `sign` tells which way.
int exact_axis(const glm::dvec3& d, double& sign) {
  for (int i = 0; i < 3; ++i)
    if (std::abs(std::abs(d[i]) - 1) < 1e-12) {
      sign = d[i] < 0 ? -1 : 1;
      return i;
    }
  return -1;
}

double within_a_turn(double degrees) {
  return degrees > 180 || degrees <= -180 ? degrees - 360 * std::ceil((degrees - 180) / 360)
                                          : degrees;
}

/// Turns a placement about an axis given in the coordinates that it stands in.
Placement turned(const Placement& start, const glm::dvec3& axis, double degrees) {
  Placement made = start;
  double sign = 1;
  // Rotations go about x, then y, then z: about z it can only be the last one that changes; about
  // x and y only if nothing comes after.
  const int i = exact_axis(axis, sign);
  const Vec3& r = start.rotation;
  if (i == 2 || (i == 1 && r.z == 0) || (i == 0 && r.y == 0 && r.z == 0)) {
    double& angle = coordinate(made.rotation, i);
    angle = within_a_turn(angle + sign * degrees);
    return made;
  }
  // The first one also turns about the node's own x axis.
  Placement own = start;
  own.position = {0, 0, 0}, own.scale = {1, 1, 1};
  const Vec3 x = own.transform()({1, 0, 0});
  if (glm::dot(to_glm(x), axis) > 1 - 1e-14) {
    made.rotation.x = within_a_turn(start.rotation.x + degrees);
    return made;
  }
  const Transform turn = Transform::rotation_degrees(from_glm(axis), degrees);
  made.rotation = Placement::of(turn * own.transform()).rotation;
  return made;
}

/// Where a point of the world goes when the space around the handles is turned and scaled.
glm::dvec3 carried(const glm::dvec3& point, const Handles& handles, const HandleChange& change) {
  const glm::dvec3 away = point - handles.origin;
  if (away == glm::dvec3(0)) return point;
  const Transform turn = Transform::rotation_degrees(from_glm(change.axis), change.degrees);
  glm::dvec3 scaled(0);
  for (int i = 0; i < 3; ++i)
    scaled += handles.axes[i] * (change.scale[i] * glm::dot(handles.axes[i], away));
  return handles.origin + to_glm(turn(from_glm(change.scale == glm::dvec3(1) ? away : scaled)));
}

}  // namespace

Placement changed(const Placement& start, const Transform& parent, const Handles& handles,
                  const HandleChange& change) {
  const glm::dmat3 to_parent(matrix_of(inverse(parent)));
  Placement made = start;
  if (change.degrees != 0)
    made = turned(made, glm::normalize(to_parent * change.axis), change.degrees);
  const Transform world = parent * start.transform();
  const glm::dvec3 origin(world.m[3], world.m[7], world.m[11]);
  const glm::dvec3 move = change.move + carried(origin, handles, change) - origin;
  if (move != glm::dvec3(0)) {
    made.move(from_glm(to_parent * move));
  }
  if (change.scale != glm::dvec3(1)) {
    const glm::dmat3 own(matrix_of(parent * start.transform()));
    for (int i = 0; i < 3; ++i) {
      int nearest = 0;
      const auto alike = [&](int axis) { return std::abs(glm::dot(handles.axes[axis], own[i])); };
      for (int axis : {1, 2})
        if (alike(axis) > alike(nearest)) nearest = axis;
      coordinate(made.scale, i) *= change.scale[nearest];
    }
  }
  return made;
}

}  // namespace sectile::viewer
