// Selecting all solids that a rectangle in the picture meets.
#pragma once

#include <optional>

#include "app/picture_tool.h"
#include "scene/history.h"

namespace sectile::viewer {

class BoxSelect : public PictureTool {
 public:
  BoxSelect() = default;
  /// The button is held already.
  explicit BoxSelect(glm::dvec2 from) : from_(from), to_(from), adds_(true) {}

  Mouse mouse() const override { return Mouse::drags; }
  std::string title() const override { return "Box select"; }
  std::string hint(const ViewState& view) const override;
  void follow(Session& session, const Pointer& pointer) override;
  void press(Session& session, const Pointer& pointer) override;
  void release(Session& session, const Pointer& pointer) override;
  void add_to(Picture& picture, const ViewState& view) const override;

 private:
  std::optional<glm::dvec2> from_;
  glm::dvec2 to_{0};
  bool adds_ = false;  // to what is selected
};

/// What a click would select in any place of the rectangle, in the order of the tree.
Selection met_by_box(const Session& session, glm::dvec2 corner, glm::dvec2 opposite);

}  // namespace sectile::viewer
