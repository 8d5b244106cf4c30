// The dialog for pictures and films.
#include <algorithm>
#include <array>

#include "app/interface_input.h"
#include "app/panels/panels.h"
#include "app/recording.h"

namespace sectile::viewer {
namespace {

constexpr float label_width = 150;

void count_row(PanelContext& context, const char* text, const char* name, std::uint32_t& value,
               int low, int high) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(text);
  ImGui::SameLine(label_width);
  count_field(context, name, value, low, high, -1);
}

void draw_kind(PanelContext& context, RecordingPlan& plan) {
  using Kind = RecordingPlan::Kind;
  struct Choice {
    Kind kind;
    const char* name;
    const char* text;
    const char* help;
  };
  constexpr std::array<Choice, 3> choices{
      Choice{Kind::picture, "record.picture", "Picture", "What is seen now, without the interface"},
      Choice{Kind::turntable, "record.turntable", "Turntable", "Once around, as a film"},
      Choice{Kind::steps, "record.steps", "Steps", "The steps of the operation, one frame each"}};
  const float width = (ImGui::GetContentRegionAvail().x - 8) / 3;
  for (const Choice& choice : choices) {
    if (choice.kind != Kind::picture) ImGui::SameLine(0, 4);
    if (button(context, choice.name, choice.text, choice.help, true, width,
               plan.kind == choice.kind)) {
      plan.kind = choice.kind;
      plan.seconds_per_frame = choice.kind == Kind::steps ? 0.8 : 0.08;
    }
  }
}

void draw_size(PanelContext& context, RecordingPlan& plan) {
  count_row(context, "Width", "record.width", plan.width, 16, 16384);
  count_row(context, "Height", "record.height", plan.height, 16, 16384);
  const auto preset = [&](const char* name, const char* text, std::uint32_t w, std::uint32_t h) {
    if (button(context, name, text)) plan.width = w, plan.height = h;
  };
  preset("record.window", "As seen",
         static_cast<std::uint32_t>(std::max(16.0, context.session.view.picture_size.x)),
         static_cast<std::uint32_t>(std::max(16.0, context.session.view.picture_size.y)));
  ImGui::SameLine(0, 4);
  preset("record.hd", "1920 \u00D7 1080", 1920, 1080);
  ImGui::SameLine(0, 4);
  preset("record.4k", "3840 \u00D7 2160", 3840, 2160);
}

void draw_film(PanelContext& context, RecordingPlan& plan) {
  if (plan.kind == RecordingPlan::Kind::turntable)
    count_row(context, "Frames", "record.frames", plan.frames, 2, 720);
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("Seconds for each");
  ImGui::SameLine(label_width);
  number_field(context, "record.seconds", plan.seconds_per_frame, 0.01, -1, Quantity::plain,
               {0.02, 60});
  note(context,
       "A name that ends in .gif makes one animated file; .png makes a numbered file for each "
       "frame.");
}

}  // namespace

void draw_recording(PanelContext& context) {
  Session& session = context.session;
  Dialogs& dialogs = session.interface.dialogs;
  if (!dialogs.recording || dialogs.browsing) return;
  constexpr const char* name = "Picture or film###recording";
  if (!ImGui::IsPopupOpen(name)) ImGui::OpenPopup(name);
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({screen.x / 2, screen.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSize({std::min(430.0f, screen.x - 40), 0});
  if (!ImGui::BeginPopupModal(name, &dialogs.recording,
                              ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                                  ImGuiWindowFlags_NoSavedSettings |
                                  ImGuiWindowFlags_AlwaysAutoResize))
    return;
  context.widgets.record_window("panel.recording");
  RecordingPlan& plan = session.interface.recording_plan;
  draw_kind(context, plan);
  ImGui::Separator();
  draw_size(context, plan);
  if (plan.is_film()) draw_film(context, plan);
  const std::string problem = problem_of(plan, session.results);
  if (!problem.empty()) note(context, problem);
  ImGui::Spacing();
  const bool escaped = interface_input::was_pressed(Key::escape);
  bool close = button(context, "record.cancel", "Cancel", "", true, 110) || escaped;
  ImGui::SameLine(0, 6);
  if (button(context, "record.choose", "Choose a file\u2026", "", problem.empty(), 150)) {
    session.choose_recording_file();
    close = true;
  }
  if (close) {
    dialogs.recording = false;
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
}

}  // namespace sectile::viewer
