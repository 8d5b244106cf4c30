// Measuring by picking: one thing, or two.
#pragma once

#include <optional>

#include "app/feature_picking.h"
#include "app/picture_tool.h"
#include "scene/measuring.h"

namespace sectile::viewer {

class MeasureTool : public PictureTool {
 public:
  std::string title() const override { return "Measure"; }
  std::string hint(const ViewState& view) const override;
  void follow(Session& session, const Pointer& pointer) override;
  void press(Session& session, const Pointer& pointer) override;
  void scene_changed(Session& session) override;
  void add_to(Picture& picture, const ViewState& view) const override;
  /// "Distance 3 · dx 1 · …"; empty before the first pick.
  const std::string& result() const { return result_; }

 private:
  void measure();

  FeaturePicker picker_;
  std::optional<PickedSpot> hovered_, first_, second_;
  Measurement measurement_;
  std::optional<Circle> circle_;
  std::string result_;
};

}  // namespace sectile::viewer
