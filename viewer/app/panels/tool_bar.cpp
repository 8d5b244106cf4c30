#include <vector>

#include "app/icons.h"
#include "app/panels/panels.h"
#include "app/words.h"
#include "scene/primitive_kind.h"

namespace sectile::viewer {
namespace {

void line(float gap) {
  ImGui::SameLine(0, gap);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::GetWindowDrawList()->AddLine({at.x, at.y + 4}, {at.x, at.y + 38},
                                      ImGui::GetColorU32(ImGuiCol_Border));
  ImGui::Dummy({1, 42});
  ImGui::SameLine(0, gap);
}

void add_button(PanelContext& context, bool with_title) {
  command_button(context, "tool.add", with_title);
  if (context.session.interface.adding) {
    ImGui::OpenPopup("add popup");
    context.session.interface.adding = false;
  }
  const Widget* place = context.widgets.find("tool.add");
  ImGui::SetNextWindowPos({place->rectangle.x, place->rectangle.y + place->rectangle.w + 2});
  if (!ImGui::BeginPopup("add popup")) return;
  for (const PrimitiveKind* kind : primitive_kinds())
    command_item(context, "add." + std::string(kind->name));
  ImGui::Separator();
  command_item(context, "profile.xy");
  command_item(context, "profile.face");
  ImGui::Separator();
  command_item(context, "file.import");
  ImGui::EndPopup();
}

/// The two modes, as tabs that fill the height of the bar.
void mode_tab(PanelContext& context, const char* name) {
  const Command& command = context.commands.get(name);
  const bool on = command.is_on(context.session);
  const std::string text = command.icon + "  " + command.title;
  ImGui::PushFont(context.fonts.bold);
  const ImVec2 size{ImGui::CalcTextSize(text.c_str()).x + 20, 42};
  const ImVec4 colour = ImGui::GetStyleColorVec4(on ? ImGuiCol_SliderGrabActive : ImGuiCol_Button);
  ImGui::PushStyleColor(ImGuiCol_Button, colour);
  if (on) ImGui::PushStyleColor(ImGuiCol_ButtonHovered, colour);
  if (on) ImGui::PushStyleColor(ImGuiCol_Text, ImVec4(1, 1, 1, 1));
  ImGui::BeginDisabled(!is_enabled(command, context.session));
  const bool pressed = ImGui::Button((text + "##" + name).c_str(), size);
  ImGui::EndDisabled();
  ImGui::PopStyleColor(on ? 3 : 1);
  context.widgets.record_item(name, true, size.x - 20);
  ImGui::PopFont();
  tooltip(command.help + "\nKey: Tab");
  if (pressed) context.commands.run(context.session, command);
}

}  // namespace

void draw_tool_bar(PanelContext& context) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {8, 5});
  begin_panel(context, "tool_bar", context.layout.tool_bar, ImGuiWindowFlags_NoScrollbar);
  ImGui::PopStyleVar();
  const bool wide = context.layout.tool_bar.width >= 1000;
  const float gap = wide ? 6 : 3;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {2, 0});
  mode_tab(context, "mode.model");
  ImGui::SameLine();
  mode_tab(context, "mode.steps");
  const std::vector<std::vector<const char*>> groups = {
      {"file.open", "file.save"},
      {"edit.undo", "edit.redo"},
      {},
      {"handle.move", "handle.rotate", "handle.scale", "handle.local", "handle.snap"},
      {"operation.unite", "operation.intersect", "operation.subtract", "operation.split"},
      {"view.frame", "view.panel"}};
  for (const auto& group : groups) {
    line(gap);
    if (group.empty()) add_button(context, true);
    for (const char* name : group) {
      if (name != group.front()) ImGui::SameLine();
      // Where the window is narrow, what everybody knows goes without words.
      const bool known = group.front() == groups[0].front() || group.front() == groups[1].front();
      command_button(context, name, wide || !known);
    }
  }
  ImGui::PopStyleVar();
  end_panel();
}

}  // namespace sectile::viewer
