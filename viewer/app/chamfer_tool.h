// Cutting off an edge: click it, type how wide.
#pragma once

#include <optional>
#include <string>

#include "app/feature_picking.h"
#include "app/picture_tool.h"
#include "scene/chamfer.h"

namespace sectile::viewer {

/// The solid of the edge becomes a difference, of which the piece that is cut off is the second
/// operand: its width, like all of it, can be changed later.
class ChamferTool : public PictureTool {
 public:
  std::string title() const override { return "Chamfer"; }
  std::string hint(const ViewState& view) const override;
  void follow(Session& session, const Pointer& pointer) override;
  void press(Session& session, const Pointer& pointer) override;
  bool key(Session& session, const Event& event) override;
  void text(Session& session, const std::string& typed) override;
  void give_up(Session& session) override;
  void scene_changed(Session& session) override;
  void preview_undone(Session& session) override;
  void add_to(Picture& picture, const ViewState& view) const override;

 private:
  void show(Session& session);
  void take(Session& session);

  FeaturePicker picker_;
  std::optional<PickedSpot> hovered_, picked_;
  ChamferEdge edge_;
  std::string typed_ = "1";
  bool is_typed_ = false;  ///< or what it begins with
  std::string problem_;    ///< why nothing is shown
  NodeId made_ = 0;
  bool is_exact_ = false;
};

}  // namespace sectile::viewer
