#include "app/dimensions.h"

#include <algorithm>

#include "app/words.h"
#include "picture/theme.h"

namespace sectile::viewer {
namespace {

/// Is a shape what is selected, or a part of it? The ghosts of operands are not, where their result
/// is selected and drawn.
bool is_chosen(const Document& document, const std::vector<Shape>& shapes, const Shape& shape) {
  const Scene& scene = document.scene();
  const Selection& chosen = document.selection();
  const auto has_result = [&](NodeId node) {
    return std::any_of(shapes.begin(), shapes.end(),
                       [&](const Shape& other) { return other.node == node && !other.is_operand; });
  };
  return std::any_of(chosen.begin(), chosen.end(), [&](NodeId selected) {
    return scene.find(selected) && scene.is_below(shape.node, selected) &&
           !(shape.is_operand && has_result(selected));
  });
}

glm::dvec3 corner(const Bounds& box, int which) {
  return {which & 1 ? box.high.x : box.low.x, which & 2 ? box.high.y : box.low.y,
          which & 4 ? box.high.z : box.low.z};
}

/// Of the four edges along an axis the one that is seen lowest; of the upright ones, farthest left.
glm::dvec3 place_of_label(const ViewState& view, const Bounds& box, int axis) {
  glm::dvec3 best(0);
  double most = -1e300;
  for (int from = 0; from < 8; ++from) {
    if (from & (1 << axis)) continue;
    const glm::dvec3 middle = 0.5 * (corner(box, from) + corner(box, from | (1 << axis)));
    const glm::dvec3 seen = view.camera.project(middle, view.picture_size);
    const double value = axis == 2 ? -seen.x : seen.y;
    if (value > most) most = value, best = middle;
  }
  return best;
}

}  // namespace

Bounds close_bounds_of_selection(const Document& document, const std::vector<Shape>& shapes) {
  Bounds box;
  for (const Shape& shape : shapes) {
    if (!is_chosen(document, shapes, shape)) continue;
    for (const glm::vec3& p : shape.surface.mesh->positions)
      box.add(glm::dvec3(shape.surface.model * glm::dvec4(p, 1)));
  }
  return box;
}

void add_dimensions(Picture& picture, const Document& document, const ViewState& view,
                    const std::vector<Shape>& shapes) {
  const Bounds box = close_bounds_of_selection(document, shapes);
  if (box.is_empty()) return;
  const Theme& colours = theme(view.dark);
  const Colour of_axis[] = {colours.handle_x, colours.handle_y, colours.handle_z};
  for (int axis = 0; axis < 3; ++axis) {
    Lines lines;
    lines.colour = of_axis[axis];
    lines.width = 1.5f;
    for (int from = 0; from < 8; ++from)
      if (!(from & (1 << axis)))
        for (const int end : {from, from | (1 << axis)}) lines.ends.emplace_back(corner(box, end));
    picture.lines.push_back(std::move(lines));
    picture.labels.push_back({place_of_label(view, box, axis),
                              number(box.high[axis] - box.low[axis]), of_axis[axis], true});
  }
}

}  // namespace sectile::viewer
