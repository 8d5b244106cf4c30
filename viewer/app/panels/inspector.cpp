#include <algorithm>

#include "app/icons.h"
#include "app/panels/panels.h"
#include "app/words.h"

namespace sectile::viewer {
namespace {

void wrapped(const std::string& text) {
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
}

// What the columns need without a scroll bar.
float table_width(const Step& step) {
  float width = 0;
  for (std::size_t i = 0; i < step.columns.size(); ++i) {
    float column = text_width(step.columns[i]);
    for (const Row& row : step.table)
      if (i < row.size()) column = std::max(column, text_width(row[i]));
    width += column + 2 * ImGui::GetStyle().CellPadding.x + 1;
  }
  return width + 1;
}

void draw_table(PanelContext& context, const Step& step) {
  const int columns = static_cast<int>(step.columns.size());
  if (columns == 0 || step.table.empty()) return;
  ImGui::PushFont(context.fonts.small);
  const ImGuiTableFlags flags = ImGuiTableFlags_Borders | ImGuiTableFlags_RowBg |
                                ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_ScrollX |
                                ImGuiTableFlags_NoSavedSettings;
  const float line = ImGui::GetTextLineHeight() + 2 * ImGui::GetStyle().CellPadding.y;
  const bool scrolls = table_width(step) > ImGui::GetContentRegionAvail().x;
  const float height = line * static_cast<float>(step.table.size() + 1) + 2 +
                       (scrolls ? ImGui::GetStyle().ScrollbarSize : 0);
  if (ImGui::BeginTable("codes", columns, flags, {0, height})) {
    for (const std::string& column : step.columns) ImGui::TableSetupColumn(column.c_str());
    // An ordinary row: columns become as wide as their names too.
    ImGui::TableNextRow();
    ImGui::TableSetBgColor(ImGuiTableBgTarget_RowBg0, ImGui::GetColorU32(ImGuiCol_TableHeaderBg));
    for (int i = 0; i < columns; ++i) {
      ImGui::TableSetColumnIndex(i);
      ImGui::TextUnformatted(step.columns[static_cast<std::size_t>(i)].c_str());
    }
    for (const Row& row : step.table) {
      ImGui::TableNextRow();
      for (int i = 0; i < columns && i < static_cast<int>(row.size()); ++i) {
        ImGui::TableSetColumnIndex(i);
        ImGui::TextUnformatted(row[static_cast<std::size_t>(i)].c_str());
      }
    }
    ImGui::EndTable();
  }
  ImGui::PopFont();
}

void draw_waiting(PanelContext& context) {
  const Session& session = context.session;
  title(context, "Steps");
  if (session.player.is_busy())
    wrapped("The story of this operation is being told\u2026");
  else if (!session.player.error().empty())
    wrapped(session.player.error());
  else if (session.is_busy())
    wrapped("The operands are being computed\u2026");
  else if (session.player.story())
    wrapped("Nothing happened in this phase (" + title_of(session.player.phase()) +
            "): the operands gave it nothing to do.");
  else
    wrapped(session.why_no_story());
}

}  // namespace

void draw_inspector(PanelContext& context) {
  begin_panel(context, "inspector", context.layout.inspector);
  const Step* step = context.session.player.current();
  if (!step) {
    draw_waiting(context);
    end_panel();
    return;
  }
  const bool has_sphere = !step->sphere.arcs.empty() || !step->sphere.marks.empty();
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const float sphere = has_sphere ? std::min(room.x, room.y * 0.46f) : 0;
  const float gap = has_sphere ? ImGui::GetStyle().ItemSpacing.y : 0;
  ImGui::BeginChild("words", {0, room.y - sphere - gap});
  const std::string kind = title_of(step->phase) + "  \u00B7  " + step->kind;
  ImGui::PushFont(context.fonts.small);
  ImGui::TextDisabled("%s", kind.c_str());
  if (step->special) {
    ImGui::SameLine();
    ImGui::TextColored(ImVec4(0.80f, 0.47f, 0.0f, 1), "%s special case", icons::star);
  }
  ImGui::PopFont();
  ImGui::PushFont(context.fonts.bold);
  wrapped(step->title);
  ImGui::PopFont();
  context.widgets.record_item("inspector.title");
  ImGui::Spacing();
  wrapped(step->words);
  ImGui::Spacing();
  draw_table(context, *step);
  ImGui::EndChild();
  if (has_sphere) draw_sphere(context, step->sphere, room.x, sphere);
  end_panel();
}

}  // namespace sectile::viewer
