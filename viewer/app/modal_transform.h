// Moving, turning and scaling without handles, as G, R and S do: the selection follows the mouse at
// once; X, Y, Z (with Shift: the plane across) constrain, numbers are typed, a click or Enter
// takes, Esc gives back.
#pragma once

#include <array>
#include <optional>

#include "app/handle_pull.h"
#include "app/picture_tool.h"

namespace sectile::viewer {

class ModalTransform : public PictureTool {
 public:
  /// Something must be selected. `pointer`: where the mouse is in the picture.
  ModalTransform(Session& session, HandleMode mode, glm::dvec2 pointer);

  Mouse mouse() const override { return Mouse::all; }
  std::string title() const override;
  std::string hint(const ViewState& view) const override;
  void follow(Session& session, const Pointer& pointer) override;
  void press(Session& session, const Pointer& pointer) override;
  bool key(Session& session, const Event& event) override;
  void text(Session& session, const std::string& typed) override;
  void give_up(Session& session) override;
  void add_to(Picture& picture, const ViewState& view) const override;

 private:
  enum class Axes { world, own };
  void start_again(Session& session);
  void constrain(Session& session, int axis, bool plane);
  void show(Session& session);
  HandleChange by_pointer(const ViewState& view);
  HandleChange by_numbers() const;
  double factor(const ViewState& view) const;
  bool has_numbers() const;
  bool is_free(int axis) const;
  HandlePart part() const;
  std::string told() const;
  std::string& number() { return typed_[place_]; }

  HandleMode mode_;
  Axes axes_ = Axes::world;
  std::optional<int> axis_;  // the constraint
  bool plane_ = false;       // across the axis instead of along it
  Pointer start_, now_;
  double turned_ = 0, last_angle_ = 0;  // of the pointer around the handles, on the screen
  std::array<std::string, 3> typed_;
  std::size_t place_ = 0;  // which of them is being typed
  std::optional<HandlePull> pull_;
  std::optional<Handles> handles_;
  KnownTargets targets_;
};

}  // namespace sectile::viewer
