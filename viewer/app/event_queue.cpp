#include "app/event_queue.h"

#include <optional>
#include <set>

#include "app/interface_input.h"

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

void apply(const Event& event, Changed& changed) {
  if (has_modifiers(event.kind)) {
    interface_input::put_modifiers(event.shift, event.control, event.alt);
    if (!changed.first) changed.first = event;
  }
  const bool down = event.kind == Event::Kind::mouse_down || event.kind == Event::Kind::key_down;
  switch (event.kind) {
    case Event::Kind::mouse_move:
      interface_input::put_mouse(event.position);
      break;
    case Event::Kind::mouse_down:
    case Event::Kind::mouse_up:
      interface_input::put_button(event.button, down);
      changed.buttons.insert(static_cast<int>(event.button));
      break;
    case Event::Kind::scroll:
      interface_input::put_scroll(event.scroll);
      break;
    case Event::Kind::key_down:
    case Event::Kind::key_up:
      interface_input::put_key(event.key, down);
      changed.keys.insert(static_cast<int>(event.key));
      break;
    case Event::Kind::text:
      interface_input::put_text(event.text);
      break;
    case Event::Kind::focus_lost:
      interface_input::put_focus_lost();
      break;
    case Event::Kind::drop:
    case Event::Kind::close:
      break;
  }
}

}  // namespace

void EventQueue::add(const Input& input) {
  waiting_.insert(waiting_.end(), input.events.begin(), input.events.end());
}

std::vector<Event> EventQueue::feed() {
  Changed changed;
  std::vector<Event> fed;
  while (!waiting_.empty() && changed.admits(waiting_.front())) {
    apply(waiting_.front(), changed);
    fed.push_back(std::move(waiting_.front()));
    waiting_.pop_front();
  }
  return fed;
}

}  // namespace sectile::viewer
