#include "app/icons.h"
#include "app/panels/panels.h"

namespace sectile::viewer {
namespace {

constexpr const char* gestures =
    "Drag: turn   \u00B7   Shift + middle drag: move the view   \u00B7   Wheel: zoom";

std::string next_step(const Session& session) {
  const std::size_t roots = session.scene().roots().size();
  if (session.mode() == Mode::steps)
    return "Next: press Right to go one step on, N for the next special case, Space to play. Tab "
           "goes "
           "back to the model.";
  if (session.scene().size() == 0)
    return "Next: add a first solid (Shift+A), drop a file into the window, or open a sample.";
  if (session.story_node() != 0) {
    if (session.selection().empty())
      return "Next: click the result to see its operands, or press Tab to watch the steps.";
    return "Next: drag a handle and see the result follow, or press Tab to watch the steps.";
  }
  if (roots == 1) return "Next: add a second solid (Shift+A).";
  if (session.topmost_selected().size() >= 2)
    return "Next: press U to unite, I to intersect, D to subtract the second from the first.";
  if (session.selection().empty()) return "Next: click a solid to select it; its handles appear.";
  return "Next: drag the handles so that the solids meet, then Shift+click the other solid.";
}

}  // namespace

float hint_strip_height(const PanelContext& context) {
  if (!context.session.view.hints) return 0;
  const float width = context.layout.picture.width - 60;
  const float line = ImGui::GetTextLineHeightWithSpacing();
  const auto lines = [&](const std::string& text) {
    return ImGui::CalcTextSize(text.c_str(), nullptr, false, width).y / ImGui::GetTextLineHeight();
  };
  ImGui::PushFont(context.fonts.small);
  const float needed = lines(gestures) + lines(next_step(context.session));
  ImGui::PopFont();
  return needed * line * 0.86f + 18;
}

void draw_hint_strip(PanelContext& context) {
  if (!context.session.view.hints) return;
  const Rectangle& picture = context.layout.picture;
  const float height = hint_strip_height(context);
  ImGui::SetNextWindowPos({picture.x, picture.y + picture.height - height});
  ImGui::SetNextWindowSize({picture.width, height});
  ImGui::SetNextWindowBgAlpha(0.90f);
  ImGui::Begin("hints", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
                   ImGuiWindowFlags_NoNav);
  ImGui::PushFont(context.fonts.small);
  ImGui::PushTextWrapPos(picture.width - 44);
  ImGui::TextDisabled("%s", icons::info);
  ImGui::SameLine();
  ImGui::BeginGroup();
  ImGui::TextUnformatted(gestures);
  ImGui::TextUnformatted(next_step(context.session).c_str());
  ImGui::EndGroup();
  context.widgets.record_item("hints.text");
  ImGui::PopTextWrapPos();
  ImGui::PopFont();
  ImGui::SetCursorPos({picture.width - 34, 6});
  if (icon_button(context, "hints.close", icons::cross, "Close the hints (Help brings them back)"))
    context.session.view.hints = false;
  context.widgets.record_window("hints");
  ImGui::End();
}

}  // namespace sectile::viewer
