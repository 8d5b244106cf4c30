#include <algorithm>
#include <cmath>

#include "app/panels/panels.h"
#include "app/words.h"

namespace sectile::viewer {
namespace {

struct ColourKey {
  const char* text;
  Colour colour;
  enum class Form { area, line, point } form = Form::area;
};

/// What the colours of the picture mean; only those that can be in it.
std::vector<ColourKey> keys_of(const PanelContext& context) {
  const Theme& t = context.theme;
  using Form = ColourKey::Form;
  const Session& session = context.session;
  if (session.mode() == Mode::model) {
    if (!session.shows_operands()) return {};
    return {{"A (first)", t.a}, {"B (the others)", t.b}, {"result", t.result}};
  }
  if (!session.player.story()) return {};
  const Phase phase = session.player.phase();
  std::vector<ColourKey> keys;
  const auto add = [&](std::initializer_list<ColourKey> more) { keys.insert(keys.end(), more); };
  switch (phase) {
    case Phase::reduction:
      add({{"A", t.a},
           {"B", t.b},
           {"vertices in one place", t.coincident, Form::point},
           {"other contacts", t.contact, Form::point},
           {"contact segment", t.contact_segment, Form::line}});
      break;
    case Phase::vertex_face:
    case Phase::vertex_vertex:
      add({{"A", t.a},
           {"B", t.b},
           {"vertices in one place", t.coincident, Form::point},
           {"other contacts", t.contact, Form::point},
           {"this step", t.step, Form::point}});
      break;
    case Phase::null_edges:
    case Phase::joining:
      add({{"A", t.a},
           {"B", t.b},
           {"null edge", t.null_edge, Form::line},
           {"its end above", t.null_edge_above, Form::point},
           {"its end below", t.null_edge_below, Form::point}});
      if (phase == Phase::joining) add({{"cut", t.cut, Form::line}});
      break;
    case Phase::components:
    case Phase::gluing:
      add({{"AinB", t.a_in_b}, {"AoutB", t.a_out_b}, {"BinA", t.b_in_a}, {"BoutA", t.b_out_a}});
      if (session.view.eight_way)
        add({{"AonB+", t.a_on_b_plus},
             {"AonB-", t.a_on_b_minus},
             {"BonA+", t.b_on_a_plus},
             {"BonA-", t.b_on_a_minus}});
      break;
    case Phase::cleanup:
      add({{"result", t.result}});
      break;
  }
  return keys;
}

void draw_key(const ColourKey& key) {
  const float line = ImGui::GetTextLineHeight();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const ImU32 colour = packed(with_alpha(key.colour, 1));
  // On whole pixels: half of one is where versions of ImGui differ.
  const float middle = std::floor(at.y) + std::floor(line / 2);
  switch (key.form) {
    case ColourKey::Form::area:
      draw.AddRectFilled({at.x, middle - 5}, {at.x + 14, middle + 5}, colour, 2);
      break;
    case ColourKey::Form::line:
      draw.AddRectFilled({at.x, middle - 1}, {at.x + 14, middle + 2}, colour);
      break;
    case ColourKey::Form::point:
      draw.AddCircleFilled({at.x + 7, middle}, 5, colour);
      break;
  }
  ImGui::Dummy({16, line});
  ImGui::SameLine();
  ImGui::TextUnformatted(key.text);
}

}  // namespace

void draw_legend(PanelContext& context) {
  const std::vector<ColourKey> keys = keys_of(context);
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
