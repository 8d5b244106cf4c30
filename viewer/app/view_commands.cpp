// The commands that change only what is seen.
#include <memory>
#include <numbers>
#include <utility>

#include "app/command_lists.h"
#include "app/icons.h"
#include "app/measure_tool.h"
#include "app/section_tool.h"

namespace sectile::viewer {
namespace {

using std::numbers::pi;

Command look_from(const char* name, const char* title, Shortcut key, double azimuth,
                  double elevation) {
  Command made{name,
               title,
               "Turns the view so that this side is seen.",
               "",
               {key},
               [=](ViewState& v) { v.camera.azimuth = azimuth, v.camera.elevation = elevation; }};
  made.submenu = "Look at the";
  return made;
}

Command view_switch(const char* name, const char* title, const char* help,
                    std::vector<Shortcut> keys, bool ViewSettings::*setting) {
  return {name,
          title,
          help,
          "",
          std::move(keys),
          [=](ViewState& v) { v.*setting = !(v.*setting); },
          {},
          [=](const ViewState& v) { return v.*setting; }};
}

}  // namespace

std::vector<Command> view_commands() {
  return {
      {"view.frame",
       "Frame",
       "Brings the selected solids, or all, into the picture.",
       icons::expand,
       {{'F'}},
       &Session::look_at_selection},
      {"view.all",
       "Show all",
       "Brings everything into the picture.",
       icons::home,
       {{Key::home}},
       &Session::look_at_all},
      look_from("view.front", "Front", '1', -pi / 2, 0),
      look_from("view.back", "Back", {'1', true}, pi / 2, 0),
      look_from("view.right", "Right", '3', 0, 0),
      look_from("view.left", "Left", {'3', true}, pi, 0),
      look_from("view.top", "Top", '7', -pi / 2, pi / 2),
      look_from("view.bottom", "Bottom", {'7', true}, -pi / 2, -pi / 2),
      {"view.isolate",
       "Isolate",
       "Shows only what is selected; again: everything.",
       "",
       {{'/'}},
       &Session::isolate_selected,
       [](const Session& s) { return s.is_isolating() || !s.selection().empty(); },
       &Session::is_isolating},
      {"view.orthographic",
       "Parallel lines stay parallel",
       "Without perspective.",
       "",
       {{'5'}},
       [](ViewState& v) { v.camera.orthographic = !v.camera.orthographic; },
       {},
       [](const ViewState& v) { return v.camera.orthographic; }},
      Command{"view.measure",
              "Measure",
              "Click vertices, edges and faces: shows distances, angles and radii.",
              "",
              {{'M', false, true}},
              begins<MeasureTool>(),
              [](const Session& s) { return s.mode() == Mode::model && s.scene().size() > 0; }}
          .after_line(),
      view_switch("view.dimensions", "Box and dimensions",
                  "Draws the box around the selection with its lengths; while dragging always.",
                  {{'B', false, true}}, &ViewSettings::dimensions),
      view_switch("view.wireframe", "Wireframe", "Draws all edges and no faces.", {'W'},
                  &ViewSettings::wireframe)
          .after_line(),
      view_switch("view.hidden_lines", "Hidden lines", "Draws edges behind faces too, faintly.",
                  {{'H', false, true}}, &ViewSettings::hidden_lines),
      view_switch("view.labels", "Labels", "Names vertices in the picture.", {'T'},
                  &ViewSettings::labels),
      view_switch("view.eight_way", "Eight-way colours",
                  "Colours the parts that lie on the other solid too.", {'E'},
                  &ViewSettings::eight_way),
      {"view.section",
       "Section plane",
       "Cuts the picture open along a plane.",
       "",
       {{'X'}},
       [](Session& s) { s.show_section(!s.view.section, s.view.section_axis); },
       {},
       [](const ViewState& v) { return v.section; }},
      {"view.section_tool",
       "Place the section plane",
       "Drag the section plane in the picture, tilt it, put it onto a face.",
       "",
       {{'X', false, true}},
       [](Session& s) {
         if (!s.view.section) {
           s.view.section = true;
           const Bounds bounds = s.bounds_of_all();
           if (!bounds.is_empty()) s.view.set_section({0, -1, 0}, -bounds.centre().y);
         }
         s.begin_tool(std::make_unique<SectionTool>(s.bounds_of_all()));
       },
       [](const Session& s) { return s.mode() == Mode::model && s.scene().size() > 0; }},
      view_switch("view.grid", "Grid", "Shows the ground grid.", {}, &ViewSettings::grid),
      view_switch("view.axes", "Axes", "Shows the axes.", {}, &ViewSettings::axes),
      view_switch("view.cube", "View cube", "Shows the cube that turns the view.", {},
                  &ViewSettings::cube),
      view_switch("view.dark", "Dark theme", "Light on dark.", {}, &ViewSettings::dark),
      Command{"view.panel",
              "View",
              "Section plane, exploded view, labels, colours and theme.",
              icons::sliders,
              {{'V'}},
              [](InterfaceState& i) { i.view_panel = !i.view_panel; },
              {},
              [](const InterfaceState& i) { return i.view_panel; }}
          .after_line(),
  };
}

}  // namespace sectile::viewer
