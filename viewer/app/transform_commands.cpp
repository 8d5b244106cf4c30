// The commands that move, turn and scale, and choose how solids are dragged.
#include <memory>

#include "app/command_lists.h"
#include "app/icons.h"
#include "app/modal_transform.h"

namespace sectile::viewer {
namespace {

Command follow_the_mouse(const char* name, const char* title, const char* help, char key,
                         HandleMode mode) {
  return {name,
          title,
          help,
          "",
          {{key}},
          [mode](Session& s) {
            s.begin_tool(std::make_unique<ModalTransform>(s, mode, s.interface.pointer));
          },
          [](const Session& s) { return s.mode() == Mode::model && s.selected() != 0; }};
}

}  // namespace

std::vector<Command> transform_commands() {
  const auto handle = [](HandleMode mode) {
    return std::pair{[mode](ViewState& v) { v.handles = mode; },
                     [mode](const ViewState& v) { return v.handles == mode; }};
  };
  const auto [move, is_move] = handle(HandleMode::move);
  const auto [rotate, is_rotate] = handle(HandleMode::rotate);
  const auto [scale, is_scale] = handle(HandleMode::scale);
  const auto handles_item = [](const char* name, const char* title, const char* help,
                               const char* icon, auto run, auto is_on) {
    return Command{name, title, help, icon, {}, run, {}, is_on}.hidden();
  };
  return {
      follow_the_mouse(
          "transform.move", "Move with the mouse",
          "The selected solids follow the mouse at once. X, Y, Z keep them on an axis, "
          "numbers can be typed; click takes, Esc gives back.",
          'G', HandleMode::move),
      follow_the_mouse("transform.rotate", "Rotate with the mouse",
                       "The selected solids turn with the mouse at once. X, Y, Z choose the axis, "
                       "degrees can be typed; click takes, Esc gives back.",
                       'R', HandleMode::rotate),
      follow_the_mouse("transform.scale", "Scale with the mouse",
                       "The selected solids grow and shrink with the mouse at once. X, Y, Z choose "
                       "the axis, factors can be typed; click takes, Esc gives back.",
                       'S', HandleMode::scale),
      handles_item(
          "handle.move", "Move",
          "Shows handles that move the selected solid.\nG moves it with the mouse at once.",
          icons::move, move, is_move),
      handles_item(
          "handle.rotate", "Rotate",
          "Shows handles that turn the selected solid.\nR turns it with the mouse at once.",
          icons::rotate, rotate, is_rotate),
      handles_item("handle.scale", "Scale",
                   "Shows handles that stretch the selected solid.\nS scales it with the mouse at "
                   "once.",
                   icons::resize, scale, is_scale),
      Command{"handle.local",
              "Local",
              "Handles along the solid's own axes instead of the world's.",
              icons::cube,
              {{'L'}},
              [](ViewState& v) { v.local_axes = !v.local_axes; },
              {},
              [](const ViewState& v) { return v.local_axes; }}
          .after_line(),
      {"handle.snap",
       "Snap",
       "Dragged solids snap to the grid and to vertices, edges and faces of others. Hold Ctrl for "
       "the opposite.",
       icons::magnet,
       {{'M'}},
       [](ViewState& v) { v.snapping = !v.snapping; },
       {},
       [](const ViewState& v) { return v.snapping; }},
  };
}

}  // namespace sectile::viewer
