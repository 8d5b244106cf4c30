#include "app/event_queue.h"

#include <imgui.h>

#include <cfloat>
#include <optional>
#include <set>

namespace sectile::viewer {
namespace {

bool has_modifiers(Event::Kind kind) {
  return kind != Event::Kind::text && kind != Event::Kind::drop &&
         kind != Event::Kind::focus_lost && kind != Event::Kind::close;
}

/// What changed in this frame already and so cannot change again in it.
struct Changed {
  std::set<int> buttons, keys;
  std::optional<Event> first;  // of those with modifiers

  bool has_other_modifiers(const Event& event) const {
    return first && has_modifiers(event.kind) &&
           (first->shift != event.shift || first->control != event.control ||
            first->alt != event.alt);
  }

  bool admits(const Event& event) const {
    // Ctrl that is pressed for a key just after a drag does not change the drag.
    if (has_other_modifiers(event)) return false;
    switch (event.kind) {
      case Event::Kind::mouse_move:
        return buttons.empty();
      case Event::Kind::mouse_down:
      case Event::Kind::mouse_up:
        return !buttons.count(static_cast<int>(event.button));
      case Event::Kind::key_down:
        // Commands run before the mouse is looked at, and not within a drag that ends in this
        // frame.
        return buttons.empty() && !keys.count(static_cast<int>(event.key));
      case Event::Kind::key_up:
        return !keys.count(static_cast<int>(event.key));
      case Event::Kind::scroll:
      case Event::Kind::text:
        return true;
      default:
        return true;
    }
  }
};

void release_everything(ImGuiIO& io) {
  for (bool& down : io.MouseDown) down = false;
  for (bool& down : io.KeysDown) down = false;
  io.KeyShift = io.KeyCtrl = io.KeyAlt = false;
  io.AddFocusEvent(false);
}

void apply(const Event& event, ImGuiIO& io, Changed& changed) {
  if (has_modifiers(event.kind)) {
    io.KeyShift = event.shift;
    io.KeyCtrl = event.control;
    io.KeyAlt = event.alt;
    if (!changed.first) changed.first = event;
  }
  const bool down = event.kind == Event::Kind::mouse_down || event.kind == Event::Kind::key_down;
  switch (event.kind) {
    case Event::Kind::mouse_move:
      io.MousePos = {static_cast<float>(event.position.x), static_cast<float>(event.position.y)};
      break;
    case Event::Kind::mouse_down:
    case Event::Kind::mouse_up:
      io.MouseDown[static_cast<int>(event.button)] = down;
      changed.buttons.insert(static_cast<int>(event.button));
      break;
    case Event::Kind::scroll:
      io.MouseWheelH += static_cast<float>(event.scroll.x);
      io.MouseWheel += static_cast<float>(event.scroll.y);
      break;
    case Event::Kind::key_down:
    case Event::Kind::key_up:
      io.KeysDown[static_cast<int>(event.key)] = down;
      changed.keys.insert(static_cast<int>(event.key));
      break;
    case Event::Kind::text:
      io.AddInputCharactersUTF8(event.text.c_str());
      break;
    case Event::Kind::focus_lost:
      release_everything(io);
      break;
    case Event::Kind::drop:
    case Event::Kind::close:
      break;
  }
}

}  // namespace

void EventQueue::map_keys() {
  ImGuiIO& io = ImGui::GetIO();
  const auto map = [&](ImGuiKey_ theirs, int ours) { io.KeyMap[theirs] = ours; };
  map(ImGuiKey_Tab, static_cast<int>(Key::tab));
  map(ImGuiKey_LeftArrow, static_cast<int>(Key::left));
  map(ImGuiKey_RightArrow, static_cast<int>(Key::right));
  map(ImGuiKey_UpArrow, static_cast<int>(Key::up));
  map(ImGuiKey_DownArrow, static_cast<int>(Key::down));
  map(ImGuiKey_PageUp, static_cast<int>(Key::page_up));
  map(ImGuiKey_PageDown, static_cast<int>(Key::page_down));
  map(ImGuiKey_Home, static_cast<int>(Key::home));
  map(ImGuiKey_End, static_cast<int>(Key::end));
  map(ImGuiKey_Insert, static_cast<int>(Key::insert));
  map(ImGuiKey_Delete, static_cast<int>(Key::del));
  map(ImGuiKey_Backspace, static_cast<int>(Key::backspace));
  map(ImGuiKey_Space, static_cast<int>(Key::space));
  map(ImGuiKey_Enter, static_cast<int>(Key::enter));
  map(ImGuiKey_Escape, static_cast<int>(Key::escape));
  for (const auto& [theirs, letter] : {std::pair{ImGuiKey_A, 'A'},
                                       {ImGuiKey_C, 'C'},
                                       {ImGuiKey_V, 'V'},
                                       {ImGuiKey_X, 'X'},
                                       {ImGuiKey_Y, 'Y'},
                                       {ImGuiKey_Z, 'Z'}})
    map(theirs, letter);
}

void EventQueue::add(const Input& input) {
  waiting_.insert(waiting_.end(), input.events.begin(), input.events.end());
}

std::vector<Event> EventQueue::feed() {
  ImGuiIO& io = ImGui::GetIO();
  Changed changed;
  std::vector<Event> fed;
  while (!waiting_.empty() && changed.admits(waiting_.front())) {
    apply(waiting_.front(), io, changed);
    fed.push_back(std::move(waiting_.front()));
    waiting_.pop_front();
  }
  return fed;
}

}  // namespace sectile::viewer
