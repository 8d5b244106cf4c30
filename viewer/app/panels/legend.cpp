#include <algorithm>
#include <cmath>

#include "app/panels/panels.h"
#include "app/words.h"

namespace sectile::viewer {
namespace {

void draw_key(const LegendKey& key) {
  const float line = ImGui::GetTextLineHeight();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const ImU32 colour = packed(with_alpha(key.colour, 1));
  // On whole pixels: half of one is where versions of ImGui differ.
  const float middle = std::floor(at.y) + std::floor(line / 2);
  switch (key.form) {
    case LegendKey::Form::area:
      draw.AddRectFilled({at.x, middle - 5}, {at.x + 14, middle + 5}, colour, 2);
      break;
    case LegendKey::Form::line:
      draw.AddRectFilled({at.x, middle - 1}, {at.x + 14, middle + 2}, colour);
      break;
    case LegendKey::Form::point:
      draw.AddCircleFilled({at.x + 7, middle}, 5, colour);
      draw.AddCircle({at.x + 7, middle}, 5, ImGui::GetColorU32(ImGuiCol_TextDisabled));
      break;
  }
  ImGui::Dummy({16, line});
  ImGui::SameLine();
  ImGui::TextUnformatted(key.text.c_str());
}

}  // namespace

void draw_legend(PanelContext& context) {
  const std::vector<LegendKey>& keys = context.session.view.legend;
  if (keys.empty()) return;
  const Rectangle& picture = context.layout.picture;
  const float bottom = picture.y + picture.height - 8;
  ImGui::SetNextWindowPos({picture.x + 8, bottom}, ImGuiCond_Always, {0, 1});
  ImGui::SetNextWindowBgAlpha(0.82f);
  ImGui::Begin("legend", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                   ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoFocusOnAppearing);
  ImGui::PushFont(context.fonts.small);
  // Eight keys stand in two columns.
  const std::size_t rows = keys.size() > 6 ? (keys.size() + 1) / 2 : keys.size();
  for (std::size_t column = 0; column * rows < keys.size(); ++column) {
    if (column > 0) ImGui::SameLine(0, 14);
    ImGui::BeginGroup();
    for (std::size_t i = column * rows; i < std::min(keys.size(), (column + 1) * rows); ++i)
      draw_key(keys[i]);
    ImGui::EndGroup();
  }
  ImGui::PopFont();
  context.widgets.record_window("legend");
  ImGui::End();
}

}  // namespace sectile::viewer
