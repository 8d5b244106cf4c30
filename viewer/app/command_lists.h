// The commands, menu by menu.
#pragma once

#include <memory>
#include <vector>

#include "app/commands.h"

namespace sectile::viewer {

std::vector<Command> file_commands();
std::vector<Command> edit_commands();
std::vector<Command> add_commands();
std::vector<Command> profile_commands();  ///< stand in the Add menu
std::vector<Command> place_commands();
std::vector<Command> pattern_commands();
std::vector<Command> operation_commands();
std::vector<Command> transform_commands();
std::vector<Command> view_commands();
std::vector<Command> step_commands();
std::vector<Command> tour_commands();
std::vector<Command> help_commands();

/// What a command does that takes a tool into the hand.
template <class Tool, class... Arguments>
auto begins(const Arguments&... arguments) {
  return [=](Session& s) { s.begin_tool(std::make_unique<Tool>(arguments...)); };
}

}  // namespace sectile::viewer
