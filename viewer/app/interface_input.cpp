#include "app/interface_input.h"

#include <imgui.h>

#include <utility>

namespace sectile::viewer::interface_input {
namespace {

/// The keys that ImGui itself looks at.
constexpr std::pair<Key, int> keys[] = {{Key::tab, ImGuiKey_Tab},
                                        {Key::left, ImGuiKey_LeftArrow},
                                        {Key::right, ImGuiKey_RightArrow},
                                        {Key::up, ImGuiKey_UpArrow},
                                        {Key::down, ImGuiKey_DownArrow},
                                        {Key::page_up, ImGuiKey_PageUp},
                                        {Key::page_down, ImGuiKey_PageDown},
                                        {Key::home, ImGuiKey_Home},
                                        {Key::end, ImGuiKey_End},
                                        {Key::insert, ImGuiKey_Insert},
                                        {Key::del, ImGuiKey_Delete},
                                        {Key::backspace, ImGuiKey_Backspace},
                                        {Key::space, ImGuiKey_Space},
                                        {Key::enter, ImGuiKey_Enter},
                                        {Key::escape, ImGuiKey_Escape},
                                        {static_cast<Key>('A'), ImGuiKey_A},
                                        {static_cast<Key>('C'), ImGuiKey_C},
                                        {static_cast<Key>('V'), ImGuiKey_V},
                                        {static_cast<Key>('X'), ImGuiKey_X},
                                        {static_cast<Key>('Y'), ImGuiKey_Y},
                                        {static_cast<Key>('Z'), ImGuiKey_Z}};

}  // namespace

#if IMGUI_VERSION_NUM >= 18700

namespace {

/// Negative if ImGui does not look at this key.
int imgui_key(Key key) {
  for (const auto& [ours, theirs] : keys)
    if (ours == key) return theirs;
  return -1;
}

// Another event says that the focus is back.
void focused() {
  ImGui::GetIO().AddFocusEvent(true);
}

}  // namespace

void prepare() {
  // EventQueue hands over as much as one frame can show.
  ImGui::GetIO().ConfigInputTrickleEventQueue = false;
}

void put_mouse(glm::dvec2 position) {
  focused();
  ImGui::GetIO().AddMousePosEvent(static_cast<float>(position.x), static_cast<float>(position.y));
}

void put_button(MouseButton button, bool down) {
  focused();
  ImGui::GetIO().AddMouseButtonEvent(static_cast<int>(button), down);
}

void put_scroll(glm::dvec2 notches) {
  ImGui::GetIO().AddMouseWheelEvent(static_cast<float>(notches.x), static_cast<float>(notches.y));
}

void put_key(Key key, bool down) {
  focused();
  if (const int theirs = imgui_key(key); theirs >= 0)
    ImGui::GetIO().AddKeyEvent(static_cast<ImGuiKey>(theirs), down);
}

void put_modifiers(bool shift, bool control, bool alt) {
  ImGuiIO& io = ImGui::GetIO();
  io.AddKeyEvent(ImGuiMod_Shift, shift);
  io.AddKeyEvent(ImGuiMod_Ctrl, control);
  io.AddKeyEvent(ImGuiMod_Alt, alt);
}

void put_focus_lost() {
  ImGuiIO& io = ImGui::GetIO();
  put_modifiers(false, false, false);
  for (const auto& [ours, theirs] : keys) io.AddKeyEvent(static_cast<ImGuiKey>(theirs), false);
  for (int button = 0; button < ImGuiMouseButton_COUNT; ++button)
    io.AddMouseButtonEvent(button, false);
  io.AddFocusEvent(false);
}

void let_enter_activate() {}  // it does

bool was_pressed(Key key) {
  const int theirs = imgui_key(key);
  return theirs >= 0 && ImGui::IsKeyPressed(static_cast<ImGuiKey>(theirs), false);
}

#else

void prepare() {
  for (const auto& [ours, theirs] : keys) ImGui::GetIO().KeyMap[theirs] = static_cast<int>(ours);
}

void put_mouse(glm::dvec2 position) {
  ImGui::GetIO().MousePos = {static_cast<float>(position.x), static_cast<float>(position.y)};
}

void put_button(MouseButton button, bool down) {
  ImGui::GetIO().MouseDown[static_cast<int>(button)] = down;
}

void put_scroll(glm::dvec2 notches) {
  ImGui::GetIO().MouseWheelH += static_cast<float>(notches.x);
  ImGui::GetIO().MouseWheel += static_cast<float>(notches.y);
}

void put_key(Key key, bool down) {
  ImGui::GetIO().KeysDown[static_cast<int>(key)] = down;
}

void put_modifiers(bool shift, bool control, bool alt) {
  ImGuiIO& io = ImGui::GetIO();
  io.KeyShift = shift;
  io.KeyCtrl = control;
  io.KeyAlt = alt;
}

void put_focus_lost() {
  ImGuiIO& io = ImGui::GetIO();
  for (bool& down : io.MouseDown) down = false;
  for (bool& down : io.KeysDown) down = false;
  put_modifiers(false, false, false);
  io.AddFocusEvent(false);
}

void let_enter_activate() {
  ImGuiIO& io = ImGui::GetIO();
  if (io.KeysDown[static_cast<int>(Key::enter)]) io.NavInputs[ImGuiNavInput_Activate] = 1;
}

bool was_pressed(Key key) {
  return ImGui::IsKeyPressed(static_cast<int>(key), false);
}

#endif

void put_text(const std::string& text) {
  ImGui::GetIO().AddInputCharactersUTF8(text.c_str());
}

}  // namespace sectile::viewer::interface_input
