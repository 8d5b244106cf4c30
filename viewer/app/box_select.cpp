#include "app/box_select.h"

#include <algorithm>
#include <array>

#include "app/picture_maker.h"
#include "app/session.h"
#include "picture/theme.h"

namespace sectile::viewer {
namespace {

struct Box {
  glm::dvec2 low, high;
  bool holds(const glm::dvec2& p) const {
    return glm::all(glm::lessThanEqual(low, p)) && glm::all(glm::lessThanEqual(p, high));
  }
};

double side(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& p) {
  return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

/// Does a segment cross the box? By halves of its slab.
bool crosses(const Box& box, const glm::dvec2& a, const glm::dvec2& b) {
  double from = 0, to = 1;
  for (int i = 0; i < 2; ++i) {
    const double d = b[i] - a[i];
    if (d == 0 && (a[i] < box.low[i] || a[i] > box.high[i])) return false;
    if (d == 0) continue;
    const double s = (box.low[i] - a[i]) / d, t = (box.high[i] - a[i]) / d;
    from = std::max(from, std::min(s, t)), to = std::min(to, std::max(s, t));
  }
  return from <= to;
}

bool meets(const Box& box, const std::array<glm::dvec2, 3>& corners) {
  for (int i = 0; i < 3; ++i)
    if (box.holds(corners[static_cast<std::size_t>(i)])) return true;
  const auto& [a, b, c] = corners;
  if (crosses(box, a, b) || crosses(box, b, c) || crosses(box, c, a)) return true;
  const glm::dvec2 middle = 0.5 * (box.low + box.high);
  const bool left = side(a, b, middle) > 0;
  return left == (side(b, c, middle) > 0) && left == (side(c, a, middle) > 0);
}

bool meets(const Box& box, const Surface& surface, const ViewState& view) {
  const auto& positions = surface.mesh->positions;
  for (std::size_t i = 0; i + 2 < positions.size(); i += 3) {
    std::array<glm::dvec2, 3> corners;
    bool before_eye = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const glm::dvec3 p(surface.model * glm::dvec4(positions[i + k], 1));
      const glm::dvec3 seen = view.camera.project(p, view.picture_size);
      before_eye = before_eye && seen.z > 0;
      corners[k] = glm::dvec2(seen);
    }
    if (before_eye && meets(box, corners)) return true;
  }
  return false;
}

NodeId topmost(const Scene& scene, NodeId id) {
  while (scene.at(id).parent != 0) id = scene.at(id).parent;
  return id;
}

}  // namespace

Selection met_by_box(const Session& session, glm::dvec2 corner, glm::dvec2 opposite) {
  const Box box{glm::min(corner, opposite), glm::max(corner, opposite)};
  Selection met;
  for (const Shape& shape : visible_shapes(session)) {
    const NodeId top = topmost(session.scene(), shape.node);
    if (std::count(met.begin(), met.end(), top) || !meets(box, shape.surface, session.view))
      continue;
    met.push_back(top);
  }
  return met;
}

std::string BoxSelect::hint(const ViewState&) const {
  return "Drag a box over the solids to select. Shift adds to what is selected.";
}

void BoxSelect::follow(Session&, const Pointer& pointer) {
  to_ = pointer.at;
}

void BoxSelect::press(Session&, const Pointer& pointer) {
  from_ = to_ = pointer.at;
}

void BoxSelect::release(Session& session, const Pointer& pointer) {
  if (!from_) return;
  Selection chosen;
  if (adds_ || pointer.shift) chosen = session.selection();
  for (const NodeId id : met_by_box(session, *from_, pointer.at))
    if (!std::count(chosen.begin(), chosen.end(), id)) chosen.push_back(id);
  session.select(std::move(chosen));
  finish();
}

void BoxSelect::add_to(Picture& picture, const ViewState& view) const {
  if (!from_) return;
  const auto place = [&](double x, double y) {
    const Ray ray = view.camera.ray({x, y}, view.picture_size);
    return glm::vec3(ray.origin + view.camera.distance * ray.direction);
  };
  const glm::vec3 a = place(from_->x, from_->y), b = place(to_.x, from_->y),
                  c = place(to_.x, to_.y), d = place(from_->x, to_.y);
  picture.lines.push_back({{a, b, b, c, c, d, d, a}, theme(view.dark).hover, 2, true});
}

}  // namespace sectile::viewer
