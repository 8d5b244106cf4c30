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
       [](InterfaceState& i) { i.dialogs.keys = true; }},
      {"help.hints",
       "Hint strip",
       "Shows or hides the hints below the picture.",
       "",
       {},
       [](ViewState& v) { v.hints = !v.hints; },
       {},
       [](const ViewState& v) { return v.hints; }},
      {"help.about",
       "About",
       "Says what this program is.",
       "",
       {},
       [](InterfaceState& i) { i.dialogs.about = true; }},
  };
}

}  // namespace sectile::viewer
