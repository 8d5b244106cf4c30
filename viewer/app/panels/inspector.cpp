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

ImVec4 colour_of(Verdict::Tone tone, const Theme& theme) {
  switch (tone) {
    case Verdict::Tone::plain:
      return ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled);
    case Verdict::Tone::special:
      return {0.80f, 0.47f, 0.0f, 1};
    case Verdict::Tone::cut:
      return vector(theme.step);
    case Verdict::Tone::kept:
      return vector(theme.cut);
    case Verdict::Tone::dropped:
      break;
  }
  return vector(theme.contact_segment);
}

/// The first thing that is read: three words on a bar of their colour.
void draw_verdict(PanelContext& context, const Verdict& verdict) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::PushFont(context.fonts.title);
  const float height = ImGui::GetTextLineHeight();
  const ImVec4 colour = colour_of(verdict.tone, context.theme);
  ImGui::GetWindowDrawList()->AddRectFilled(at, {at.x + 6, at.y + height},
                                            ImGui::ColorConvertFloat4ToU32(colour), 2);
  ImGui::Dummy({6, height});
  ImGui::SameLine();
  ImGui::TextColored(colour, "%s", verdict.words.c_str());
  ImGui::PopFont();
  context.widgets.record_item("inspector.verdict");
}

float longest_word(const std::string& text) {
  float width = 0;
  std::istringstream words(text);
  for (std::string word; words >> word;) width = std::max(width, text_width(word));
  return width;
}

/// As wide as their texts where there is room for all; else narrower, but no word is broken.
std::vector<float> column_widths(const Row& columns, const std::vector<Row>& rows, float room) {
  std::vector<float> whole, least;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    whole.push_back(text_width(columns[i]));
    least.push_back(longest_word(columns[i]));
    for (const Row& row : rows) {
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

/// How a table is drawn: the paper's tables have lit rows, the step's own is pointed at.
struct TableLook {
  const char* id = "";
  std::string prefix;  ///< of the names of its columns and its last row; empty: none are recorded
  std::vector<std::size_t> lit_rows, lit_columns;
};

/// The whole row faintly, and strongly the columns that decide.
void light_row(const Theme& theme, const std::vector<std::size_t>& columns) {
  const Colour& accent = theme.handle_active;
  ImGui::TableSetBgColor(ImGuiTableBgTarget_RowBg0,
                         packed(with_alpha(accent, columns.empty() ? 0.65f : 0.22f)));
  for (const std::size_t column : columns)
    ImGui::TableSetBgColor(ImGuiTableBgTarget_CellBg, packed(with_alpha(accent, 0.75f)),
                           static_cast<int>(column));
}

/// Gives the row under the mouse, or -1.
int draw_table(PanelContext& context, const Row& columns, const std::vector<Row>& rows,
               const TableLook& look) {
  if (columns.empty() || rows.empty()) return -1;
  int hovered = -1;
  ImGui::PushFont(context.fonts.small);
  const float room = ImGui::GetContentRegionAvail().x;
  const std::vector<float> widths = column_widths(columns, rows, room);
  float height = row_height(columns, widths), width = 1;
  for (const Row& row : rows) height += row_height(row, widths);
  for (const float column : widths) width += column + 2 * ImGui::GetStyle().CellPadding.x + 1;
  if (width > room) height += ImGui::GetStyle().ScrollbarSize;
  const ImGuiTableFlags flags = ImGuiTableFlags_Borders | ImGuiTableFlags_RowBg |
                                ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_ScrollX |
                                ImGuiTableFlags_NoSavedSettings;
  if (ImGui::BeginTable(look.id, static_cast<int>(widths.size()), flags, {0, height})) {
    for (std::size_t i = 0; i < widths.size(); ++i)
      ImGui::TableSetupColumn(columns[i].c_str(), ImGuiTableColumnFlags_WidthFixed, widths[i]);
    draw_row(columns, widths, [&](std::size_t i) {
      if (!look.prefix.empty()) context.widgets.record_item(look.prefix + "column:" + columns[i]);
    });
    ImGui::TableSetBgColor(ImGuiTableBgTarget_RowBg0, ImGui::GetColorU32(ImGuiCol_TableHeaderBg));
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    float top = ImGui::GetItemRectMin().y + row_height(columns, widths);
    for (std::size_t r = 0; r < rows.size(); ++r) {
      draw_row(rows[r], widths, [&](std::size_t i) {
        if (r + 1 == rows.size() && !look.prefix.empty())
          context.widgets.record_item(look.prefix + "last:" + columns[i]);
        if (i == 0) top = ImGui::GetItemRectMin().y - ImGui::GetStyle().CellPadding.y;
      });
      if (std::count(look.lit_rows.begin(), look.lit_rows.end(), r) > 0)
        light_row(context.theme, look.lit_columns);
      if (ImGui::IsWindowHovered() && mouse.y >= top && mouse.y < top + row_height(rows[r], widths))
        hovered = static_cast<int>(r);
    }
    ImGui::EndTable();
    if (!look.prefix.empty()) context.widgets.record_surface(look.id);
  }
  ImGui::PopFont();
  return hovered;
}

void draw_paper_tables(PanelContext& context, const Step& step) {
  for (std::size_t i = 0; i < step.paper.size(); ++i) {
    const PaperTable& table = step.paper[i];
    note(context, table.title);
    const std::string id = "paper." + std::to_string(i);
    draw_table(context, table.columns, table.rows,
               {id.c_str(), "", table.lit_rows, table.lit_columns});
    ImGui::Spacing();
  }
}

void draw_bullets(const Step& step) {
  for (const std::string& bullet : step.bullets) {
    ImGui::Bullet();
    ImGui::SameLine(0, 9);
    wrapped(bullet);
  }
}

/// Of ((s0 op s1) op s2) …: which pair is told, and the others.
void draw_pairs(PanelContext& context) {
  Session& session = context.session;
  const Node* node = session.scene().find(session.story_node());
  const std::size_t told = session.told_operand();
  if (!node || node->children.size() < 3) return;
  const auto name_of_pair = [&](std::size_t i) {
    const auto name = [&](std::size_t k) { return session.scene().find(node->children[k])->name; };
    return "A: " + (i == 1 ? name(0) : name(0) + " … " + name(i - 1)) + "   B: " + name(i);
  };
  ImGui::SetNextItemWidth(-1);
  if (ImGui::BeginCombo("##pair", name_of_pair(told).c_str())) {
    for (std::size_t i = 1; i < node->children.size(); ++i)
      if (ImGui::Selectable((name_of_pair(i) + "##" + std::to_string(i)).c_str(), i == told))
        session.tell_operand(i);
    ImGui::EndCombo();
  }
  context.widgets.record_item("inspector.pair");
  tooltip("An operation with several operands is a chain: these are the steps of one link.");
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
  if (session.results.player.is_busy())
    wrapped("The story of this operation is being told\u2026");
  else if (!session.results.player.error().empty())
    wrapped(session.results.player.error());
  else if (session.is_busy())
    wrapped("The operands are being computed\u2026");
  else if (session.results.player.story())
    wrapped("Nothing happened in this phase (" + title_of(session.results.player.phase()) +
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
  draw_verdict(context, step.verdict);
  ImGui::PushFont(context.fonts.bold);
  wrapped(step.title);
  ImGui::PopFont();
  context.widgets.record_item("inspector.title");
  ImGui::Spacing();
}

}  // namespace

void draw_inspector(PanelContext& context) {
  const Step* step = context.session.results.player.current();
  // Of a step, the words alone scroll.
  begin_panel(context, "inspector", context.layout.inspector,
              step ? ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse : 0);
  context.session.interface.lit_row = -1;
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
  draw_pairs(context);
  draw_heading(context, *step);
  context.session.interface.lit_row =
      draw_table(context, step->columns, step->table, {"inspector.table", "inspector.", {}, {}});
  ImGui::Spacing();
  draw_bullets(*step);
  // The paper's tables may be scrolled to.
  needed = ImGui::GetCursorPosY() + ImGui::GetStyle().ItemSpacing.y;
  ImGui::Spacing();
  draw_paper_tables(context, *step);
  if (ImGui::TreeNodeEx("In full", ImGuiTreeNodeFlags_SpanAvailWidth)) {
    wrapped(step->words);
    ImGui::TreePop();
  }
  ImGui::EndChild();
  if (has_sphere) draw_sphere_splitter(context, room.x, sphere);
  if (sphere > 0) draw_sphere(context, *step, room.x, sphere);
  end_panel();
}

}  // namespace sectile::viewer
