// The dialog that draws and changes profiles, as data; the panel draws it.
#pragma once

#include <optional>
#include <vector>

#include "scene/primitive_kind.h"
#include "scene/profile_sketch.h"

namespace sectile::viewer {

struct ProfileEditor {
  bool open = false;
  NodeId node = 0;  ///< whose profile it is; 0: a new solid's
  Primitive primitive;
  Placement placement;  ///< of a new one
  ProfileSketch sketch;
  std::vector<Vec2> guides;  ///< ends of lines to draw and to snap to: the face drawn upon
  std::optional<ProfileSketch::Corner> selected;
  SketchSide next;                           ///< the side to be added by its numbers
  double width = 2, height = 2, radius = 1;  ///< of rectangles and circles
  std::uint32_t corners = 32;
  // The view of the canvas.
  Vec2 centre;
  double units_across = 8;
  bool dragging = false;  ///< the selected corner
  bool fit = true;        ///< everything is to be brought into view

  /// `use`: the profile of an extrusion, or of a revolution.
  void begin_new(ProfileUse use, const Placement& at, std::vector<Vec2> guide_lines);
  void begin_edit(const Node& node);
};

}  // namespace sectile::viewer
