// Where the panels are, computed from the size of the window. All in UI units.
#pragma once

namespace sectile::viewer {

struct Rectangle {
  float x = 0, y = 0, width = 0, height = 0;
  bool contains(double px, double py) const {
    return px >= x && py >= y && px < x + width && py < y + height;
  }
};

struct Layout {
  Rectangle tool_bar, tree, properties, picture, inspector, time_line, status;
};

/// `menu_height` is what ImGui's menu bar takes at the top.
Layout make_layout(float width, float height, float menu_height, bool steps);

}  // namespace sectile::viewer
