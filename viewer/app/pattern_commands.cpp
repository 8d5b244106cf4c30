// The commands that repeat solids: arrays and mirrors.
#include <cmath>
#include <memory>

#include "app/command_lists.h"
#include "app/pattern_tools.h"

namespace sectile::viewer {
namespace {

bool has_selection(const Session& s) {
  return s.mode() == Mode::model && s.selected() != 0;
}

/// A row along x with half as much room between the copies as they are long.
void repeat_in_a_row(Session& session) {
  Bounds bounds;
  for (const NodeId id : session.topmost_selected()) bounds.add(session.bounds_of(id));
  Pattern pattern;
  if (!bounds.is_empty())
    pattern.step = {std::max(0.25, std::ceil(6 * (bounds.high.x - bounds.low.x)) / 4), 0, 0};
  repeat_selected(session, pattern);
}

}  // namespace

std::vector<Command> pattern_commands() {
  return {
      {"repeat.linear",
       "Linear array",
       "Copies of the selected solids in a row; number and distance are under Properties.",
       "",
       {},
       repeat_in_a_row,
       has_selection},
      {"repeat.polar",
       "Polar array",
       "Copies around an axis: click a round edge, a face or an edge that has it.",
       "",
       {},
       begins<AxisTool>(Pattern::Kind::polar),
       has_selection},
      {"repeat.path",
       "Array along a path",
       "Copies along a path: click its corners.",
       "",
       {},
       begins<PathTool>(),
       has_selection},
      Command{"repeat.mirror",
              "Mirror",
              "The mirror image of the selected solids, with them or instead of them: click a face "
              "for its plane.",
              "",
              {{'M', true}},
              begins<AxisTool>(Pattern::Kind::mirror),
              has_selection}
          .after_line(),
  };
}

}  // namespace sectile::viewer
