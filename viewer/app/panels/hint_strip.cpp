#include "app/icons.h"
#include "app/panels/panels.h"

namespace sectile::viewer {
namespace {

constexpr const char* gestures =
    "Drag: turn   \u00B7   Right drag: move the view   \u00B7   Wheel: zoom   \u00B7   "
    "Right click: menu";

std::string next_step(const Session& session) {
  if (session.results.repair.is_open())
    return "Next: look through what is wrong, choose how it is repaired and compare Before and "
           "After. Cancel leaves the scene as it is.";
  const std::size_t roots = session.scene().roots().size();
  if (session.mode() == Mode::steps)
    return "Next: press Right to go one step on, N for the next special case, Space to play. "
           "Tab goes back to the model.";
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

void draw_hint_strip(PanelContext& context) {
  const Rectangle& place = context.layout.hints;
  if (place.height <= 0) return;
  begin_panel(context, "hints", place, ImGuiWindowFlags_NoScrollbar);
  ImGui::PushFont(context.fonts.small);
  ImGui::PushTextWrapPos(place.width - 44);
  ImGui::TextDisabled("%s", icons::info);
  ImGui::SameLine();
  ImGui::BeginGroup();
  ImGui::TextUnformatted(gestures);
  ImGui::TextUnformatted(next_step(context.session).c_str());
  ImGui::EndGroup();
  context.widgets.record_item("hints.text");
  ImGui::PopTextWrapPos();
  ImGui::PopFont();
  ImGui::SetCursorPos({place.width - 34, 6});
  if (icon_button(context, "hints.close", icons::cross, "Close the hints (Help brings them back)"))
    context.session.view.hints = false;
  end_panel();
}

}  // namespace sectile::viewer
