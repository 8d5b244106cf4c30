#include "app/elements.h"

#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <type_traits>

namespace sectile::viewer {

void begin_panel(PanelContext& context, const char* name, const Rectangle& place,
                 ImGuiWindowFlags flags) {
  ImGui::SetNextWindowPos({place.x, place.y});
  ImGui::SetNextWindowSize({place.width, place.height});
  ImGui::Begin(name, nullptr,
               flags | ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                   ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus |
                   ImGuiWindowFlags_NoNav);
  context.widgets.record_window(std::string("panel.") + name);
}

void end_panel() {
  ImGui::End();
}

void title(PanelContext& context, const char* text) {
  ImGui::PushFont(context.fonts.bold);
  ImGui::TextUnformatted(text);
  ImGui::PopFont();
  context.widgets.record_text(text);
}

float text_width(const std::string& text) {
  return ImGui::CalcTextSize(text.c_str(), nullptr, true).x;
}

// Who only passes over a button wants to read nothing, and would see boxes flash.
bool is_tooltip_pending() {
  constexpr float patience = 0.4f;
  const ImGuiContext& context = *ImGui::GetCurrentContext();
  return context.HoveredId != 0 && context.HoveredIdTimer < patience;
}

void tooltip(const std::string& text) {
  if (text.empty() || !ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
  if (is_tooltip_pending()) return;
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(ImGui::GetFontSize() * 22);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

std::string tooltip_of(const Command& command) {
  const std::string key = key_name(command);
  return command.help + (key.empty() ? "" : "\nKey: " + key);
}

void note(PanelContext& context, const std::string& text) {
  ImGui::PushFont(context.fonts.small);
  ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
  ImGui::PopFont();
  context.widgets.record_text(text);
}

bool button(PanelContext& context, const std::string& name, const std::string& text,
            const std::string& help, bool enabled, float width, bool on) {
  ImGui::BeginDisabled(!enabled);
  if (on) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_HeaderActive));
  const bool pressed = ImGui::Button((text + "##" + name).c_str(), {width, 0});
  if (on) ImGui::PopStyleColor();
  ImGui::EndDisabled();
  context.widgets.record_item(name, enabled, text_width(text));
  tooltip(help);
  return pressed;
}

bool icon_button(PanelContext& context, const std::string& name, const char* icon,
                 const std::string& help, bool enabled, bool on) {
  const float size = ImGui::GetFrameHeight();
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0, ImGui::GetStyle().FramePadding.y});
  const bool pressed = button(context, name, icon, help, enabled, size + 4, on);
  ImGui::PopStyleVar();
  return pressed;
}

namespace {

/// Icon above title, as on the tool bar; both centred.
bool tall_button(PanelContext& context, const Command& command, bool with_title, bool enabled,
                 bool on) {
  ImGui::PushFont(context.fonts.small);
  const ImVec2 text = ImGui::CalcTextSize(command.title.c_str());
  ImGui::PopFont();
  const ImVec2 size{with_title ? std::max(text.x + 10, 38.0f) : 36, 42};
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::BeginDisabled(!enabled);
  ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, on ? 1.0f : 0.0f);
  ImGui::PushStyleColor(ImGuiCol_Button,
                        on ? ImGui::GetStyleColorVec4(ImGuiCol_Header) : ImVec4(0, 0, 0, 0));
  const bool pressed = ImGui::Button(("##" + command.name).c_str(), size);
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
  context.widgets.record_item(command.name, enabled, with_title ? text.x : 0);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const ImU32 colour = ImGui::GetColorU32(ImGuiCol_Text);
  ImGui::PushFont(context.fonts.title);
  const ImVec2 icon = ImGui::CalcTextSize(command.icon.c_str());
  draw.AddText({at.x + (size.x - icon.x) / 2, at.y + (with_title ? 3 : (size.y - icon.y) / 2)},
               colour, command.icon.c_str());
  ImGui::PopFont();
  if (with_title) {
    ImGui::PushFont(context.fonts.small);
    draw.AddText({at.x + (size.x - text.x) / 2, at.y + size.y - text.y - 3}, colour,
                 command.title.c_str());
    ImGui::PopFont();
  }
  ImGui::EndDisabled();
  return pressed;
}

}  // namespace

void command_button(PanelContext& context, std::string_view name, bool with_title) {
  const Command& command = context.commands.get(name);
  const bool enabled = is_enabled(command, context.session);
  const bool on = command.is_on && command.is_on(context.session);
  const bool pressed = tall_button(context, command, with_title, enabled, on);
  tooltip(tooltip_of(command));
  if (pressed) context.commands.run(context.session, command);
}

void command_item(PanelContext& context, std::string_view name) {
  const Command& command = context.commands.get(name);
  const bool enabled = is_enabled(command, context.session);
  const bool on = command.is_on && command.is_on(context.session);
  const std::string key = key_name(command);
  const bool pressed = ImGui::MenuItem((command.title + "##" + command.name).c_str(),
                                       key.empty() ? nullptr : key.c_str(), on, enabled);
  context.widgets.record_item("menu:" + command.name, enabled);
  tooltip(command.help);
  if (pressed) context.commands.run(context.session, command);
}

bool checkbox(PanelContext& context, const std::string& name, const char* text, bool& value,
              const std::string& help) {
  const bool pressed = ImGui::Checkbox((std::string(text) + "##" + name).c_str(), &value);
  context.widgets.record_item(name);
  tooltip(help);
  return pressed;
}

namespace {

template <class Number>
std::string written(const SliderText& text, Number value) {
  std::array<char, 80> room{};
  std::snprintf(room.data(), room.size(), text.format, value);
  return room.data();
}

/// The value that ImGui writes into a slider lies on its grab: it is hidden, except while one is
/// typed there, and written beside it.
template <class Number>
bool slider_of(PanelContext& context, const std::string& name, Number& value, Number low,
               Number high, const SliderText& text, float width) {
  constexpr ImGuiDataType type =
      std::is_same_v<Number, int> ? ImGuiDataType_S32 : ImGuiDataType_Double;
  const float gap = 7;
  if (width == 0) width = ImGui::GetContentRegionAvail().x;
  const std::string label = "##" + name;
  const bool typing = ImGui::TempInputIsActive(ImGui::GetID(label.c_str()));
  ImGui::BeginGroup();
  ImGui::SetNextItemWidth(std::max(40.0f, width - gap - text_width(text.widest)));
  if (!typing) ImGui::PushStyleColor(ImGuiCol_Text, ImVec4(0, 0, 0, 0));
  const bool moved = ImGui::SliderScalar(label.c_str(), type, &value, &low, &high, text.format,
                                         ImGuiSliderFlags_AlwaysClamp);
  if (!typing) ImGui::PopStyleColor();
  context.widgets.record_item(name);
  ImGui::SameLine(0, gap);
  const std::string beside = written(text, value);
  ImGui::TextUnformatted(beside.c_str());
  context.widgets.record_text(beside);
  ImGui::EndGroup();
  return moved;
}

}  // namespace

bool slider(PanelContext& context, const std::string& name, double& value, double low, double high,
            const SliderText& text, float width) {
  return slider_of(context, name, value, low, high, text, width);
}

bool slider(PanelContext& context, const std::string& name, int& value, int low, int high,
            const SliderText& text, float width) {
  return slider_of(context, name, value, low, high, text, width);
}

}  // namespace sectile::viewer
