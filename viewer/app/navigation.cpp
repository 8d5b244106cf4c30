#include "app/navigation.h"

#include <imgui.h>

#include <cmath>
#include <optional>

#include "app/box_select.h"
#include "app/clicking.h"
#include "app/handle_pull.h"

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

/// Does a node, or one below it, belong to the selection?
bool is_selected_above(const Session& session, NodeId id) {
  for (const NodeId selected : session.selection())
    if (id != 0 && session.scene().is_below(selected, id)) return true;
  return false;
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
  void begin_drag(Session& session, glm::dvec2 at);
  bool let_tool_act(Session& session, glm::dvec2 at, bool over);
  bool with_control = false;  // at the last look

  static Pointer pointer(glm::dvec2 at) {
    const ImGuiIO& io = ImGui::GetIO();
    return {at, io.KeyShift, io.KeyCtrl};
  }
};

Navigation::Navigation() : state_(std::make_unique<State>()) {}
Navigation::~Navigation() = default;

bool Navigation::is_dragging() const {
  return state_->gesture != Gesture::none && state_->gesture != Gesture::pressed;
}

bool Navigation::escape(Session& session) {
  if (session.interface.tool) {
    session.end_tool();
    return true;
  }
  if (!state_->drag) return false;
  session.document.drop_draft();
  state_->drag.reset();
  state_->gesture = Gesture::none;
  session.interface.dragging.clear();
  return true;
}

bool Navigation::key(Session& session, const Event& event) {
  if (!session.interface.tool) return false;
  session.tell_tool_of_changes();
  const bool taken = session.interface.tool->key(session, event);
  session.drop_done_tool();
  return taken;
}

void Navigation::text(Session& session, const std::string& typed) {
  session.tell_tool_of_changes();
  if (session.interface.tool) session.interface.tool->text(session, typed);
  session.drop_done_tool();
}

void Navigation::add_to(Picture& picture, const Session& session) const {
  const State& state = *state_;
  if (session.interface.tool) return session.interface.tool->add_to(picture, session.view);
  const std::optional<Handles> handles = state.drag ? state.drag->handles() : handles_of(session);
  if (!handles) return;
  HandlePicture drawn = draw(*handles, state.drag ? state.drag->part() : state.hovered,
                             session.view.camera, picture.bounds());
  const auto append = [](auto& all, auto& more) {
    all.insert(all.end(), std::make_move_iterator(more.begin()),
               std::make_move_iterator(more.end()));
  };
  append(picture.surfaces, drawn.surfaces);
  append(picture.lines, drawn.lines);
  append(picture.points, drawn.points);
  if (state.drag) add_marks(picture, session.view, *handles, state.drag->state());
}

void Navigation::record(Widgets& widgets, const Session& session, const Rectangle& place) const {
  const std::optional<Handles> handles = handles_of(session);
  if (!handles || session.interface.tool) return;
  for (const auto& [part, name] : parts_of(handles->mode)) {
    const glm::dvec3 pixel = session.view.camera.project(handles->grip(part, session.view.camera),
                                                         session.view.picture_size);
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

void Navigation::State::begin_drag(Session& session, glm::dvec2 at) {
  const ImGuiIO& io = ImGui::GetIO();
  const bool pans = button == 1 || (button == 2 && io.KeyShift);
  gesture = pans ? Gesture::pan : Gesture::orbit;
  if (button != 0 || !io.KeyShift || session.interface.tool || !session.is_modelling()) return;
  const glm::dvec2 way(io.MousePos.x - pressed_at.x, io.MousePos.y - pressed_at.y);
  session.begin_tool(std::make_unique<BoxSelect>(at - way));
  gesture = Gesture::none;
}

void Navigation::State::follow(Session& session, glm::dvec2 at, glm::dvec2 size) {
  const ImGuiIO& io = ImGui::GetIO();
  if (gesture == Gesture::pressed &&
      std::hypot(io.MousePos.x - pressed_at.x, io.MousePos.y - pressed_at.y) > click_reach)
    begin_drag(session, at);
  const glm::dvec2 by(io.MouseDelta.x, io.MouseDelta.y);
  if (gesture == Gesture::orbit)
    session.view.camera.orbit(-turn_per_unit * by.x, turn_per_unit * by.y);
  if (gesture == Gesture::pan) session.view.camera.pan(by, size);
  if (gesture == Gesture::handle && (by.x != 0 || by.y != 0))
    drag->pull(session, at, session.view.snapping != io.KeyCtrl, targets);
}

void Navigation::State::release(Session& session, glm::dvec2 at, glm::dvec2 size) {
  const ImGuiIO& io = ImGui::GetIO();
  if (session.interface.tool) {
    // A click: drags turned the view.
    if (gesture == Gesture::pressed && button == 0)
      session.interface.tool->press(session, pointer(at));
    session.drop_done_tool();
    gesture = Gesture::none;
    return;
  }
  if (gesture == Gesture::handle) {
    session.document.commit_draft();
    drag.reset();
  }
  if (gesture == Gesture::pressed && button == 1) {
    const NodeId hit =
        clicked_node(session, picker, session.view.camera.ray(at, size), Depth::outer);
    if (session.is_modelling() && !is_selected_above(session, hit)) session.select(hit);
    session.interface.context_menu = !session.results.repair.is_open();
  }
  if (gesture == Gesture::pressed && button == 0 && session.is_modelling())
    session.select(clicked_node(session, picker, session.view.camera.ray(at, size), Depth::outer),
                   io.KeyShift || io.KeyCtrl);
  gesture = Gesture::none;
}

/// Tools that take the mouse; true if nothing else of it is left.
bool Navigation::State::let_tool_act(Session& session, glm::dvec2 at, bool over) {
  if (!session.interface.tool) return false;
  const ImGuiIO& io = ImGui::GetIO();
  PictureTool& tool = *session.interface.tool;
  const PictureTool::Mouse mouse = tool.mouse();
  const Pointer now = pointer(at);
  const bool moved = io.MouseDelta.x != 0 || io.MouseDelta.y != 0 || io.KeyCtrl != with_control;
  with_control = io.KeyCtrl;
  if (moved && (over || mouse != PictureTool::Mouse::clicks)) tool.follow(session, now);
  if (mouse == PictureTool::Mouse::clicks) return false;
  if (ImGui::IsMouseClicked(0) && (over || mouse == PictureTool::Mouse::all))
    tool.press(session, now);
  else if (ImGui::IsMouseReleased(0))
    tool.release(session, now);
  else if (ImGui::IsMouseClicked(1) && mouse == PictureTool::Mouse::all)
    session.end_tool();
  session.drop_done_tool();
  return mouse == PictureTool::Mouse::all || io.MouseDown[0];
}

void Navigation::update(Session& session, const Rectangle& place) {
  const ImGuiIO& io = ImGui::GetIO();
  State& state = *state_;
  const glm::dvec2 size(place.width, place.height);
  const glm::dvec2 at(io.MousePos.x - place.x, io.MousePos.y - place.y);
  session.interface.pointer = at;
  session.tell_tool_of_changes();
  if (session.results.repair.is_open() && state.drag) {
    state.drag.reset();
    state.gesture = Gesture::none;
  }
  const bool over = place.contains(io.MousePos.x, io.MousePos.y) && !io.WantCaptureMouse;
  if (over && io.MouseWheel != 0)
    session.view.camera.zoom(std::pow(zoom_per_notch, static_cast<double>(io.MouseWheel)), at,
                             size);
  if (state.let_tool_act(session, at, over)) {
    state.gesture = Gesture::none;
    return;
  }
  if (state.gesture == Gesture::none) {
    const std::optional<Handles> handles =
        over && !session.interface.tool ? handles_of(session) : std::nullopt;
    state.hovered = handles ? handles->part_at(session.view.camera, at, size) : std::nullopt;
  }
  if (state.gesture == Gesture::none && over) {
    for (const int button : {0, 1, 2})
      if (ImGui::IsMouseClicked(button)) state.press(session, at, button);
    if (ImGui::IsMouseDoubleClicked(0) && !state.drag && !session.interface.tool &&
        session.is_modelling()) {
      const NodeId hit =
          clicked_node(session, state.picker, session.view.camera.ray(at, size), Depth::inner);
      if (hit) session.select(hit);
      state.gesture = Gesture::none;
    }
  }
  if (state.gesture == Gesture::none) return;
  state.follow(session, at, size);
  if (session.interface.tool && state.gesture == Gesture::none) {
    // A box was begun, and perhaps the button let go in the same frame.
    session.interface.tool->follow(session, State::pointer(at));
    if (!io.MouseDown[0]) session.interface.tool->release(session, State::pointer(at));
    return session.drop_done_tool();
  }
  if (!io.MouseDown[state.button]) state.release(session, at, size);
  if (!session.interface.tool)
    session.interface.dragging = state.drag ? state.drag->state().text : std::string();
}

}  // namespace sectile::viewer
