#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>

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

float longest_word(const std::string& text) {
  float width = 0;
  std::istringstream words(text);
  for (std::string word; words >> word;) width = std::max(width, text_width(word));
  return width;
}

/// As wide as their texts where there is room for all; else narrower, but no word is broken.
std::vector<float> column_widths(const Step& step, float room) {
  std::vector<float> whole, least;
  for (std::size_t i = 0; i < step.columns.size(); ++i) {
    whole.push_back(text_width(step.columns[i]));
    least.push_back(longest_word(step.columns[i]));
    for (const Row& row : step.table) {
      if (i >= row.size()) continue;
      whole[i] = std::max(whole[i], text_width(row[i]));
      least[i] = std::max(least[i], longest_word(row[i]));
    }
  }
  const float padding = 2 * ImGui::GetStyle().CellPadding.x + 1;
  room -= padding * static_cast<float>(whole.size()) + 1;
  const float all = std::accumulate(whole.begin(), whole.end(), 0.0f);
  const float needed = std::accumulate(least.begin(), least.end(), 0.0f);
  if (all <= room) return whole;
  const float part = all > needed ? std::clamp((room - needed) / (all - needed), 0.0f, 1.0f) : 0;
  for (std::size_t i = 0; i < whole.size(); ++i)
    whole[i] = std::ceil(least[i] + part * (whole[i] - least[i]) - 0.5f);
  return whole;
}

float row_height(const Row& row, const std::vector<float>& widths) {
  float height = ImGui::GetTextLineHeight();
  for (std::size_t i = 0; i < row.size() && i < widths.size(); ++i)
    height = std::max(height, ImGui::CalcTextSize(row[i].c_str(), nullptr, false, widths[i] + 1).y);
  return height + 2 * ImGui::GetStyle().CellPadding.y;
}

template <class Told>
void draw_row(const Row& row, const std::vector<float>& widths, const Told& drawn) {
  ImGui::TableNextRow();
  for (std::size_t i = 0; i < widths.size() && i < row.size(); ++i) {
    ImGui::TableSetColumnIndex(static_cast<int>(i));
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + widths[i] + 1);
    ImGui::TextUnformatted(row[i].c_str());
    ImGui::PopTextWrapPos();
    drawn(i);
  }
}

void draw_table(PanelContext& context, const Step& step) {
  if (step.columns.empty() || step.table.empty()) return;
  ImGui::PushFont(context.fonts.small);
  const float room = ImGui::GetContentRegionAvail().x;
  const std::vector<float> widths = column_widths(step, room);
  const Row names(step.columns.begin(), step.columns.end());
  float height = row_height(names, widths) + 2, width = 1;
  for (const Row& row : step.table) height += row_height(row, widths);
  for (const float column : widths) width += column + 2 * ImGui::GetStyle().CellPadding.x + 1;
  if (width > room) height += ImGui::GetStyle().ScrollbarSize;
  const ImGuiTableFlags flags = ImGuiTableFlags_Borders | ImGuiTableFlags_RowBg |
                                ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_ScrollX |
                                ImGuiTableFlags_NoSavedSettings;
  if (ImGui::BeginTable("codes", static_cast<int>(widths.size()), flags, {0, height})) {
    for (std::size_t i = 0; i < widths.size(); ++i)
      ImGui::TableSetupColumn(step.columns[i].c_str(), ImGuiTableColumnFlags_WidthFixed, widths[i]);
    draw_row(names, widths,
             [&](std::size_t i) { context.widgets.record_item("inspector.column:" + names[i]); });
    ImGui::TableSetBgColor(ImGuiTableBgTarget_RowBg0, ImGui::GetColorU32(ImGuiCol_TableHeaderBg));
    for (const Row& row : step.table)
      draw_row(row, widths, [&](std::size_t i) {
        if (&row == &step.table.back()) context.widgets.record_item("inspector.last:" + names[i]);
      });
    ImGui::EndTable();
  }
  ImGui::PopFont();
}

/// How high the sphere is, below words and table that need `needed` of `room`: as a person dragged
/// it, else what they leave. Where that is too little to see anything, it gives way.
float sphere_height(const ViewSettings& view, float width, float room, float needed) {
  constexpr float least = 110;
  const float line = ImGui::GetTextLineHeight();
  if (view.sphere > 0)
    return std::clamp(static_cast<float>(view.sphere), 0.0f, std::max(0.0f, room - 4 * line));
  const float left = std::min({width, room * 0.46f, room - needed});
  return left >= least ? left : 0;
}

/// The edge above the sphere.
void draw_sphere_splitter(PanelContext& context, float width, float height) {
  constexpr float thickness = 6;
  ImGui::InvisibleButton("splitter.sphere", {width, thickness});
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  const float y = (low.y + high.y) / 2;
  ImGui::GetWindowDrawList()->AddLine({low.x, y}, {high.x, y},
                                      ImGui::GetColorU32(ImGuiCol_Separator));
  if (ImGui::IsItemHovered() || ImGui::IsItemActive())
    ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeNS);
  if (ImGui::IsItemActive())
    context.session.view.sphere = std::max(1.0f, height - ImGui::GetIO().MouseDelta.y);
  if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left))
    context.session.view.sphere = 0;
  context.widgets.record_item("splitter.sphere");
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

void draw_heading(PanelContext& context, const Step& step) {
  const std::string kind = title_of(step.phase) + "  \u00B7  " + step.kind;
  ImGui::PushFont(context.fonts.small);
  ImGui::TextDisabled("%s", kind.c_str());
  if (step.special) {
    ImGui::SameLine();
    ImGui::TextColored(ImVec4(0.80f, 0.47f, 0.0f, 1), "%s special case", icons::star);
  }
  ImGui::PopFont();
  ImGui::PushFont(context.fonts.bold);
  wrapped(step.title);
  ImGui::PopFont();
  context.widgets.record_item("inspector.title");
  ImGui::Spacing();
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
  // What words and table needed in the last frame.
  float& needed = *ImGui::GetStateStorage()->GetFloatRef(ImGui::GetID("needed"));
  const float edge = has_sphere ? 6 + 2 * ImGui::GetStyle().ItemSpacing.y : 0;
  const float sphere =
      has_sphere ? sphere_height(context.session.view, room.x, room.y - edge, needed) : 0;
  ImGui::BeginChild("words", {0, room.y - sphere - edge});
  draw_heading(context, *step);
  draw_table(context, *step);
  ImGui::Spacing();
  wrapped(step->words);
  needed = ImGui::GetCursorPosY() + ImGui::GetStyle().ItemSpacing.y;
  ImGui::EndChild();
  if (has_sphere) draw_sphere_splitter(context, room.x, sphere);
  if (sphere > 0) draw_sphere(context, step->sphere, room.x, sphere);
  end_panel();
}

}  // namespace sectile::viewer
