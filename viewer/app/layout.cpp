#include "app/layout.h"

#include <algorithm>
#include <cmath>

namespace sectile::viewer {
namespace {

constexpr float least_picture = 200;

float wished(float wish, float usual, float least, float most) {
  return std::clamp(wish > 0 ? wish : usual, least, std::max(least, most));
}

}  // namespace

Layout make_layout(float width, float height, const LayoutOptions& options) {
  constexpr float tool_bar_height = 52, status_height = 26, time_line_height = 84;
  const bool steps = options.steps;
  // In the steps the tree is short, and the inspector has tables of eight columns.
  const float usual_left = steps && !options.tour ? std::clamp(width * 0.15f, 150.0f, 240.0f)
                                                  : std::clamp(width * 0.21f, 232.0f, 320.0f);
  const float usual_right = std::clamp(width * 0.36f, 404.0f, 560.0f);
  const float left = options.repair
                         ? std::round(std::clamp(width * 0.34f, 340.0f, 460.0f))
                         : std::round(wished(options.left, usual_left, 120, width * 0.45f));
  const float right =
      steps ? std::round(wished(options.right, usual_right, 240, width - left - least_picture)) : 0;
  const float bottom = steps ? time_line_height : 0;
  const float top = options.menu_height + tool_bar_height;
  const float inner = std::max(1.0f, height - top - status_height - bottom);
  const bool tour = steps && options.tour;
  const float tree_height = tour ? 142 : steps ? inner : std::round(inner * 0.38f);
  const float middle = std::max(1.0f, width - left - right);
  // Two lines of text, or four where these wrap.
  const float hints = !options.hints ? 0 : std::min(middle < 600 ? 84.0f : 52.0f, inner / 2);

  Layout layout;
  layout.tool_bar = {0, options.menu_height, width, tool_bar_height};
  layout.tree = {0, top, left, tree_height};
  layout.properties = {0, top + tree_height, left, steps ? 0 : inner - tree_height};
  if (options.repair) layout.repair = {0, top, left, inner};
  if (tour) layout.tour = {0, top + tree_height, left, inner - tree_height};
  layout.picture = {left, top, middle, inner - hints};
  layout.hints = {left, top + inner - hints, middle, hints};
  layout.inspector = {width - right, top, right, inner};
  layout.time_line = {0, top + inner, width, bottom};
  layout.status = {0, height - status_height, width, status_height};
  return layout;
}

}  // namespace sectile::viewer
