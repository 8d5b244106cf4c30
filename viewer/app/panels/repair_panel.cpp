// What is wrong with a mesh, how it is to be repaired, and what comes of it.
#include <algorithm>
#include <array>
#include <cmath>

#include "app/icons.h"
#include "app/panels/panels.h"
#include "app/words.h"

namespace sectile::viewer {
namespace {

std::string place_in_words(const glm::dvec3& p) {
  std::string text = "(";
  text += number(p.x) + ", " + number(p.y) + ", " + number(p.z) + ")";
  return text;
}

std::string line_of(const MeshDefect& defect, std::size_t at) {
  return std::to_string(at + 1) + ".  " + defect.text +
         (defect.place ? ", at " + place_in_words(*defect.place) : "");
}

void wrapped(const std::string& text) {
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
}

/// A line that wraps, and can be chosen.
bool selectable(PanelContext& context, const std::string& name, const std::string& text, bool on) {
  const float room = ImGui::GetContentRegionAvail().x;
  const ImVec2 at = ImGui::GetCursorPos();
  const float height = ImGui::CalcTextSize(text.c_str(), nullptr, false, room).y;
  const bool pressed = ImGui::Selectable(("##" + name).c_str(), on, 0, {room, height});
  context.widgets.record_item(name);
  const ImVec2 after = ImGui::GetCursorPos();
  ImGui::SetCursorPos(at);
  wrapped(text);
  ImGui::SetCursorPos(after);
  return pressed;
}

class RepairPanel {
 public:
  explicit RepairPanel(PanelContext& context)
      : context_(context), bench_(context.session.results.repair) {}

  void draw() {
    draw_heading();
    const float below = 3 * ImGui::GetFrameHeightWithSpacing() + 64;
    const float room = std::max(140.0f, ImGui::GetContentRegionAvail().y - below);
    ImGui::BeginChild("defects", {0, std::round(room * 0.55f)}, true);
    draw_defects();
    ImGui::EndChild();
    draw_choice();
    ImGui::BeginChild("outcome", {0, std::round(room * 0.45f)}, true);
    draw_outcome();
    ImGui::EndChild();
    draw_answers();
  }

 private:
  void draw_heading() {
    const BrokenMesh& subject = bench_.subject();
    title(context_, (subject.part.name + " is no solid yet").c_str());
    std::string text = counted(subject.part.mesh->face_sizes.size(), "face") + ", from " +
                       subject.path.filename().string() + ". Click a line to go there.";
    if (bench_.waiting() > 0) {
      text += ' ';
      text += count(bench_.waiting()) + (bench_.waiting() == 1 ? " more waits." : " more wait.");
    }
    note(context_, text);
  }

  void draw_defects() {
    const MeshDefects* defects = bench_.defects();
    if (!defects) return note(context_, "Looking for what is wrong\u2026");
    // Thousands of them have to be drawn as quickly as ten.
    constexpr std::size_t most = 500;
    const std::size_t shown = std::min(most, defects->list.size());
    for (std::size_t i = 0; i < shown; ++i) {
      const MeshDefect& defect = defects->list[i];
      if (i == 0 || defects->list[i - 1].kind != defect.kind) draw_kind(*defects, defect.kind);
      if (selectable(context_, "repair.defect." + std::to_string(i), line_of(defect, i),
                     bench_.lit == static_cast<int>(i))) {
        bench_.lit = static_cast<int>(i);
        bench_.shows_after = false;
        bench_.looks = true;
      }
    }
    if (shown < defects->list.size())
      note(context_,
           "And " + count(defects->list.size() - shown) + " more, all lit in the picture.");
  }

  void draw_kind(const MeshDefects& defects, MeshDefect::Kind kind) {
    const auto many = std::count_if(defects.list.begin(), defects.list.end(),
                                    [&](const auto& d) { return d.kind == kind; });
    title(context_,
          (std::string(heading_of(kind)) + ": " + count(static_cast<std::size_t>(many))).c_str());
  }

  void draw_choice() {
    struct Row {
      Rule rule;
      const char *name, *text, *help;
    };
    constexpr std::array<Row, 3> rules{
        Row{Rule::positive, "repair.rule.positive", "Outsides",
            "What the faces go around with their outsides outwards is material: parts that overlap "
            "are united, parts that are inside out are turned (rule: positive)"},
        Row{Rule::nonzero, "repair.rule.nonzero", "Enclosed",
            "Whatever the faces go around, either way, is material (rule: nonzero)"},
        Row{Rule::odd, "repair.rule.odd", "Alternate",
            "Each face passed goes in or out: where two parts overlap is a hollow (rule: odd)"}};
    RepairChoice choice = bench_.choice();
    const float width = (ImGui::GetContentRegionAvail().x - 8) / 3;
    for (const Row& row : rules) {
      if (row.rule != Rule::positive) ImGui::SameLine(0, 4);
      if (button(context_, row.name, row.text, row.help, true, width, choice.rule == row.rule))
        choice.rule = row.rule;
    }
    checkbox(context_, "repair.close_holes", "Close holes", choice.close_holes,
             "Closes each hole with triangles between its corners");
    ImGui::SameLine(0, 14);
    ImGui::TextUnformatted("Stitch");
    tooltip("Corners on borders that are at most this far apart become one");
    ImGui::SameLine(0, 6);
    number_field(context_, "repair.stitch", choice.stitch, 0.001, -1, Quantity::length, {0, 1e9});
    if (choice != bench_.choice() && bench_.defects()) bench_.choose(choice);
  }

  void draw_outcome() {
    const RepairPreview* preview = bench_.preview();
    if (!preview)
      return note(context_, bench_.is_busy() ? "Trying the repair\u2026" : "Not tried: cancelled.");
    if (!preview->refusal.empty()) {
      ImGui::PushStyleColor(ImGuiCol_Text, ImVec4(0.84f, 0.24f, 0.12f, 1));
      wrapped("It cannot be repaired like this: " + preview->refusal);
      ImGui::PopStyleColor();
      context_.widgets.record_item("repair.refusal");
      return;
    }
    wrapped("A solid of volume " + number(preview->volume) + " with " +
            counted(preview->counts.faces, "face") + " in " + count(preview->counts.shells) +
            (preview->counts.shells == 1 ? " shell." : " shells."));
    context_.widgets.record_item("repair.outcome");
    for (const RepairChange& change : preview->report.changes)
      note(context_, capitalised(in_words(change)) + ".");
    if (preview->moved > 0)
      note(context_, count(preview->moved) + " corners go to the nearest doubles, at most " +
                         number(preview->largest_move) + " away.");
  }

  void draw_answers() {
    const bool ready = bench_.preview() && bench_.preview()->refusal.empty();
    const float half = (ImGui::GetContentRegionAvail().x - 4) / 2;
    if (button(context_, "repair.before", "Before", "The mesh as it is in the file", true, half,
               !bench_.shows_after))
      bench_.shows_after = false;
    ImGui::SameLine(0, 4);
    if (button(context_, "repair.after", "After", "What the repair makes of it", ready, half,
               bench_.shows_after))
      bench_.shows_after = true;
    if (button(context_, "repair.accept", "Repair", "Puts the repaired solid into the scene", ready,
               half))
      return context_.session.take_repaired();
    ImGui::SameLine(0, 4);
    if (button(context_, "repair.cancel", "Cancel", "Leaves the scene as it is", true, half))
      context_.session.give_up_repair();
  }

  PanelContext& context_;
  RepairBench& bench_;
};

}  // namespace

void draw_repair(PanelContext& context) {
  if (!context.session.results.repair.is_open()) return;
  begin_panel(context, "repair", context.layout.repair);
  RepairPanel(context).draw();
  end_panel();
}

}  // namespace sectile::viewer
