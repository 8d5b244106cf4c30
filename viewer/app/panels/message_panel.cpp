#include <algorithm>

#include "app/icons.h"
#include "app/panels/panels.h"

namespace sectile::viewer {

void draw_messages(PanelContext& context) {
  Session& session = context.session;
  const Rectangle& picture = context.layout.picture;
  // Beside the view settings, if they are open.
  const float taken = session.view_panel ? 260.0f : 0.0f;
  const float width = std::min(460.0f, picture.width - 16 - taken);
  float y = picture.y + 8;
  for (std::size_t i = 0; i < session.messages.shown().size(); ++i) {
    const Message message = session.messages.shown()[i];
    ImGui::SetNextWindowPos({picture.x + (picture.width - taken - width) / 2, y});
    ImGui::SetNextWindowSize({width, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 5);
    if (message.is_error) ImGui::PushStyleColor(ImGuiCol_Border, ImVec4(0.84f, 0.24f, 0.12f, 1));
    ImGui::Begin(("message " + std::to_string(i)).c_str(), nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
                     ImGuiWindowFlags_NoNav | ImGuiWindowFlags_AlwaysAutoResize);
    if (message.is_error) ImGui::PopStyleColor();
    ImGui::PopStyleVar();
    if (message.is_error)
      ImGui::TextColored(ImVec4(0.84f, 0.24f, 0.12f, 1), "%s", icons::warning);
    else
      ImGui::TextDisabled("%s", icons::info);
    ImGui::SameLine();
    ImGui::PushTextWrapPos(width - 40);
    ImGui::TextUnformatted(message.text.c_str());
    ImGui::PopTextWrapPos();
    context.widgets.record_item("message." + std::to_string(i));
    ImGui::SameLine(width - 34);
    if (icon_button(context, "message.close." + std::to_string(i), icons::cross, "Close"))
      session.messages.close(i);
    context.widgets.record_window("panel.message." + std::to_string(i));
    y += ImGui::GetWindowSize().y + 6;
    ImGui::End();
  }
}

}  // namespace sectile::viewer
