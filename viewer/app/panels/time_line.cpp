#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "app/icons.h"
#include "app/panels/panels.h"
#include "app/words.h"

namespace sectile::viewer {
namespace {

constexpr const char* stop_kinds[] = {"special case", "contact",   "segment",
                                      "neighborhood", "null edge", "cut",
                                      "part",         "wedge",     "result"};

/// The phases in the order of the algorithm, each with the number of its steps.
void draw_phases(PanelContext& context, const Story& story) {
  const Phase present = context.session.results.player.phase();
  const float gap = 3;
  const float width = (ImGui::GetContentRegionAvail().x - 7 * gap) / 8;
  for (const Phase phase : all_phases) {
    const auto [first, last] = story.range(phase);
    const bool here = phase == present, over = phase < present;
    if (phase != Phase::reduction) ImGui::SameLine(0, gap);
    if (here) {
      const ImVec4 accent = ImGui::GetStyleColorVec4(ImGuiCol_SliderGrabActive);
      for (const ImGuiCol part : {ImGuiCol_Button, ImGuiCol_ButtonHovered})
        ImGui::PushStyleColor(part, accent);
      ImGui::PushStyleColor(ImGuiCol_Text, ImVec4(1, 1, 1, 1));
    } else if (over) {
      for (int i = 0; i < 2; ++i)
        ImGui::PushStyleColor(
            i == 0 ? ImGuiCol_Button : ImGuiCol_ButtonHovered,
            ImGui::GetStyleColorVec4(i == 0 ? ImGuiCol_Header : ImGuiCol_HeaderActive));
      ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_Text));
    }
    ImGui::PushFont(context.fonts.small);
    const std::string name = "phase." + std::string(name_of(phase));
    std::string text = title_of(phase) + " " + std::to_string(last - first);
    if (text_width(text) > width - 2) text = title_of(phase);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0, 4});
    if (button(context, name, text,
               title_of(phase) + ": " + counted(last - first, "step") + " (phase \"" +
                   std::string(name_of(phase)) + "\")",
               true, width))
      context.session.results.player.go_to(phase, 0);
    ImGui::PopStyleVar();
    ImGui::PopFont();
    if (here || over) ImGui::PopStyleColor(3);
  }
}

/// What was typed stays if no step is named, to be corrected.
void add_stop(Session& session, std::string& typed) {
  StoryPlayer& player = session.results.player;
  if (!player.story() || !player.story()->has_stop(typed)) {
    session.interface.messages.error(
        "No step concerns \"" + typed +
        "\". Type a vertex such as v12, an edge e3, a face f7, or A v12.");
    return;
  }
  if (!std::count(player.stops.begin(), player.stops.end(), typed)) player.stops.push_back(typed);
  typed.clear();
}

/// A vertex of A, one of B, or both: then their pair.
std::string typed_pair(const Session& session) {
  const auto& [a, b] = session.interface.typed_pair;
  if (!a.empty() && !b.empty()) return a + " on " + b;
  return a.empty() ? b.empty() ? "" : "B " + b : "A " + a;
}

void draw_pair_fields(PanelContext& context) {
  Session& session = context.session;
  bool entered = false;
  std::string* const fields[] = {&session.interface.typed_pair.first,
                                 &session.interface.typed_pair.second};
  for (int s = 0; s < 2; ++s) {
    if (s == 1) ImGui::SameLine();
    ImGui::SetNextItemWidth(76);
    const char* hint = s == 0 ? "v of A" : "v of B";
    entered |= ImGui::InputTextWithHint(s == 0 ? "##stop.a" : "##stop.b", hint, fields[s],
                                        ImGuiInputTextFlags_EnterReturnsTrue);
    context.widgets.record_item(s == 0 ? "stop.a" : "stop.b");
  }
  ImGui::SameLine();
  std::string typed = typed_pair(session);
  if ((button(context, "stop.pair", "Stop", "At a vertex of A, one of B, or where the two meet",
              !typed.empty()) ||
       entered) &&
      !typed.empty()) {
    add_stop(session, typed);
    if (typed.empty()) session.interface.typed_pair = {};
  }
}

void draw_break_points(PanelContext& context) {
  StoryPlayer& player = context.session.results.player;
  const std::string text =
      std::string(icons::flag) + "  " +
      (player.stops.empty() ? "Break points"
                            : "Break points: " + std::to_string(player.stops.size()));
  if (button(context, "steps.stops", text, "Where playing stops and B jumps to"))
    ImGui::OpenPopup("stops");
  if (!ImGui::BeginPopup("stops")) return;
  title(context, "Stop at");
  for (const char* kind : stop_kinds) {
    const auto found = std::find(player.stops.begin(), player.stops.end(), kind);
    bool on = found != player.stops.end();
    if (checkbox(context, std::string("stop.") + kind, kind, on)) {
      if (on)
        player.stops.emplace_back(kind);
      else
        player.stops.erase(found);
    }
  }
  ImGui::Separator();
  draw_pair_fields(context);
  ImGui::SetNextItemWidth(130);
  const bool entered = ImGui::InputTextWithHint("##entity", "vertex, e.g. v12",
                                                &context.session.interface.typed_stop,
                                                ImGuiInputTextFlags_EnterReturnsTrue);
  context.widgets.record_item("stop.entity");
  ImGui::SameLine();
  std::string& typed = context.session.interface.typed_stop;
  if ((button(context, "stop.add", "Add", "", !typed.empty()) || entered) && !typed.empty())
    add_stop(context.session, typed);
  for (const std::string& stop : std::vector<std::string>(player.stops)) {
    if (std::count(std::begin(stop_kinds), std::end(stop_kinds), stop)) continue;
    if (icon_button(context, "stop.remove." + stop, icons::cross, "Do not stop at " + stop))
      std::erase(player.stops, stop);
    ImGui::SameLine();
    ImGui::TextUnformatted(stop.c_str());
  }
  ImGui::EndPopup();
}

void transport(PanelContext& context, const char* name, const char* icon) {
  const Command& command = context.commands.get(name);
  const bool on = command.is_on && command.is_on(context.session);
  if (icon_button(context, name, icon, tooltip_of(command), is_enabled(command, context.session),
                  on))
    context.commands.run(context.session, command);
  ImGui::SameLine(0, 3);
}

void draw_controls(PanelContext& context, const Story& story, std::size_t step) {
  Session& session = context.session;
  transport(context, "steps.previous", icons::step_back);
  transport(context, "steps.play",
            session.results.player.is_playing() ? icons::pause : icons::play);
  transport(context, "steps.next", icons::step_forward);
  transport(context, "steps.next_special", icons::star);
  transport(context, "steps.special_only", icons::filter);
  transport(context, "steps.next_stop", icons::flag);
  transport(context, "steps.follow", icons::crosshairs);
  ImGui::SameLine(0, 8);
  const std::size_t last = story.steps().size() - 1;
  int at = static_cast<int>(step) + 1;
  const std::string of_all = " of " + std::to_string(last + 1);
  const std::string format = "step %d" + of_all;
  const float speed = 176, exploded = 172;
  // What stands to the right of the step slider.
  const float rest = speed + exploded + 128 + 3 * 8;
  if (slider(context, "steps.slider", at, 1, static_cast<int>(last) + 1,
             {format.c_str(), "step " + std::to_string(last + 1) + of_all},
             ImGui::GetContentRegionAvail().x - rest))
    session.results.player.go_to(static_cast<std::size_t>(at - 1));
  ImGui::SameLine(0, 8);
  slider(context, "steps.speed", session.results.player.steps_per_second, 0.5, 20,
         {"%.1f steps/s", "20.0 steps/s"}, speed);
  tooltip("How fast the steps play");
  ImGui::SameLine(0, 8);
  slider(context, "view.exploded", session.view.exploded, 0, 1, {"explode %.2f", "explode 0.88"},
         exploded);
  tooltip("Pulls the parts, and the two ends of each null edge, apart");
  ImGui::SameLine(0, 8);
  draw_break_points(context);
}

}  // namespace

void draw_time_line(PanelContext& context) {
  begin_panel(context, "time_line", context.layout.time_line, ImGuiWindowFlags_NoScrollbar);
  const Story* story = context.session.results.player.story();
  if (!story || story->steps().empty()) {
    note(context, "The phases of the operation appear here, in the algorithm's order.");
  } else {
    draw_phases(context, *story);
    ImGui::Spacing();
    // A phase button may have moved on.
    draw_controls(context, *story, context.session.results.player.step());
  }
  end_panel();
}

}  // namespace sectile::viewer
