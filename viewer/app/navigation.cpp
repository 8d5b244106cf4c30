#include "app/navigation.h"

#include <imgui.h>

#include <cmath>
#include <optional>

#include "app/clicking.h"
#include "app/handle_pull.h"
#include "picture/theme.h"

namespace sectile::viewer {
namespace {

constexpr double turn_per_unit = 0.008;  // radians for each unit that the mouse moves
constexpr double zoom_per_notch = 0.88;
constexpr float click_reach = 4;  // farther than that is a drag

enum class Gesture { none, pressed, orbit, pan, handle };

struct NamedPart {
  HandlePart part;
  const char* name;
};
constexpr NamedPart moving[] = {
    {HandlePart::axis_x, "handle.x"},        {HandlePart::axis_y, "handle.y"},
    {HandlePart::axis_z, "handle.z"},        {HandlePart::plane_x, "handle.plane.x"},
    {HandlePart::plane_y, "handle.plane.y"}, {HandlePart::plane_z, "handle.plane.z"},
    {HandlePart::centre, "handle.centre"}};
constexpr NamedPart turning[] = {{HandlePart::ring_x, "handle.x"},
                                 {HandlePart::ring_y, "handle.y"},
                                 {HandlePart::ring_z, "handle.z"},
                                 {HandlePart::centre, "handle.centre"}};
constexpr NamedPart scaling[] = {{HandlePart::axis_x, "handle.x"},
                                 {HandlePart::axis_y, "handle.y"},
                                 {HandlePart::axis_z, "handle.z"},
                                 {HandlePart::centre, "handle.centre"}};

std::vector<NamedPart> parts_of(HandleMode mode) {
  if (mode == HandleMode::move) return {std::begin(moving), std::end(moving)};
  if (mode == HandleMode::rotate) return {std::begin(turning), std::end(turning)};
  return {std::begin(scaling), std::end(scaling)};
}

/// Above the handles, but not outside of the picture.
glm::dvec3 place_of_text(const Handles& handles, const Session& session) {
  const glm::dvec2 size = session.picture_size;
  const glm::dvec3 above = handles.origin + 1.3 * handles.size * session.camera.up();
  const glm::dvec2 pixel(session.camera.project(above, size));
  const glm::dvec2 most = glm::max(glm::dvec2(8, 24), size - glm::dvec2(260, 80));
  const Ray ray = session.camera.ray(glm::clamp(pixel, glm::dvec2(8, 24), most), size);
  return ray.origin + session.camera.distance * ray.direction;
}

}  // namespace

struct Navigation::State {
  Gesture gesture = Gesture::none;
  int button = 0;
  ImVec2 pressed_at{0, 0};
  std::optional<HandlePull> drag;
  std::optional<HandlePart> hovered;
  Picker picker;
  KnownTargets targets;

  void press(Session& session, glm::dvec2 at, int pressed_button);
  void follow(Session& session, glm::dvec2 at, glm::dvec2 size);
  void release(Session& session, glm::dvec2 at, glm::dvec2 size);
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
  session.dragging.clear();
  return true;
}

void Navigation::add_to(Picture& picture, const Session& session) const {
  const State& state = *state_;
  const std::optional<Handles> handles = state.drag ? state.drag->handles() : handles_of(session);
  if (!handles) return;
  HandlePicture drawn = draw(*handles, state.drag ? state.drag->part() : state.hovered,
                             session.camera, picture.bounds());
  const auto append = [](auto& all, auto& more) {
    all.insert(all.end(), std::make_move_iterator(more.begin()),
               std::make_move_iterator(more.end()));
  };
  append(picture.surfaces, drawn.surfaces);
  append(picture.lines, drawn.lines);
  append(picture.points, drawn.points);
  if (!state.drag) return;
  const PullState& pull = state.drag->state();
  const Theme& colours = theme(session.view.dark);
  if (!pull.edges.empty()) picture.lines.push_back({pull.edges, colours.step, 4, true});
  if (!pull.points.empty()) picture.points.push_back({pull.points, colours.step, 12});
  if (!pull.text.empty())
    picture.labels.push_back({place_of_text(*handles, session), pull.text, colours.text, true});
}

void Navigation::record(Widgets& widgets, const Session& session, const Rectangle& place) const {
  const std::optional<Handles> handles = handles_of(session);
  if (!handles) return;
  for (const auto& [part, name] : parts_of(handles->mode)) {
    const glm::dvec3 pixel =
        session.camera.project(handles->grip(part, session.camera), session.picture_size);
    Widget widget;
    widget.rectangle = {place.x + pixel.x - 5, place.y + pixel.y - 5, 10, 10};
    widget.surface = true;
    widgets.record(name, widget);
  }
}

void Navigation::State::press(Session& session, glm::dvec2 at, int pressed_button) {
  gesture = Gesture::pressed;
  button = pressed_button;
  pressed_at = ImGui::GetIO().MousePos;
  if (button != 0 || !hovered) return;
  gesture = Gesture::handle;
  drag.emplace(session, *handles_of(session), *hovered, at);
}

void Navigation::State::follow(Session& session, glm::dvec2 at, glm::dvec2 size) {
  const ImGuiIO& io = ImGui::GetIO();
  if (gesture == Gesture::pressed &&
      std::hypot(io.MousePos.x - pressed_at.x, io.MousePos.y - pressed_at.y) > click_reach)
    gesture = io.KeyShift && button != 0 ? Gesture::pan : Gesture::orbit;
  const glm::dvec2 by(io.MouseDelta.x, io.MouseDelta.y);
  if (gesture == Gesture::orbit) session.camera.orbit(-turn_per_unit * by.x, turn_per_unit * by.y);
  if (gesture == Gesture::pan) session.camera.pan(by, size);
  if (gesture == Gesture::handle && (by.x != 0 || by.y != 0))
    drag->pull(session, at, session.snapping != io.KeyCtrl, targets);
}

void Navigation::State::release(Session& session, glm::dvec2 at, glm::dvec2 size) {
  const ImGuiIO& io = ImGui::GetIO();
  if (gesture == Gesture::handle) {
    session.document.commit_draft();
    drag.reset();
  }
  if (gesture == Gesture::pressed && button == 0 && session.mode() == Mode::model)
    session.select(clicked_node(session, picker, session.camera.ray(at, size), Depth::outer),
                   io.KeyShift || io.KeyCtrl);
  gesture = Gesture::none;
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
    const std::optional<Handles> handles = over ? handles_of(session) : std::nullopt;
    state.hovered = handles ? handles->part_at(session.camera, at, size) : std::nullopt;
  }
  if (state.gesture == Gesture::none && over) {
    for (const int button : {0, 1, 2})
      if (ImGui::IsMouseClicked(button)) state.press(session, at, button);
    if (ImGui::IsMouseDoubleClicked(0) && !state.drag && session.mode() == Mode::model) {
      const NodeId hit =
          clicked_node(session, state.picker, session.camera.ray(at, size), Depth::inner);
      if (hit) session.select(hit);
      state.gesture = Gesture::none;
    }
  }
  if (state.gesture == Gesture::none) return;
  state.follow(session, at, size);
  if (!io.MouseDown[state.button]) state.release(session, at, size);
  session.dragging = state.drag ? state.drag->state().text : std::string();
}

}  // namespace sectile::viewer
