// How events get into Dear ImGui, in the one place that knows its versions: up to 1.86 (Debian 12)
// it looks at the state of keys and buttons, since 1.87 (Debian 13 has 1.90) it takes events.
#pragma once

#include <glm/glm.hpp>

#include "events/input.h"

namespace sectile::viewer::interface_input {

/// Once for each context of ImGui.
void prepare();

// To be called between two frames; all of it is seen in the next one.
void put_mouse(glm::dvec2 position);
void put_button(MouseButton button, bool down);
void put_scroll(glm::dvec2 notches);
void put_key(Key key, bool down);
void put_modifiers(bool shift, bool control, bool alt);
void put_text(const std::string& text);
/// Nothing is held down any more, and menus close.
void put_focus_lost();

/// Where the keyboard's mark stands on an item, Enter presses it as Space does. Before the frame.
void let_enter_activate();

/// Was the key pressed in this frame (not held)?
bool was_pressed(Key key);

}  // namespace sectile::viewer::interface_input
