#include "app/icons.h"
#include "app/panels/panels.h"
#include "app/words.h"

namespace sectile::viewer {
namespace {

std::string about_scene(const Session& session) {
  if (session.scene().size() == 0) return "Empty scene";
  const std::size_t roots = session.scene().roots().size();
  const Node& first = session.scene().at(session.scene().roots().front());
  const bool is_group = roots == 1 && std::holds_alternative<Group>(first.what);
  std::string text = is_group ? "1 group" : counted(roots, "solid");
  if (roots == 1)
    if (const Solid* solid = session.results.solid(session.scene().roots().front()))
      text += solid->is_empty() ? ", empty" : ", " + counted(solid->counts().faces, "face");
  if (session.is_isolating()) text += " \u00B7 only some are shown (/ shows all)";
  return text;
}

std::string about_file(const Document& document) {
  const auto& path = document.path();
  std::string text = path.empty() ? "not saved yet" : path.filename().string();
  if (!path.empty() && document.is_changed()) text += " (changed)";
  return document.scene().size() == 0 && path.empty() ? "" : text;
}

void draw_progress(PanelContext& context, const std::string& activity) {
  Session& session = context.session;
  const float top = ImGui::GetCursorPosY();
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(activity.c_str());
  ImGui::SameLine(0, 10);
  const float line = ImGui::GetTextLineHeight();
  ImGui::SetCursorPosY(top + 3);
  ImGui::ProgressBar(static_cast<float>(session.progress()), {130, line - 2}, "");
  context.widgets.record_item("status.progress");
  ImGui::SameLine(0, 10);
  ImGui::SetCursorPosY(top);
  if (button(context, "status.cancel", "Cancel", "Stops this computation")) session.cancel();
}

/// Opens the list of all that was said; at the right, before the file's name.
void draw_message_button(PanelContext& context, const std::string& file) {
  Messages& messages = context.session.interface.messages;
  if (messages.all().empty()) return;
  const std::string text =
      std::string(icons::info) + " " + counted(messages.all().size(), "message");
  ImGui::SameLine(context.layout.status.width - text_width(file) - text_width(text) - 42);
  if (button(context, "status.messages", text, "All that was said, with its time", true, 0,
             messages.list_open))
    messages.list_open = !messages.list_open;
}

}  // namespace

void draw_status_bar(PanelContext& context) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {10, 2});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
  begin_panel(context, "status", context.layout.status,
              ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  ImGui::PopStyleVar(2);
  ImGui::PushFont(context.fonts.small);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {6, 2});
  const std::string activity = context.session.activity();
  if (!activity.empty()) {
    draw_progress(context, activity);
  } else {
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(about_scene(context.session).c_str());
    context.widgets.record_item("status.text");
  }
  const std::string file = about_file(context.session.document);
  draw_message_button(context, file);
  ImGui::SameLine(context.layout.status.width - text_width(file) - 10);
  ImGui::AlignTextToFramePadding();
  ImGui::TextDisabled("%s", file.c_str());
  if (!file.empty()) context.widgets.record_item("status.file");
  ImGui::PopStyleVar();
  ImGui::PopFont();
  end_panel();
}

}  // namespace sectile::viewer
