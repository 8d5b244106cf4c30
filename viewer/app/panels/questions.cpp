#include <algorithm>

#include "app/icons.h"
#include "app/interface_input.h"
#include "app/panels/panels.h"

namespace sectile::viewer {
namespace {

bool begin_window(const char* name, bool* open, float width) {
  if (!ImGui::IsPopupOpen(name)) ImGui::OpenPopup(name);
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({screen.x / 2, screen.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSize({std::min(width, screen.x - 40), 0});
  return ImGui::BeginPopupModal(name, open,
                                ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                                    ImGuiWindowFlags_NoSavedSettings |
                                    ImGuiWindowFlags_AlwaysAutoResize);
}

bool escape_pressed() {
  return interface_input::was_pressed(Key::escape);
}

void draw_about(PanelContext& context) {
  bool& open = context.session.interface.dialogs.about;
  if (!open) return;
  if (!begin_window("About Sectile", &open, 460)) return;
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(
      "Sectile combines solids exactly: flush faces, shared edges and touching vertices are "
      "decided "
      "without any tolerance. The steps show how, after M. M\u00E4ntyl\u00E4, \"Boolean operations "
      "of "
      "2-manifolds through vertex neighborhood classification\" (1986).");
  ImGui::PopTextWrapPos();
  ImGui::Spacing();
  if (button(context, "about.close", "Close", "", true, 110) || escape_pressed()) open = false;
  if (!open) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
}

}  // namespace

void draw_questions(PanelContext& context) {
  Dialogs& dialogs = context.session.interface.dialogs;
  // One at a time: the file browser that an answer opened comes first.
  if (dialogs.questions.empty() || dialogs.browsing) return;
  const Question question = dialogs.questions.front();
  const std::string window = question.title + "###question";
  if (!begin_window(window.c_str(), nullptr, 460)) return;
  context.widgets.record_window("panel.question");
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(question.text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::Spacing();
  const Question::Answer* chosen = escape_pressed() ? &question.answers.back() : nullptr;
  const float count = static_cast<float>(question.answers.size());
  const float width = (ImGui::GetContentRegionAvail().x - 7 * (count - 1)) / count;
  for (const Question::Answer& answer : question.answers) {
    if (&answer != &question.answers.front()) ImGui::SameLine(0, 7);
    if (button(context, answer.name, answer.text, "", true, width)) chosen = &answer;
  }
  if (chosen) {
    dialogs.questions.erase(dialogs.questions.begin());
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
  if (chosen && chosen->run) chosen->run();
}

void draw_help(PanelContext& context) {
  draw_about(context);
}

}  // namespace sectile::viewer
