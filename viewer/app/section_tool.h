// Placing the section plane in the picture: along its normal, tilted, or onto a face.
#pragma once

#include <optional>

#include "app/feature_picking.h"
#include "app/picture_tool.h"
#include "scene/handles.h"

namespace sectile::viewer {

class SectionTool : public PictureTool {
 public:
  /// `bounds`: of what is cut.
  explicit SectionTool(const Bounds& bounds) : bounds_(bounds) {}
  Mouse mouse() const override { return drag_ || hovered_part_ ? Mouse::drags : Mouse::clicks; }
  std::string title() const override { return "Section plane"; }
  std::string hint(const ViewState& view) const override;
  void follow(Session& session, const Pointer& pointer) override;
  void press(Session& session, const Pointer& pointer) override;
  void release(Session& session, const Pointer& pointer) override;
  bool key(Session& session, const Event& event) override;
  void add_to(Picture& picture, const ViewState& view) const override;

 private:
  std::optional<HandlePart> part_at(const ViewState& view, glm::dvec2 pixel) const;

  Bounds bounds_;
  FeaturePicker picker_;
  std::optional<PickedSpot> face_;          // under the pointer
  std::optional<HandlePart> hovered_part_;  // of the plane's handles
  std::optional<HandleDrag> drag_;
  glm::dvec4 start_{0};  // the plane when the drag began
  glm::dvec3 origin_{0};
};

/// The handles of the section plane, beside the middle of what is cut: their z axis is its normal.
Handles section_handles(const ViewState& view, const Bounds& bounds, HandleMode mode);

}  // namespace sectile::viewer
