#include "app/navigation.h"

#include <imgui.h>

#include <cmath>

#include <optional>

#include "app/handles.h"
#include "app/picking.h"

namespace sectile::viewer {
namespace {

constexpr double turn_per_unit = 0.008;  // radians for each unit that the mouse moves
constexpr double zoom_per_notch = 0.88;
constexpr float click_reach = 4;  // farther than that is a drag

enum class Gesture { none, pressed, orbit, pan, handle };

}  // namespace

struct Navigation::State {
  Gesture gesture = Gesture::none;
  int button = 0;
  ImVec2 pressed_at{0, 0};
  std::optional<HandlePull> drag;
  int hovered_axis = -1;
};

Navigation::Navigation() : state_(std::make_unique<State>()) {}
Navigation::~Navigation() = default;

bool Navigation::is_dragging() const {
  return state_->gesture != Gesture::none && state_->gesture != Gesture::pressed;
}

bool Navigation::escape(Session& session) {
  if (!state_->drag) return false;
  session.document.drop_draft();
  state_->drag.reset();
  state_->gesture = Gesture::none;
  return true;
}

void Navigation::add_to(Picture& picture, const Session& session) const {
  add_handles(picture, session, state_->drag ? state_->drag->axis() : state_->hovered_axis);
}

void Navigation::record(Widgets& widgets, const Session& session, const Rectangle& place) const {
  for (const Handle& handle : handles_of(session)) {
    const glm::dvec3 pixel = session.camera.project(handle.grip, session.picture_size);
    Widget widget;
    widget.rectangle = {place.x + pixel.x - 5, place.y + pixel.y - 5, 10, 10};
    widget.surface = true;
    widgets.record(std::string("handle.") + "xyz"[handle.axis], widget);
  }
}

void Navigation::update(Session& session, const Rectangle& place) {
  const ImGuiIO& io = ImGui::GetIO();
  State& state = *state_;
  const glm::dvec2 size(place.width, place.height);
  const glm::dvec2 at(io.MousePos.x - place.x, io.MousePos.y - place.y);
  const bool over = place.contains(io.MousePos.x, io.MousePos.y) && !io.WantCaptureMouse;
  if (over && io.MouseWheel != 0)
    session.camera.zoom(std::pow(zoom_per_notch, static_cast<double>(io.MouseWheel)), at, size);
  if (state.gesture == Gesture::none) {
    const std::optional<Handle> handle = over ? handle_at(session, at) : std::nullopt;
    state.hovered_axis = handle ? handle->axis : -1;
  }
  if (state.gesture == Gesture::none && over) {
    for (const int button : {0, 1, 2})
      if (ImGui::IsMouseClicked(button)) {
        state.gesture = Gesture::pressed;
        state.button = button;
        const std::optional<Handle> handle = button == 0 ? handle_at(session, at) : std::nullopt;
        if (handle) {
          state.gesture = Gesture::handle;
          state.drag.emplace(session, *handle, at);
        }
        state.pressed_at = io.MousePos;
      }
    if (ImGui::IsMouseDoubleClicked(0) && !state.drag) {
      const NodeId hit = pick(session, session.camera.ray(at, size), Depth::inner);
      if (hit) session.select(hit);
      state.gesture = Gesture::none;
    }
  }
  if (state.gesture == Gesture::none) return;
  if (state.gesture == Gesture::pressed &&
      std::hypot(io.MousePos.x - state.pressed_at.x, io.MousePos.y - state.pressed_at.y) >
          click_reach)
    state.gesture = io.KeyShift && state.button != 0 ? Gesture::pan : Gesture::orbit;
  const glm::dvec2 by(io.MouseDelta.x, io.MouseDelta.y);
  if (state.gesture == Gesture::orbit)
    session.camera.orbit(-turn_per_unit * by.x, turn_per_unit * by.y);
  if (state.gesture == Gesture::pan) session.camera.pan(by, size);
  if (state.gesture == Gesture::handle && (by.x != 0 || by.y != 0))
    session.document.show_draft(
        state.drag->description(),
        state.drag->pulled(session, at, session.snapping != io.KeyCtrl, io.KeyShift));
  if (io.MouseDown[state.button]) return;
  if (state.gesture == Gesture::handle) {
    session.document.commit_draft();
    state.drag.reset();
  }
  if (state.gesture == Gesture::pressed && state.button == 0 && session.mode() == Mode::model)
    session.select(pick(session, session.camera.ray(at, size), Depth::outer),
                   io.KeyShift || io.KeyCtrl);
  state.gesture = Gesture::none;
}

}  // namespace sectile::viewer
