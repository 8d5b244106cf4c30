// Picking what a pattern needs: an axis, a plane, a path.
#pragma once

#include <optional>
#include <vector>

#include "app/feature_picking.h"
#include "app/picture_tool.h"
#include "scene/pattern.h"

namespace sectile::viewer {

/// The selected nodes become the children of a new pattern node, whose numbers are given in the
/// world. One step of undo.
void repeat_selected(Session& session, Pattern pattern);

/// Asks for the axis of a ring of copies, or for the plane of a mirror.
class AxisTool : public PictureTool {
 public:
  explicit AxisTool(Pattern::Kind kind) { pattern_.kind = kind; }
  std::string title() const override;
  std::string hint(const ViewState& view) const override;
  void follow(Session& session, const Pointer& pointer) override;
  void press(Session& session, const Pointer& pointer) override;
  bool key(Session& session, const Event& event) override;
  void add_to(Picture& picture, const ViewState& view) const override;

 private:
  bool is_mirror() const { return pattern_.kind == Pattern::Kind::mirror; }
  void take(Session& session, const Vec3& centre, const Vec3& axis);

  Pattern pattern_;
  FeaturePicker picker_;
  std::optional<PickedSpot> hovered_;
};

/// Asks for the corners of a path.
class PathTool : public PictureTool {
 public:
  std::string title() const override { return "Array along a path"; }
  std::string hint(const ViewState& view) const override;
  void follow(Session& session, const Pointer& pointer) override;
  void press(Session& session, const Pointer& pointer) override;
  bool key(Session& session, const Event& event) override;
  void add_to(Picture& picture, const ViewState& view) const override;

 private:
  std::optional<Vec3> place_at(const Session& session, const Pointer& pointer);
  FeaturePicker picker_;
  std::vector<Vec3> path_;
  std::optional<Vec3> next_;
};

}  // namespace sectile::viewer
