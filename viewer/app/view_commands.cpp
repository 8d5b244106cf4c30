// The commands that change only what is seen.
#include <numbers>
#include <utility>

#include "app/command_lists.h"
#include "app/icons.h"

namespace sectile::viewer {
namespace {

using std::numbers::pi;

Command look_from(const char* name, const char* title, char key, double azimuth, double elevation) {
  return {name,
          title,
          std::string("Looks from the ") + title + ".",
          "",
          {{key}},
          [=](Session& s) { s.camera.azimuth = azimuth, s.camera.elevation = elevation; }};
}

Command view_switch(const char* name, const char* title, const char* help,
                    std::vector<Shortcut> keys, bool ViewSettings::*setting) {
  return {name,
          title,
          help,
          "",
          std::move(keys),
          [=](Session& s) { s.view.*setting = !(s.view.*setting); },
          {},
          [=](const Session& s) { return s.view.*setting; }};
}

}  // namespace

std::vector<Command> view_commands() {
  return {
      {"view.frame",
       "Frame",
       "Brings the selected solids, or all, into the picture.",
       icons::expand,
       {{'F'}},
       [](Session& s) { s.look_at_selection(); }},
      {"view.all",
       "Show all",
       "Brings everything into the picture.",
       icons::home,
       {{Key::home}},
       [](Session& s) { s.look_at_all(); }},
      look_from("view.front", "front", '1', -pi / 2, 0),
      look_from("view.right", "right", '3', 0, 0),
      look_from("view.top", "top", '7', -pi / 2, pi / 2),
      {"view.orthographic",
       "Parallel lines stay parallel",
       "Without perspective.",
       "",
       {{'5'}},
       [](Session& s) { s.camera.orthographic = !s.camera.orthographic; },
       {},
       [](const Session& s) { return s.camera.orthographic; }},
      view_switch("view.wireframe", "Wireframe", "Draws all edges and no faces.", {'W'},
                  &ViewSettings::wireframe),
      view_switch("view.hidden_lines", "Hidden lines", "Draws edges behind faces too, faintly.",
                  {'H', false, true}, &ViewSettings::hidden_lines),
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
       [](const Session& s) { return s.view.section; }},
      view_switch("view.grid", "Grid", "Shows the ground grid.", {}, &ViewSettings::grid),
      view_switch("view.axes", "Axes", "Shows the axes.", {}, &ViewSettings::axes),
      view_switch("view.dark", "Dark theme", "Light on dark.", {}, &ViewSettings::dark),
      {"view.panel",
       "View",
       "Section plane, exploded view, labels, colours and theme.",
       icons::sliders,
       {{'V'}},
       [](Session& s) { s.view_panel = !s.view_panel; },
       {},
       [](const Session& s) { return s.view_panel; }},
  };
}

}  // namespace sectile::viewer
