#include <algorithm>
#include <chrono>
#include <ctime>

#include "app/icons.h"
#include "app/panels/panels.h"

namespace sectile::viewer {
namespace {

std::string clock_time(std::chrono::system_clock::time_point time) {
  const std::time_t seconds = std::chrono::system_clock::to_time_t(time);
  std::tm local{};
  localtime_r(&seconds, &local);
  char text[16];
  std::strftime(text, sizeof text, "%H:%M:%S", &local);
  return text;
}

/// The newest first.
void draw_rows(PanelContext& context) {
  const std::vector<Message>& all = context.session.interface.messages.all();
  for (std::size_t i = all.size(); i-- > 0;) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextDisabled("%s", clock_time(all[i].time).c_str());
    ImGui::TableNextColumn();
    if (all[i].is_error)
      ImGui::TextColored(ImVec4(0.84f, 0.24f, 0.12f, 1), "%s", icons::warning);
    else
      ImGui::TextDisabled("%s", icons::info);
    ImGui::TableNextColumn();
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(all[i].text.c_str());
    ImGui::PopTextWrapPos();
  }
}

void draw_list(PanelContext& context) {
  Messages& messages = context.session.interface.messages;
  const Rectangle& picture = context.layout.picture;
  const float width = std::min(620.0f, picture.width - 16);
  const float height = std::min(360.0f, picture.height - 16);
  ImGui::SetNextWindowPos({picture.x + 8, picture.y + picture.height - 8}, ImGuiCond_Always,
                          {0, 1});
  ImGui::SetNextWindowSize({width, height});
  ImGui::Begin("message list", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav);
  context.widgets.record_window("panel.messages");
  title(context, "Messages");
  ImGui::SameLine(width - 36);
  if (icon_button(context, "messages.close", icons::cross, "Close")) messages.list_open = false;
  ImGui::BeginChild("rows");
  if (messages.all().empty()) note(context, "Nothing was said yet.");
  if (ImGui::BeginTable("messages", 3, ImGuiTableFlags_RowBg | ImGuiTableFlags_NoSavedSettings)) {
    ImGui::TableSetupColumn("time", ImGuiTableColumnFlags_WidthFixed);
    ImGui::TableSetupColumn("kind", ImGuiTableColumnFlags_WidthFixed);
    ImGui::TableSetupColumn("text", ImGuiTableColumnFlags_WidthStretch);
    draw_rows(context);
    ImGui::EndTable();
  }
  ImGui::EndChild();
  ImGui::End();
}

/// Below the messages for which there was room.
void draw_more(PanelContext& context, float x, float y, float width) {
  Messages& messages = context.session.interface.messages;
  ImGui::SetNextWindowPos({x, y});
  ImGui::SetNextWindowSize({width, 0});
  ImGui::Begin("more messages", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
                   ImGuiWindowFlags_NoNav | ImGuiWindowFlags_AlwaysAutoResize);
  const std::string text = "And " + std::to_string(messages.waiting()) + " more: show all";
  if (button(context, "messages.more", text, "Opens the list of all messages", true, 200))
    messages.list_open = true, messages.close_all();
  ImGui::SameLine();
  if (button(context, "messages.close_all", "Close all", "They stay in the list", true, 100))
    messages.close_all();
  context.widgets.record_window("panel.messages.more");
  ImGui::End();
}

}  // namespace

void draw_messages(PanelContext& context) {
  Session& session = context.session;
  const Rectangle& picture = context.layout.picture;
  // Beside the view settings, if they are open, else beside the view cube.
  const float taken = session.interface.view_panel ? 260.0f : 94.0f;
  const float width = std::min(460.0f, picture.width - 16 - taken);
  float y = picture.y + 8;
  for (std::size_t i = 0; i < session.interface.messages.shown().size(); ++i) {
    const Message message = session.interface.messages.shown()[i];
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
      session.interface.messages.close(i);
    context.widgets.record_window("panel.message." + std::to_string(i));
    y += ImGui::GetWindowSize().y + 6;
    ImGui::End();
  }
  const float left = picture.x + (picture.width - taken - width) / 2;
  if (session.interface.messages.waiting() > 0) draw_more(context, left, y, width);
  if (session.interface.messages.list_open) draw_list(context);
}

}  // namespace sectile::viewer
