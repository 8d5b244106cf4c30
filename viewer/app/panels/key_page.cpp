// All keys and gestures on one page (F1).
#include <algorithm>

#include "app/interface_input.h"
#include "app/panels/panels.h"

namespace sectile::viewer {
namespace {

struct Gesture {
  const char* how;
  const char* what;
};
constexpr Gesture gestures[] = {
    {"Click", "select; with Shift or Ctrl: add or take away"},
    {"Double click", "select inside of an operation or a group"},
    {"Right click", "select, and a menu of what can be done"},
    {"Drag, middle drag", "turn the view; so does a drag of the view cube"},
    {"Right drag, Shift + middle drag", "move the view"},
    {"Wheel", "zoom to the pointer"},
    {"Shift + drag", "select all that a box meets"},
    {"Click on the view cube", "look at that side"},
    {"Drag of a handle", "move, turn or scale; Ctrl: snap or not; Esc: give back"},
};
constexpr Gesture while_transforming[] = {
    {"X, Y, Z", "along (about) this axis; again: the solid's own"},
    {"Shift+X, Shift+Y, Shift+Z", "in the plane across this axis"},
    {"0 \u2026 9  . , - / *", "type the distance, the angle or the factor: 40/3"},
    {"Tab", "type the number of the next axis"},
    {"Ctrl", "snap or not"},
    {"Enter, Space, click", "take"},
    {"Esc, right click", "give back"},
};

void heading(PanelContext& context, const char* text) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::Spacing();
  title(context, text);
  ImGui::TableNextColumn();
}

void row(const std::string& how, const std::string& what) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::TextDisabled("%s", how.c_str());
  ImGui::TableNextColumn();
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(what.c_str());
  ImGui::PopTextWrapPos();
}

void draw_menu(PanelContext& context, const CommandMenu& menu) {
  bool any = false;
  for (const Command& command : menu.commands) {
    const std::string keys = key_names(command);
    if (keys.empty()) continue;
    if (!any) heading(context, menu.title.c_str());
    any = true;
    row(keys, command.title);
  }
}

bool begin_half(const char* name, float height) {
  ImGui::BeginChild(name,
                    {name[0] == 'l' ? ImGui::GetContentRegionAvail().x * 0.5f - 6 : 0, height});
  if (!ImGui::BeginTable(name, 2)) return false;
  ImGui::TableSetupColumn("how", ImGuiTableColumnFlags_WidthStretch, 0.42f);
  ImGui::TableSetupColumn("what", ImGuiTableColumnFlags_WidthStretch, 0.58f);
  return true;
}

void draw_gestures(PanelContext& context, float height) {
  if (begin_half("left", height)) {
    heading(context, "Mouse in the picture");
    for (const Gesture& gesture : gestures) row(gesture.how, gesture.what);
    heading(context, "During G, R and S");
    for (const Gesture& gesture : while_transforming) row(gesture.how, gesture.what);
    const auto& menus = context.commands.menus();
    for (std::size_t i = 0; i < menus.size() / 2; ++i) draw_menu(context, menus[i]);
    ImGui::EndTable();
  }
  ImGui::EndChild();
}

void draw_commands(PanelContext& context, float height) {
  if (begin_half("right", height)) {
    const auto& menus = context.commands.menus();
    for (std::size_t i = menus.size() / 2; i < menus.size(); ++i) draw_menu(context, menus[i]);
    ImGui::EndTable();
  }
  ImGui::EndChild();
}

}  // namespace

void draw_key_page(PanelContext& context) {
  bool& open = context.session.interface.dialogs.keys;
  constexpr const char* name = "Keys and gestures";
  if (!open) return;
  if (!ImGui::IsPopupOpen(name)) ImGui::OpenPopup(name);
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({screen.x / 2, screen.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSize({std::min(860.0f, screen.x - 40), std::min(640.0f, screen.y - 60)});
  if (!ImGui::BeginPopupModal(
          name, &open,
          ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings))
    return;
  context.widgets.record_window("panel.keys");
  ImGui::PushFont(context.fonts.small);
  const float height = ImGui::GetContentRegionAvail().y - 40;
  draw_gestures(context, height);
  ImGui::SameLine(0, 12);
  draw_commands(context, height);
  ImGui::PopFont();
  const bool escaped = interface_input::was_pressed(Key::escape);
  if (button(context, "keys.close", "Close", "", true, 110) || escaped) open = false;
  if (!open) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
}

}  // namespace sectile::viewer
