#include "app/section_tool.h"

#include <algorithm>
#include <cmath>

#include "app/words.h"
#include "picture/theme.h"
#include "scene/transforms.h"

namespace sectile::viewer {
namespace {

constexpr double arrow_reach = 9, angle_step = 5;

glm::dvec3 across(const glm::dvec3& n) {
  const glm::dvec3 aside = std::abs(n.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0);
  return glm::normalize(glm::cross(aside, n));
}

double distance_to_segment(glm::dvec2 p, glm::dvec2 a, glm::dvec2 b) {
  const glm::dvec2 d = b - a;
  const double length = glm::dot(d, d);
  return glm::distance(
      p, a + d * (length > 0 ? glm::clamp(glm::dot(p - a, d) / length, 0.0, 1.0) : 0));
}

/// Directions within rounding of an axis are that axis.
glm::dvec3 tidy(const glm::dvec3& n) {
  for (int i = 0; i < 3; ++i)
    if (std::abs(n[i]) > 1 - 1e-12) {
      glm::dvec3 axis(0);
      axis[i] = n[i] > 0 ? 1 : -1;
      return axis;
    }
  return glm::normalize(n);
}

}  // namespace

Handles section_handles(const ViewState& view, const Bounds& bounds, HandleMode mode) {
  const glm::dvec4 plane = view.section_plane();
  const glm::dvec3 n(plane);
  const glm::dvec3 middle = bounds.is_empty() ? glm::dvec3(0) : bounds.centre();
  Handles handles;
  handles.mode = mode;
  handles.origin = middle - n * (glm::dot(n, middle) + plane.w);
  handles.axes[2] = n;
  handles.axes[0] = across(n);
  handles.axes[1] = glm::cross(n, handles.axes[0]);
  handles.size = 90 * view.camera.pixel_length(handles.origin, view.picture_size);
  return handles;
}

std::string SectionTool::hint(const ViewState& view) const {
  const glm::dvec4 p = view.section_plane();
  return "Drag the arrow to move the plane, a ring to tilt it (Ctrl: freely); click a face to put "
         "it there \u00B7 X, Y, Z: across this axis \u00B7 T: the other side\n"
         "Normal " +
         number(p.x) + ", " + number(p.y) + ", " + number(p.z) + " \u00B7 at " +
         number(p.w == 0 ? 0 : -p.w);
}

std::optional<HandlePart> SectionTool::part_at(const ViewState& view, glm::dvec2 pixel) const {
  const Handles handles = section_handles(view, bounds_, HandleMode::rotate);
  const auto seen = [&](const glm::dvec3& p) {
    return glm::dvec2(view.camera.project(p, view.picture_size));
  };
  const glm::dvec2 tip = seen(handles.origin + handles.size * handles.axes[2]);
  if (distance_to_segment(pixel, seen(handles.origin), tip) <= arrow_reach)
    return HandlePart::axis_z;
  const auto ring = handles.part_at(view.camera, pixel, view.picture_size);
  const bool tilts = ring == HandlePart::ring_x || ring == HandlePart::ring_y;
  return tilts ? ring : std::nullopt;
}

void SectionTool::follow(Session& session, const Pointer& pointer) {
  bounds_ = session.bounds_of_all();
  if (!drag_) {
    hovered_part_ = part_at(session.view, pointer.at);
    face_ = hovered_part_ ? std::nullopt : picker_.face_at(session, pointer.at);
    return;
  }
  const Ray ray = session.view.camera.ray(pointer.at, session.view.picture_size);
  const HandleChange change = drag_->change(ray);
  const bool snaps = session.view.snapping != pointer.control;
  const glm::dvec3 n(start_);
  if (drag_->part() == HandlePart::axis_z) {
    double place = glm::dot(n, origin_ + change.move);
    if (snaps) place = snapped(place, 0.05);
    session.view.set_section(n, place);
    return;
  }
  const double degrees = snaps ? snapped(change.degrees, angle_step) : change.degrees;
  const Transform turn = Transform::rotation_degrees(from_glm(change.axis), degrees);
  const glm::dvec3 turned = tidy(to_glm(turn(from_glm(n))));
  session.view.set_section(turned, glm::dot(turned, origin_));
}

void SectionTool::press(Session& session, const Pointer& pointer) {
  session.view.section = true;
  hovered_part_ = part_at(session.view, pointer.at);
  if (hovered_part_) {
    const bool moves = *hovered_part_ == HandlePart::axis_z;
    const Handles handles =
        section_handles(session.view, bounds_, moves ? HandleMode::move : HandleMode::rotate);
    start_ = session.view.section_plane();
    origin_ = handles.origin;
    drag_.emplace(handles, *hovered_part_,
                  session.view.camera.ray(pointer.at, session.view.picture_size),
                  session.view.camera);
    return;
  }
  face_ = picker_.face_at(session, pointer.at);
  if (!face_) return;
  const glm::dvec3 n = tidy(to_glm(face_->face().normal));
  session.view.set_section(n, glm::dot(n, to_glm(face_->face().point)));
}

void SectionTool::release(Session&, const Pointer&) {
  drag_.reset();
}

bool SectionTool::key(Session& session, const Event& event) {
  const char letter = static_cast<char>(event.key);
  if (event.control || event.shift) return false;
  if (letter == 'T') {
    session.view.section_flipped = !session.view.section_flipped;
    return true;
  }
  if (letter < 'X' || letter > 'Z') return false;
  glm::dvec3 axis(0);
  axis[letter - 'X'] = 1;
  const Bounds bounds = session.bounds_of_all();
  session.view.section = true;
  session.view.set_section(axis, bounds.is_empty() ? 0 : bounds.centre()[letter - 'X']);
  return true;
}

void SectionTool::add_to(Picture& picture, const ViewState& view) const {
  const Theme& colours = theme(view.dark);
  const Handles handles = section_handles(view, bounds_, HandleMode::rotate);
  const auto part_colour = [&](HandlePart part) {
    const bool active = drag_ ? drag_->part() == part : hovered_part_ == part;
    return active ? colours.handle_active : colours.step;
  };
  // A frame in the plane around everything.
  const double half = bounds_.is_empty() ? 1 : bounds_.radius();
  const glm::dvec3 u = half * handles.axes[0], v = half * handles.axes[1], o = handles.origin;
  const glm::vec3 a(o - u - v), b(o + u - v), c(o + u + v), d(o - u + v);
  picture.lines.push_back({{a, b, b, c, c, d, d, a}, colours.step, 1.5f, true});
  const glm::dvec3 tip = o + handles.size * handles.axes[2];
  picture.lines.push_back(
      {{glm::vec3(o), glm::vec3(tip)}, part_colour(HandlePart::axis_z), 4, true});
  picture.points.push_back({{glm::vec3(tip)}, part_colour(HandlePart::axis_z), 13});
  for (const int axis : {0, 1}) {
    std::vector<glm::vec3> ends;
    const glm::dvec3 p = handles.axes[(axis + 1) % 3], q = handles.axes[(axis + 2) % 3];
    for (int i = 0; i < 64; ++i)
      for (const int k : {i, i + 1}) {
        const double angle = 2 * M_PI * k / 64;
        ends.emplace_back(o + handles.size * (std::cos(angle) * p + std::sin(angle) * q));
      }
    const auto part = static_cast<HandlePart>(static_cast<int>(HandlePart::ring_x) + axis);
    picture.lines.push_back({std::move(ends), part_colour(part), 2.5f, true});
  }
  if (face_ && !drag_) add_spot(picture, *face_, colours.hover);
}

}  // namespace sectile::viewer
