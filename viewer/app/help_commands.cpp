// The commands that explain the program.
#include "app/command_lists.h"

namespace sectile::viewer {

std::vector<Command> help_commands() {
  return {
      {"help.keys",
       "Keys and gestures",
       "Lists all keys.",
       "",
       {{Key::f1}},
       [](Session& s) { s.dialogs.keys = true; }},
      {"help.hints",
       "Hint strip",
       "Shows or hides the hints below the picture.",
       "",
       {},
       [](Session& s) { s.view.hints = !s.view.hints; },
       {},
       [](const Session& s) { return s.view.hints; }},
      {"help.about",
       "About",
       "Says what this program is.",
       "",
       {},
       [](Session& s) { s.dialogs.about = true; }},
  };
}

}  // namespace sectile::viewer
