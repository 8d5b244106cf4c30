#include "app/handle_pull.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "app/words.h"
#include "picture/theme.h"
#include "scene/transforms.h"

namespace sectile::viewer {
namespace {

constexpr double snap_reach = 10;  // on the screen
constexpr double angle_step = 15, scale_step = 0.1;
constexpr double least_grid_step = 20;  // on the screen
constexpr const char* axis_names[] = {"x", "y", "z"};

/// Meshes may lie far from their origin: then the handles stand in their middle.
glm::dvec3 pivot_of(const Session& session, const glm::dvec3& origin) {
  const Bounds bounds = session.bounds_of(session.selected());
  const bool inside = !bounds.is_empty() && glm::all(glm::lessThanEqual(bounds.low, origin)) &&
                      glm::all(glm::lessThanEqual(origin, bounds.high));
  return inside || bounds.is_empty() ? origin : bounds.centre();
}

/// 1, 2.5 or 5 times a power of ten that is well seen on the screen.
double grid_step(const ViewState& view, const glm::dvec3& place) {
  const double least = least_grid_step * view.camera.pixel_length(place, view.picture_size);
  const double decade = std::pow(10, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.5, 5.0})
    if (factor * decade >= least) return factor * decade;
  return 10 * decade;
}

const char* name_of(Snap::Kind kind) {
  switch (kind) {
    case Snap::Kind::vertex_vertex:
      return "vertex on vertex";
    case Snap::Kind::edge_edge:
      return "edge on edge";
    case Snap::Kind::vertex_edge:
      return "vertex on edge";
    case Snap::Kind::edge_vertex:
      return "edge on vertex";
    case Snap::Kind::face_face:
      return "face on face";
    case Snap::Kind::vertex_face:
      return "vertex in the plane of a face";
    case Snap::Kind::face_vertex:
      return "face level with a vertex";
  }
  return "";
}

/// Above the handles, but not outside of the picture.
glm::dvec3 place_of_text(const Handles& handles, const ViewState& view) {
  const glm::dvec2 size = view.picture_size;
  const glm::dvec3 above = handles.origin + 1.3 * handles.size * view.camera.up();
  const glm::dvec2 pixel(view.camera.project(above, size));
  const glm::dvec2 most = glm::max(glm::dvec2(8, 24), size - glm::dvec2(260, 80));
  const Ray ray = view.camera.ray(glm::clamp(pixel, glm::dvec2(8, 24), most), size);
  return ray.origin + view.camera.distance * ray.direction;
}

bool is_axis(HandlePart part) {
  return part <= HandlePart::axis_z;
}
int axis_of(HandlePart part) {
  return static_cast<int>(part) % 3;
}

double& coordinate(Vec3& v, int i) {
  return i == 0 ? v.x : i == 1 ? v.y : v.z;
}

}  // namespace

std::optional<Handles> handles_of(const Session& session) {
  // What is stretched along other axes than its own would be sheared.
  return handles_of(session, session.view.local_axes || session.view.handles == HandleMode::scale);
}

std::optional<Handles> handles_of(const Session& session, bool own_axes) {
  const NodeId id = session.selected();
  if (!session.is_modelling() || !session.scene().find(id)) return std::nullopt;
  Transform world = session.scene().world(id);
  const glm::dvec3 pivot = pivot_of(session, {world.m[3], world.m[7], world.m[11]});
  world.m[3] = pivot.x, world.m[7] = pivot.y, world.m[11] = pivot.z;
  return Handles::at(session.view.handles, world, own_axes, session.view.camera,
                     session.view.picture_size);
}

HandlePull::HandlePull(const Session& session, const Handles& handles, HandlePart part,
                       glm::dvec2 pixel)
    : HandlePull(session, handles, part, pixel, session.view.local_axes) {}

HandlePull::HandlePull(const Session& session, const Handles& handles, HandlePart part,
                       glm::dvec2 pixel, bool own_axes)
    : start_(session.scene()),
      nodes_(session.topmost_selected()),
      handles_(handles),
      part_(part),
      drag_(handles, part, session.view.camera.ray(pixel, session.view.picture_size),
            session.view.camera),
      own_axes_(own_axes) {}

void add_marks(Picture& picture, const ViewState& view, const Handles& handles,
               const PullState& state) {
  const Theme& colours = theme(view.dark);
  if (!state.edges.empty()) picture.lines.push_back({state.edges, colours.step, 4, true});
  if (!state.points.empty()) picture.points.push_back({state.points, colours.step, 12});
  if (!state.text.empty())
    picture.labels.push_back({place_of_text(handles, view), state.text, colours.text, true});
}

Handles HandlePull::handles() const {
  Handles now = handles_;
  now.origin += offset_;
  return now;
}

void HandlePull::pull(Session& session, glm::dvec2 pixel, bool snapping, KnownTargets& known) {
  show(session, drag_.change(session.view.camera.ray(pixel, session.view.picture_size)), snapping,
       known);
}

void HandlePull::show(Session& session, const HandleChange& change, bool snapping,
                      KnownTargets& known) {
  state_ = {};
  const bool moves = handles_.mode == HandleMode::move;
  Scene scene =
      moves ? moved(session, change.move, snapping, known) : turned_or_scaled(change, snapping);
  const char* what = moves ? "Move" : handles_.mode == HandleMode::rotate ? "Rotate" : "Scale";
  session.document.show_draft(what, std::move(scene));
}

Scene HandlePull::moved(Session& session, const glm::dvec3& offset, bool snapping,
                        KnownTargets& known) {
  if (!snapping) return moved_by(offset);
  if (!others_) others_.emplace(session.scene(), session.results, nodes_, known);
  if (std::optional<Scene> scene = moved_into_contact(session, offset, *others_)) return *scene;
  return moved_on_grid(session, offset);
}

Scene HandlePull::moved_by(const glm::dvec3& offset) {
  HandleChange change;
  change.move = offset_ = offset;
  Scene scene = start_;
  for (const NodeId id : nodes_)
    scene.edit(id).placement =
        changed(start_.at(id).placement, start_.world_of_parent(id), handles_, change);
  state_.text = told(offset) + state_.text;
  return scene;
}

/// May the drag move along this axis of the handles?
bool HandlePull::is_along(int axis) const {
  return part_ == HandlePart::centre || is_axis(part_) == (axis_of(part_) == axis);
}

Scene HandlePull::moved_on_grid(const Session& session, const glm::dvec3& offset) {
  const double step = grid_step(session.view, handles_.origin);
  glm::dvec3 snapped_offset(0);
  for (int axis = 0; axis < 3; ++axis) {
    if (!is_along(axis)) continue;
    const double by = glm::dot(offset, handles_.axes[axis]);
    // Along the world's axes places are round, along others distances.
    const double from = own_axes_ ? 0 : handles_.origin[axis];
    snapped_offset += handles_.axes[axis] * (snapped(from + by, step) - from);
  }
  Scene scene = moved_by(snapped_offset);
  const NodeId last = nodes_.back();
  Placement placed = scene.at(last).placement;
  place_on_grid(placed, last, {}, step);
  if (placed == scene.at(last).placement) return scene;
  // All others move as the last one does: what is flush stays so.
  const Shift shift = shift_between(start_.at(last).placement, placed);
  for (const NodeId id : nodes_)
    if (start_.exact_world_of_parent(id).is_identity())
      scene.edit(id).placement = shifted(start_.at(id).placement, shift);
  scene.edit(last).placement = placed;
  return scene;
}

/// Coordinates that a drag along the world's axes may change, and no contact fixes, become round.
void HandlePull::place_on_grid(Placement& placement, NodeId id, const std::vector<Snap>& contacts,
                               double step) const {
  if (own_axes_ || !start_.exact_world_of_parent(id).is_identity()) return;
  const Placement& start = start_.at(id).placement;
  for (int axis = 0; axis < 3; ++axis) {
    const bool is_fixed = std::any_of(contacts.begin(), contacts.end(), [&](const Snap& contact) {
      return contact.fixed[static_cast<std::size_t>(axis)];
    });
    Vec3 before = start.position, rest = start.remainder;
    if (is_fixed || !is_along(axis) ||
        coordinate(before, axis) + coordinate(rest, axis) != handles_.origin[axis])
      continue;
    double& now = coordinate(placement.position, axis);
    now = snapped(now, step);
    coordinate(placement.remainder, axis) = 0;
  }
}

/// Which coordinates of a placement the handle can move at all.
std::array<bool, 3> HandlePull::reached_coordinates(NodeId id) const {
  Transform linear = start_.world_of_parent(id);
  linear.m[3] = linear.m[7] = linear.m[11] = 0;
  const Transform back = inverse(linear);
  std::array<bool, 3> reached{};
  for (const Vec3& direction : drag_.directions()) {
    const glm::dvec3 own(matrix_of(back) * glm::dvec4(to_glm(direction), 0));
    for (int axis = 0; axis < 3; ++axis) reached[static_cast<std::size_t>(axis)] |= own[axis] != 0;
  }
  return reached;
}

/// A handle of an axis moves along that axis and nowhere else, by not even the last bit.
void HandlePull::keep_on_axis(Placement& placement, NodeId id) {
  const std::array<bool, 3> reached = reached_coordinates(id);
  Placement start = start_.at(id).placement;
  for (int axis = 0; axis < 3; ++axis) {
    double& now = coordinate(placement.position, axis);
    double& rest = coordinate(placement.remainder, axis);
    const double before = coordinate(start.position, axis);
    const double rest_before = coordinate(start.remainder, axis);
    if (reached[static_cast<std::size_t>(axis)] || (now == before && rest == rest_before)) continue;
    now = before, rest = rest_before;
    state_.leaves_axis = true;
  }
}

std::optional<Scene> HandlePull::moved_into_contact(const Session& session,
                                                    const glm::dvec3& offset, SnapScene& others) {
  const double reach = snap_reach * session.view.camera.pixel_length(handles_.origin + offset,
                                                                     session.view.picture_size);
  const Snaps found = others.find(offset, reach, drag_.directions());
  if (found.gave_up) state_.text = " \u00B7 too much within reach: grid only";
  if (found.contacts.empty()) return std::nullopt;
  const std::vector<Snap>& contacts = found.contacts;
  state_.is_contact = true;
  Scene scene = start_;
  const Landings landings =
      placed_by(others.dragged_nodes(start_), contacts.back().offset, contacts);
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    Placement& placement = scene.edit(nodes_[i]).placement;
    placement = landings.placements[i];
    keep_on_axis(placement, nodes_[i]);
    if (nodes_.size() == 1 && is_identity(others.frame()))
      place_on_grid(placement, nodes_[i], contacts, grid_step(session.view, handles_.origin));
  }
  state_.is_exact = landings.is_exact && !state_.leaves_axis &&
                    std::all_of(contacts.begin(), contacts.end(),
                                [&](const Snap& contact) { return others.is_known(contact); });
  const Transform before = start_.world(nodes_.back()), after = scene.world(nodes_.back());
  offset_ = {after.m[3] - before.m[3], after.m[7] - before.m[7], after.m[11] - before.m[11]};
  state_.text = told(offset_);
  show_contacts(others, contacts);
  return scene;
}

void HandlePull::show_contacts(const SnapScene& others, const std::vector<Snap>& contacts) {
  std::vector<std::string> names;
  const glm::dmat4 frame = matrix_of(others.frame());
  const auto in_world = [&](const Vec3& p) {
    return glm::vec3(glm::dvec3(frame * glm::dvec4(to_glm(p), 1)));
  };
  for (const Snap& contact : contacts) {
    const std::string name = name_of(contact.kind);
    if (!std::count(names.begin(), names.end(), name)) names.push_back(name);
    for (const Vec3& end : contact.shown) state_.edges.push_back(in_world(end));
    const bool is_point = contact.fixed == Coordinates{true, true, true};
    if (is_point || contact.kind == Snap::Kind::face_vertex)
      state_.points.push_back(in_world(contact.to));
  }
  state_.text += " \u00B7 ";
  for (std::size_t i = 0; i < names.size(); ++i) state_.text += (i > 0 ? ", " : "") + names[i];
  state_.text += state_.is_exact      ? ": exact"
                 : state_.leaves_axis ? ": near, not exact (it lies beside the way of this handle)"
                                      : ": near, not exact (no sum of two doubles lies there)";
}

Scene HandlePull::turned_or_scaled(HandleChange change, bool snapping) {
  if (snapping) {
    change.degrees = snapped(change.degrees, angle_step);
    for (int axis = 0; axis < 3; ++axis)
      change.scale[axis] = std::max(scale_step, snapped(change.scale[axis], scale_step));
  }
  Scene scene = start_;
  for (const NodeId id : nodes_)
    scene.edit(id).placement =
        changed(start_.at(id).placement, start_.world_of_parent(id), handles_, change);
  const bool has_axis = part_ != HandlePart::centre;
  const bool in_plane = part_ >= HandlePart::plane_x && part_ <= HandlePart::plane_z;
  const std::string axis = has_axis && !in_plane ? axis_names[axis_of(part_)] : "";
  if (handles_.mode == HandleMode::rotate)
    state_.text = (has_axis ? "About " + axis + "  " : "") + number(change.degrees) + "\u00B0";
  else
    state_.text = (has_axis ? axis + "  " : "") + "\u00D7 " +
                  number(change.scale[in_plane ? (axis_of(part_) + 1) % 3 : axis_of(part_)]);
  return scene;
}

std::string HandlePull::told(const glm::dvec3& offset) const {
  std::string text;
  for (int axis = 0; axis < 3; ++axis) {
    if (!is_along(axis)) continue;
    const double by = glm::dot(offset, handles_.axes[axis]);
    char value[32];
    std::snprintf(value, sizeof value, "%.5g", std::abs(by) < 1e-9 ? 0.0 : by);
    text += (text.empty() ? "" : "   ") + std::string(own_axes_ ? "own " : "") + axis_names[axis] +
            " " + (by > 1e-9 ? "+" : "") + value;
  }
  return text;
}

}  // namespace sectile::viewer
