#include "app/pattern_tools.h"

#include <cmath>

#include "picture/theme.h"
#include "scene/measuring.h"
#include "scene/transforms.h"

namespace sectile::viewer {
namespace {

Vec3 carried(const Transform& map, const Vec3& p) {
  return is_identity(map) ? p : map(p);
}

/// A direction in the coordinates that `to_world` starts from.
Vec3 turned_back(const Transform& to_world, const Vec3& direction) {
  if (is_identity(to_world)) return direction;
  return from_glm(glm::dmat3(matrix_of(inverse(to_world))) * to_glm(direction));
}

Pattern in_frame(Pattern pattern, const Transform& frame) {
  const Transform back = is_identity(frame) ? frame : inverse(frame);
  pattern.centre = carried(back, pattern.centre);
  for (Vec3& corner : pattern.path) corner = carried(back, corner);
  pattern.step = turned_back(frame, pattern.step);
  // What is at right angles to a plane goes the other way round than what lies in it.
  if (pattern.kind == Pattern::Kind::mirror && !is_identity(frame))
    pattern.axis = from_glm(glm::transpose(glm::dmat3(matrix_of(frame))) * to_glm(pattern.axis));
  else
    pattern.axis = turned_back(frame, pattern.axis);
  return pattern;
}

Vec3 middle_of(const SnapFeatures::Face& face) {
  return {0.5 * (face.low.x + face.high.x), 0.5 * (face.low.y + face.high.y),
          0.5 * (face.low.z + face.high.z)};
}

/// Normals are computed from corners: those along an axis are meant to be.
Vec3 tidy(const Vec3& n) {
  const glm::dvec3 d = to_glm(n);
  for (int i = 0; i < 3; ++i)
    if (std::abs(d[i]) > 1 - 1e-12) {
      glm::dvec3 axis(0);
      axis[i] = d[i] > 0 ? 1 : -1;
      return from_glm(axis);
    }
  return n;
}

/// Circles through doubles have their centres within rounding of where they were meant.
Vec3 tidy_centre(const Circle& circle) {
  const auto round = [&](double value) {
    const double near = std::round(value * 4096) / 4096;
    return std::abs(value - near) <= 1e-12 * (circle.radius + std::abs(value)) ? near : value;
  };
  return {round(circle.centre.x), round(circle.centre.y), round(circle.centre.z)};
}

}  // namespace

void repeat_selected(Session& session, Pattern pattern) {
  const Selection chosen = session.topmost_selected();
  if (chosen.empty()) {
    session.interface.messages.error("Select the solid to repeat first: click it.");
    return;
  }
  NodeId made = 0;
  Node named;
  named.what = pattern;
  const std::string name = default_name(named);
  if (session.change(name, [&](Scene& changed) {
        made = changed.group(chosen);
        changed.edit(made).what = in_frame(std::move(pattern), changed.world(made));
        changed.rename(made, name);
      }))
    session.select(made);
}

std::string AxisTool::title() const {
  return is_mirror() ? "Mirror" : "Polar array";
}

std::string AxisTool::hint(const ViewState&) const {
  if (is_mirror())
    return std::string(
               "Click a face: its plane is the mirror \u00B7 X, Y, Z: the plane across this "
               "axis through the origin \u00B7 K: the original ") +
           (pattern_.keeps ? "stays" : "goes");
  return "Click a round edge, a face or an edge: the copies stand around its axis \u00B7 X, Y, Z: "
         "around this axis of the world";
}

void AxisTool::follow(Session& session, const Pointer& pointer) {
  hovered_ =
      is_mirror() ? picker_.face_at(session, pointer.at) : picker_.any_at(session, pointer.at);
}

void AxisTool::take(Session& session, const Vec3& centre, const Vec3& axis) {
  pattern_.centre = centre, pattern_.axis = axis;
  pattern_.count = 4;
  repeat_selected(session, pattern_);
  finish();
}

void AxisTool::press(Session& session, const Pointer& pointer) {
  follow(session, pointer);
  if (!hovered_) {
    session.interface.messages.tell(
        "There is nothing under the pointer: click where something lights up.");
    return;
  }
  const PickedSpot spot = *hovered_;
  if (spot.kind == PickedFeature::Kind::face)
    return take(session, middle_of(spot.face()), tidy(spot.face().normal));
  if (spot.kind == PickedFeature::Kind::vertex) return take(session, spot.point, {0, 0, 1});
  if (const auto circle = circle_through(spot.features->features(), spot.index))
    return take(session, tidy_centre(*circle), tidy(circle->normal));
  const glm::dvec3 way = to_glm(spot.edge().to) - to_glm(spot.edge().from);
  take(session, spot.edge().from, tidy(from_glm(glm::normalize(way))));
}

bool AxisTool::key(Session& session, const Event& event) {
  const char letter = static_cast<char>(event.key);
  if (event.control || event.shift) return false;
  if (letter == 'K' && is_mirror()) {
    pattern_.keeps = !pattern_.keeps;
    return true;
  }
  if (letter < 'X' || letter > 'Z') return false;
  glm::dvec3 axis(0);
  axis[letter - 'X'] = 1;
  take(session, {0, 0, 0}, from_glm(axis));
  return true;
}

void AxisTool::add_to(Picture& picture, const ViewState& view) const {
  if (hovered_) add_spot(picture, *hovered_, theme(view.dark).hover);
}

std::string PathTool::hint(const ViewState&) const {
  if (path_.empty()) return "Click where the path begins: a vertex, an edge, a face or the ground.";
  return "Click its next corner \u00B7 Backspace: back \u00B7 Enter: done (" +
         std::to_string(path_.size()) + (path_.size() == 1 ? " point)" : " points)");
}

/// A vertex, else a place on a face, else on the ground; the latter two on the grid.
std::optional<Vec3> PathTool::place_at(const Session& session, const Pointer& pointer) {
  const bool snaps = session.view.snapping != pointer.control;
  const std::optional<PickedSpot> spot = picker_.any_at(session, pointer.at);
  if (spot && spot->kind == PickedFeature::Kind::vertex) return spot->point;
  Vec3 place;
  if (spot) {
    place = spot->point;
  } else {
    const Ray ray = session.view.camera.ray(pointer.at, session.view.picture_size);
    if (std::abs(ray.direction.z) < 1e-6) return std::nullopt;
    const double t = -ray.origin.z / ray.direction.z;
    if (t <= 0) return std::nullopt;
    place = from_glm(ray.origin + t * ray.direction);
    place.z = 0;
  }
  return snaps ? snapped(place, 0.25) : place;
}

void PathTool::follow(Session& session, const Pointer& pointer) {
  next_ = place_at(session, pointer);
}

void PathTool::press(Session& session, const Pointer& pointer) {
  const std::optional<Vec3> place = place_at(session, pointer);
  if (place && (path_.empty() || path_.back() != *place)) path_.push_back(*place);
}

bool PathTool::key(Session& session, const Event& event) {
  if (event.key == Key::backspace) {
    if (!path_.empty()) path_.pop_back();
    return true;
  }
  if (event.key != Key::enter) return false;
  if (path_.size() < 2) {
    session.interface.messages.tell("A path needs two points or more.");
    return true;
  }
  Pattern pattern;
  pattern.kind = Pattern::Kind::path;
  pattern.count = 5;
  pattern.path = path_;
  repeat_selected(session, pattern);
  finish();
  return true;
}

void PathTool::add_to(Picture& picture, const ViewState& view) const {
  const Theme& colours = theme(view.dark);
  std::vector<glm::vec3> corners;
  for (const Vec3& p : path_) corners.emplace_back(to_glm(p));
  if (next_) corners.emplace_back(to_glm(*next_));
  std::vector<glm::vec3> ends;
  for (std::size_t i = 0; i + 1 < corners.size(); ++i)
    ends.push_back(corners[i]), ends.push_back(corners[i + 1]);
  if (!ends.empty()) picture.lines.push_back({ends, colours.step, 3, true});
  if (!corners.empty()) picture.points.push_back({corners, colours.step, 9});
}

}  // namespace sectile::viewer
