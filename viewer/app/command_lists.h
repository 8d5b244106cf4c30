// The commands, menu by menu.
#pragma once

#include <vector>

#include "app/commands.h"

namespace sectile::viewer {

std::vector<Command> file_commands();
std::vector<Command> edit_commands();
std::vector<Command> add_commands();
std::vector<Command> operation_commands();
std::vector<Command> handle_commands();
std::vector<Command> view_commands();
std::vector<Command> step_commands();
std::vector<Command> help_commands();

}  // namespace sectile::viewer
