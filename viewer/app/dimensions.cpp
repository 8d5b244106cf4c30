#include "app/dimensions.h"

#include <algorithm>

#include "app/words.h"
#include "picture/theme.h"

namespace sectile::viewer {
namespace {

bool is_chosen(const Session& session, NodeId id) {
  return std::any_of(session.selection().begin(), session.selection().end(), [&](NodeId selected) {
    return session.scene().find(selected) && session.scene().is_below(id, selected);
  });
}

glm::dvec3 corner(const Bounds& box, int which) {
  return {which & 1 ? box.high.x : box.low.x, which & 2 ? box.high.y : box.low.y,
          which & 4 ? box.high.z : box.low.z};
}

/// Of the four edges along an axis the one that is seen lowest; of the upright ones, farthest left.
glm::dvec3 place_of_label(const Session& session, const Bounds& box, int axis) {
  glm::dvec3 best(0);
  double most = -1e300;
  for (int from = 0; from < 8; ++from) {
    if (from & (1 << axis)) continue;
    const glm::dvec3 middle = 0.5 * (corner(box, from) + corner(box, from | (1 << axis)));
    const glm::dvec3 seen = session.view.camera.project(middle, session.view.picture_size);
    const double value = axis == 2 ? -seen.x : seen.y;
    if (value > most) most = value, best = middle;
  }
  return best;
}

}  // namespace

Bounds close_bounds_of_selection(const Session& session, const std::vector<Shape>& shapes) {
  Bounds box;
  for (const Shape& shape : shapes) {
    if (!is_chosen(session, shape.node)) continue;
    for (const glm::vec3& p : shape.surface.mesh->positions)
      box.add(glm::dvec3(shape.surface.model * glm::dvec4(p, 1)));
  }
  return box;
}

void add_dimensions(Picture& picture, const Session& session, const std::vector<Shape>& shapes) {
  const Bounds box = close_bounds_of_selection(session, shapes);
  if (box.is_empty()) return;
  const Theme& colours = theme(session.view.dark);
  const Colour of_axis[] = {colours.handle_x, colours.handle_y, colours.handle_z};
  for (int axis = 0; axis < 3; ++axis) {
    Lines lines;
    lines.colour = of_axis[axis];
    lines.width = 1.5f;
    for (int from = 0; from < 8; ++from)
      if (!(from & (1 << axis)))
        for (const int end : {from, from | (1 << axis)}) lines.ends.emplace_back(corner(box, end));
    picture.lines.push_back(std::move(lines));
    picture.labels.push_back({place_of_label(session, box, axis),
                              number(box.high[axis] - box.low[axis]), of_axis[axis], true});
  }
}

}  // namespace sectile::viewer
