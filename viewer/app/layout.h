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
  Rectangle tool_bar, tree, properties, picture, hints, inspector, time_line, status, tour, repair;
};

struct LayoutOptions {
  float menu_height = 0;      ///< what ImGui's menu bar takes at the top
  bool steps = false;         ///< inspector and time line instead of the properties
  bool hints = false;         ///< a strip below the picture
  bool tour = false;          ///< below the tree, in the steps
  bool repair = false;        ///< instead of the tree and the properties
  float left = 0, right = 0;  ///< widths that a person dragged the panels to; 0: as usual
};

Layout make_layout(float width, float height, const LayoutOptions& options);

}  // namespace sectile::viewer
