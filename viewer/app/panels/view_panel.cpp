#include <algorithm>

#include "app/panels/panels.h"

namespace sectile::viewer {
namespace {

bool choice(PanelContext& context, const std::string& name, const char* text, bool on,
            float width) {
  return button(context, name, text, {}, true, width, on);
}

void draw_shown(PanelContext& context) {
  ViewSettings& view = context.session.view;
  ImGui::TextDisabled("Of an operation being worked on");
  const float width = (ImGui::GetContentRegionAvail().x - 8) / 3;
  const auto option = [&](const char* name, const char* text, Shown shown) {
    if (choice(context, name, text, view.shown == shown, width)) view.shown = shown;
  };
  option("view.both", "Both", Shown::both);
  ImGui::SameLine(0, 4);
  option("view.result", "Result", Shown::result);
  ImGui::SameLine(0, 4);
  option("view.operands", "A and B", Shown::operands);
}

void draw_section(PanelContext& context) {
  Session& session = context.session;
  ViewSettings& view = session.view;
  bool on = view.section;
  if (checkbox(context, "view.section", "Section plane", on,
               "Cuts the picture open along a plane (X)"))
    session.show_section(on, view.section_axis);
  ImGui::BeginDisabled(!view.section);
  const float width = (ImGui::GetContentRegionAvail().x - 12) / 4;
  for (int axis = 0; axis < 3; ++axis) {
    const std::string letter(1, static_cast<char>('x' + axis));
    const bool is_cut = !view.section_oblique && view.section_axis == axis;
    if (choice(context, "view.section." + letter, letter.c_str(), is_cut, width)) {
      view.section_oblique = false;
      session.show_section(true, axis);
    }
    ImGui::SameLine(0, 4);
  }
  if (choice(context, "view.section.flip", "Flip", view.section_flipped, width))
    view.section_flipped = !view.section_flipped;
  Bounds bounds = session.bounds_of_all();
  if (bounds.is_empty()) bounds.add(glm::dvec3(-1)), bounds.add(glm::dvec3(1));
  const double middle = view.section_oblique ? glm::dot(view.section_normal, bounds.centre())
                                             : bounds.centre()[view.section_axis];
  const double reach =
      view.section_oblique ? bounds.radius() : 0.5 * (bounds.high - bounds.low)[view.section_axis];
  slider(context, "view.section.place", view.section_place, middle - reach - 0.1,
         middle + reach + 0.1, {"at %.3g", "at -0.00888"});
  ImGui::EndDisabled();
  if (button(context, "view.section.tool", "Place it in the picture\u2026",
             "Drag it, tilt it, put it onto a face", true, -1))
    context.commands.run(session, context.commands.get("view.section_tool"));
}

}  // namespace

void draw_view_panel(PanelContext& context) {
  Session& session = context.session;
  if (!session.interface.view_panel) return;
  const Rectangle& picture = context.layout.picture;
  ImGui::SetNextWindowPos({picture.x + picture.width - 8, picture.y + 8}, ImGuiCond_Always, {1, 0});
  ImGui::SetNextWindowSize({244, 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 5);
  ImGui::Begin("view", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize);
  ImGui::PopStyleVar();
  ViewSettings& view = session.view;
  draw_shown(context);
  ImGui::Separator();
  draw_section(context);
  ImGui::Separator();
  ImGui::TextDisabled("Exploded view (steps)");
  slider(context, "view.panel.exploded", view.exploded, 0, 1, {"%.2f", "0.88"});
  ImGui::Separator();
  const float second = ImGui::GetContentRegionAvail().x * 0.52f;
  checkbox(context, "view.labels", "Labels", view.labels, "Names vertices in the picture (T)");
  ImGui::SameLine(second);
  checkbox(context, "view.wireframe", "Wireframe", view.wireframe,
           "Draws all edges and no faces (W)");
  checkbox(context, "view.hidden_lines", "Hidden lines", view.hidden_lines,
           "Draws edges behind faces too, faintly (Shift+H)");
  ImGui::SameLine(second);
  checkbox(context, "view.eight_way", "Eight-way", view.eight_way,
           "In the steps: colours the parts that lie on the other solid too (E)");
  checkbox(context, "view.grid", "Grid", view.grid);
  ImGui::SameLine(second);
  checkbox(context, "view.axes", "Axes", view.axes);
  checkbox(context, "view.dark", "Dark", view.dark);
  checkbox(context, "view.orthographic", "No perspective", session.view.camera.orthographic,
           "Parallel lines stay parallel (5)");
  // The panel covers the picture: say so to whoever looks for overlaps.
  context.widgets.record_window("panel.view");
  ImGui::End();
}

}  // namespace sectile::viewer
