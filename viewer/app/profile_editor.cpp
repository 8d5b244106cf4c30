#include "app/profile_editor.h"

namespace sectile::viewer {

void ProfileEditor::begin_new(ProfileUse use, const Placement& at, std::vector<Vec2> guide_lines) {
  *this = {};
  open = true;
  primitive.kind = &primitive_kind(use == ProfileUse::turned ? "revolution" : "extrusion");
  primitive.height = 1;
  placement = at;
  guides = std::move(guide_lines);
}

void ProfileEditor::begin_edit(const Node& edited) {
  *this = {};
  open = true;
  node = edited.id;
  primitive = std::get<Primitive>(edited.what);
  placement = edited.placement;
  sketch = ProfileSketch(primitive.profile);
}

}  // namespace sectile::viewer
