#include "app/handles.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "picture/theme.h"
#include "scene/transforms.h"

namespace sectile::viewer {
namespace {

constexpr double length_in_units = 86;  // of a handle on the screen
constexpr double reach = 9;             // how near the pointer must be, on the screen
constexpr double snap_reach = 10;
constexpr double angle_step = 15, scale_step = 0.1, grid_step = 0.25;
constexpr std::size_t most_vertices = 4000;

glm::dvec3 axis_of(const Session& session, int axis) {
  glm::dvec3 direction(0);
  direction[axis] = 1;
  // What is stretched along other axes than its own would be sheared.
  if (!session.local_axes && session.handles != HandleMode::scale) return direction;
  const glm::dmat4 world = matrix_of(session.scene().world(session.selected()));
  const glm::dvec3 turned(world * glm::dvec4(direction, 0));
  const double length = glm::length(turned);
  return length > 0 ? turned / length : direction;
}

double distance_to_segment(glm::dvec2 p, glm::dvec2 a, glm::dvec2 b) {
  const glm::dvec2 ab = b - a;
  const double square = glm::dot(ab, ab);
  const double t = square > 0 ? std::clamp(glm::dot(p - a, ab) / square, 0.0, 1.0) : 0;
  return glm::length(p - a - t * ab);
}

/// Coordinates along a direction of the vertices of what is drawn of a node and below it.
void collect(const Session& session, NodeId id, const glm::dvec3& direction,
             std::vector<double>& values) {
  const Evaluation* evaluation = session.evaluation();
  const Evaluation::Entry* entry = evaluation ? evaluation->find(id) : nullptr;
  if (entry && entry->surface) {
    const glm::dmat4 world = matrix_of(session.scene().world(id));
    for (const glm::vec3& p : entry->surface->hard_edges) {
      if (values.size() >= most_vertices) return;
      values.push_back(glm::dot(direction, glm::dvec3(world * glm::dvec4(p, 1))));
    }
    return;
  }
  for (const NodeId child : session.scene().at(id).children)
    collect(session, child, direction, values);
}

}  // namespace

std::optional<glm::dvec3> pivot_of(const Session& session) {
  if (session.selection().empty() || !session.scene().find(session.selected())) return std::nullopt;
  const Bounds bounds = session.bounds_of(session.selected());
  const glm::dmat4 world = matrix_of(session.scene().world(session.selected()));
  const glm::dvec3 origin(world[3]);
  // Meshes may lie far from their origin: then the handles stand in their middle.
  const bool inside = !bounds.is_empty() && glm::all(glm::lessThanEqual(bounds.low, origin)) &&
                      glm::all(glm::lessThanEqual(origin, bounds.high));
  return inside || bounds.is_empty() ? origin : bounds.centre();
}

std::vector<Handle> handles_of(const Session& session) {
  std::vector<Handle> handles;
  const std::optional<glm::dvec3> pivot = pivot_of(session);
  if (!pivot || session.mode() != Mode::model) return handles;
  const double length = length_in_units * session.camera.pixel_length(*pivot, session.picture_size);
  for (int axis = 0; axis < 3; ++axis) {
    Handle handle;
    handle.axis = axis;
    handle.direction = axis_of(session, axis);
    if (session.handles == HandleMode::rotate) {
      const glm::dvec3 u = axis_of(session, (axis + 1) % 3), v = axis_of(session, (axis + 2) % 3);
      for (int i = 0; i <= 48; ++i) {
        const double angle = 2 * std::numbers::pi * i / 48;
        handle.points.push_back(*pivot + length * (std::cos(angle) * u + std::sin(angle) * v));
      }
      handle.grip = handle.points[6];
    } else {
      handle.grip = *pivot + length * handle.direction;
      handle.points = {*pivot + 0.12 * length * handle.direction, handle.grip};
    }
    handles.push_back(std::move(handle));
  }
  return handles;
}

std::optional<Handle> handle_at(const Session& session, glm::dvec2 pixel) {
  std::optional<Handle> nearest;
  double best = reach;
  for (Handle& handle : handles_of(session))
    for (std::size_t i = 0; i + 1 < handle.points.size(); ++i) {
      const glm::dvec3 a = session.camera.project(handle.points[i], session.picture_size);
      const glm::dvec3 b = session.camera.project(handle.points[i + 1], session.picture_size);
      const double distance = distance_to_segment(pixel, a, b);
      if (distance >= best) continue;
      best = distance;
      nearest = handle;
    }
  return nearest;
}

void add_handles(Picture& picture, const Session& session, int active_axis) {
  const Theme& colours = theme(session.view.dark);
  const std::array<Colour, 3> of_axis{colours.handle_x, colours.handle_y, colours.handle_z};
  for (const Handle& handle : handles_of(session)) {
    const Colour colour = handle.axis == active_axis
                              ? colours.handle_active
                              : of_axis[static_cast<std::size_t>(handle.axis)];
    Lines lines;
    for (std::size_t i = 0; i + 1 < handle.points.size(); ++i)
      lines.ends.insert(lines.ends.end(), {handle.points[i], handle.points[i + 1]});
    lines.colour = colour;
    lines.width = 3.5f;
    lines.on_top = true;
    picture.lines.push_back(std::move(lines));
    Points grip;
    grip.places = {handle.grip};
    grip.colour = colour;
    grip.size = session.handles == HandleMode::move ? 13 : 10;
    picture.points.push_back(std::move(grip));
  }
}

HandlePull::HandlePull(const Session& session, Handle handle, glm::dvec2 pixel)
    : start_(session.scene()),
      nodes_(session.topmost_selected()),
      handle_(std::move(handle)),
      mode_(session.handles),
      pivot_(*pivot_of(session)) {
  began_ = mode_ == HandleMode::rotate ? angle(session.camera, pixel, session.picture_size)
                                       : along(session.camera, pixel, session.picture_size);
  for (const NodeId id : start_.in_order()) {
    const Node& node = start_.at(id);
    if (!node.children.empty() || !start_.is_shown(id)) continue;
    const bool dragged = std::any_of(nodes_.begin(), nodes_.end(), [&](NodeId moved_node) {
      return start_.is_below(id, moved_node);
    });
    collect(session, id, handle_.direction, dragged ? own_ : others_);
  }
  std::sort(others_.begin(), others_.end());
}

double HandlePull::along(const Camera& camera, glm::dvec2 pixel, glm::dvec2 size) const {
  // The point of the axis nearest to the ray of the pointer.
  const Ray ray = camera.ray(pixel, size);
  const glm::dvec3 across = glm::cross(ray.direction, handle_.direction);
  const double square = glm::dot(across, across);
  if (square < 1e-9) return began_;
  return glm::dot(glm::cross(ray.origin - pivot_, ray.direction), across) / -square;
}

double HandlePull::angle(const Camera& camera, glm::dvec2 pixel, glm::dvec2 size) const {
  const glm::dvec3 centre = camera.project(pivot_, size);
  const double on_screen = std::atan2(-(pixel.y - centre.y), pixel.x - centre.x);
  // Counter-clockwise on the screen is positive about axes that point to the viewer.
  const bool towards = glm::dot(handle_.direction, camera.forward()) < 0;
  return (towards ? on_screen : -on_screen) * 180 / std::numbers::pi;
}

double HandlePull::snapped_offset(const Session& session, double offset) const {
  double best = snap_reach * session.camera.pixel_length(pivot_, session.picture_size);
  std::optional<double> contact;
  for (const double own : own_) {
    const auto next = std::lower_bound(others_.begin(), others_.end(), own + offset);
    for (auto it = next == others_.begin() ? next : std::prev(next);
         it != others_.end() && it <= next; ++it)
      if (std::abs(*it - own - offset) < best) {
        best = std::abs(*it - own - offset);
        contact = *it - own;
      }
  }
  return contact ? *contact : std::round(offset / grid_step) * grid_step;
}

const char* HandlePull::description() const {
  return mode_ == HandleMode::move ? "Move" : mode_ == HandleMode::rotate ? "Rotate" : "Scale";
}

Scene HandlePull::pulled(const Session& session, glm::dvec2 pixel, bool snapping,
                         bool uniform) const {
  Scene scene = start_;
  const double now = mode_ == HandleMode::rotate
                         ? angle(session.camera, pixel, session.picture_size)
                         : along(session.camera, pixel, session.picture_size);
  double by = now - began_;
  if (mode_ == HandleMode::scale) by = began_ != 0 ? now / began_ : 1;
  if (snapping && mode_ == HandleMode::move) by = snapped_offset(session, by);
  if (snapping && mode_ == HandleMode::rotate) by = std::round(by / angle_step) * angle_step;
  if (snapping && mode_ == HandleMode::scale) by = std::round(by / scale_step) * scale_step;
  for (const NodeId id : nodes_) {
    Placement& placement = scene.edit(id).placement;
    const Transform parent = start_.world_of_parent(id);
    if (mode_ == HandleMode::move) {
      const glm::dmat4 back = matrix_of(inverse(parent));
      const glm::dvec3 offset(back * glm::dvec4(by * handle_.direction, 0));
      placement.position = from_glm(to_glm(placement.position) + offset);
    } else if (mode_ == HandleMode::rotate) {
      const Transform turn = Transform::translation(from_glm(pivot_)) *
                             (Transform::rotation_degrees(from_glm(handle_.direction), by) *
                              Transform::translation(from_glm(-pivot_)));
      placement = Placement::of(inverse(parent) * (turn * start_.world(id)));
    } else {
      const double factor = std::max(by, 0.05);
      if (uniform || handle_.axis == 0) placement.scale.x *= factor;
      if (uniform || handle_.axis == 1) placement.scale.y *= factor;
      if (uniform || handle_.axis == 2) placement.scale.z *= factor;
    }
  }
  return scene;
}

}  // namespace sectile::viewer
