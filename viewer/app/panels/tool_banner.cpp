#include <algorithm>

#include "app/icons.h"
#include "app/panels/panels.h"

namespace sectile::viewer {
namespace {

/// An invisible window over everything, so that no panel sees the mouse.
void shield() {
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({0, 0});
  ImGui::SetNextWindowSize(screen);
  ImGui::Begin("shield", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoBackground |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoNav);
  ImGui::End();
}

}  // namespace

void draw_tool_banner(PanelContext& context) {
  Session& session = context.session;
  if (!session.interface.tool) return;
  const bool takes_all = session.interface.tool->mouse() == PictureTool::Mouse::all;
  const Rectangle& picture = context.layout.picture;
  // Messages are at the top, the legend on the left.
  const float width = std::min(picture.width - 170, 620.0f);
  ImGui::SetNextWindowPos({picture.x + picture.width - 8, picture.y + picture.height - 8},
                          ImGuiCond_Always, {1, 1});
  ImGui::SetNextWindowSize({width, 0});
  ImGui::SetNextWindowBgAlpha(0.9f);
  ImGui::Begin("tool banner", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoMove | ImGuiWindowFlags_AlwaysAutoResize |
                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav);
  title(context, session.interface.tool->title().c_str());
  if (!takes_all) {
    ImGui::SameLine(width - 92);
    if (button(context, "tool.end", "Done (Esc)", "Ends this tool", true, 82)) {
      session.end_tool();
      context.widgets.record_window("panel.tool");
      ImGui::End();
      return;
    }
  }
  ImGui::PushFont(context.fonts.small);
  ImGui::PushTextWrapPos(width - 10);
  ImGui::TextUnformatted(session.interface.tool->hint(session.view).c_str());
  context.widgets.record_item("tool.hint");
  ImGui::PopTextWrapPos();
  ImGui::PopFont();
  context.widgets.record_window("panel.tool");
  ImGui::End();
  if (takes_all) shield();
}

}  // namespace sectile::viewer
