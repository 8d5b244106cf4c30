// The commands that choose how solids are dragged.
#include "app/command_lists.h"
#include "app/icons.h"

namespace sectile::viewer {

std::vector<Command> handle_commands() {
  const auto handle = [](HandleMode mode) {
    return std::pair{[mode](Session& s) { s.handles = mode; },
                     [mode](const Session& s) { return s.handles == mode; }};
  };
  const auto [move, is_move] = handle(HandleMode::move);
  const auto [rotate, is_rotate] = handle(HandleMode::rotate);
  const auto [scale, is_scale] = handle(HandleMode::scale);
  return {
      {"handle.move",
       "Move",
       "Shows handles that move the selected solid.",
       icons::move,
       {{'G'}},
       move,
       {},
       is_move},
      {"handle.rotate",
       "Rotate",
       "Shows handles that turn the selected solid.",
       icons::rotate,
       {{'R'}},
       rotate,
       {},
       is_rotate},
      {"handle.scale",
       "Scale",
       "Shows handles that stretch the selected solid.",
       icons::resize,
       {{'S'}},
       scale,
       {},
       is_scale},
      {"handle.local",
       "Local",
       "Handles along the solid's own axes instead of the world's.",
       icons::cube,
       {{'L'}},
       [](Session& s) { s.local_axes = !s.local_axes; },
       {},
       [](const Session& s) { return s.local_axes; }},
      {"handle.snap",
       "Snap",
       "Dragged solids snap to the grid and to vertices, edges and faces of others. Hold Ctrl for "
       "the opposite.",
       icons::magnet,
       {{'M'}},
       [](Session& s) { s.snapping = !s.snapping; },
       {},
       [](const Session& s) { return s.snapping; }},
  };
}

}  // namespace sectile::viewer
