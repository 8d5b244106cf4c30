// Placing by picking: a face onto a face, an edge onto an edge.
#pragma once

#include <optional>

#include "app/feature_picking.h"
#include "app/picture_tool.h"

namespace sectile::viewer {

/// Two picks; then the solid is shown in its new place, may be turned over or centred, and is taken
/// with Enter or a click.
class PlaceTool : public PictureTool {
 public:
  void follow(Session& session, const Pointer& pointer) override;
  void press(Session& session, const Pointer& pointer) override;
  bool key(Session& session, const Event& event) override;
  void give_up(Session& session) override;
  void scene_changed(Session& session) override;
  void preview_undone(Session& session) override;
  void add_to(Picture& picture, const ViewState& view) const override;

 protected:
  virtual std::optional<PickedSpot> pick(const Session& session, glm::dvec2 pixel) = 0;
  virtual Landing land(const Standing& start, const PickedSpot& moved,
                       const PickedSpot& fixed) const = 0;
  virtual bool option(char letter) = 0;  ///< true: it was one, and something is to be shown anew
  bool has_first() const { return first_.has_value(); }
  bool has_both() const { return second_.has_value(); }
  bool is_exact() const { return landing_.is_exact; }
  FeaturePicker picker_;

 private:
  void show(Session& session);
  void take(Session& session);

  std::optional<PickedSpot> hovered_, first_, second_;
  Standing start_;
  Landing landing_;
};

class FaceOnFace : public PlaceTool {
 public:
  explicit FaceOnFace(FlushOptions options) : options_(options) {}
  std::string title() const override { return "Face on face"; }
  std::string hint(const ViewState& view) const override;

 protected:
  std::optional<PickedSpot> pick(const Session& session, glm::dvec2 pixel) override;
  Landing land(const Standing& start, const PickedSpot& moved,
               const PickedSpot& fixed) const override;
  bool option(char letter) override;

 private:
  FlushOptions options_;
};

class EdgeOnEdge : public PlaceTool {
 public:
  std::string title() const override { return "Edge on edge"; }
  std::string hint(const ViewState& view) const override;

 protected:
  std::optional<PickedSpot> pick(const Session& session, glm::dvec2 pixel) override;
  Landing land(const Standing& start, const PickedSpot& moved,
               const PickedSpot& fixed) const override;
  bool option(char letter) override;

 private:
  bool turned_round_ = false;
};

}  // namespace sectile::viewer
