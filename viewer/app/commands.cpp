#include "app/commands.h"

#include <numbers>
#include <stdexcept>

#include "app/command_lists.h"

namespace sectile::viewer {
namespace {

std::string key_name(Key key) {
  switch (key) {
    case Key::space:
      return "Space";
    case Key::escape:
      return "Esc";
    case Key::tab:
      return "Tab";
    case Key::del:
      return "Del";
    case Key::left:
      return "Left";
    case Key::right:
      return "Right";
    case Key::page_up:
      return "Page Up";
    case Key::page_down:
      return "Page Down";
    case Key::home:
      return "Home";
    case Key::f1:
      return "F1";
    case Key::f2:
      return "F2";
    default:
      return std::string(1, static_cast<char>(key));
  }
}

}  // namespace

Commands::Commands() {
  for (auto list : {file_commands, edit_commands, add_commands, operation_commands, handle_commands,
                    view_commands, step_commands, help_commands})
    for (Command& command : list()) commands_.push_back(std::move(command));
}

const Command& Commands::get(std::string_view name) const {
  for (const Command& command : commands_)
    if (command.name == name) return command;
  throw std::out_of_range("There is no command " + std::string(name));
}

bool Commands::press(Session& session, const Event& key_down) const {
  for (const Command& command : commands_)
    for (const Shortcut& shortcut : command.keys)
      if (shortcut.key == key_down.key && shortcut.control == key_down.control &&
          shortcut.shift == key_down.shift && !key_down.alt && is_enabled(command, session)) {
        run(session, command);
        return true;
      }
  return false;
}

void Commands::run(Session& session, const Command& command) const {
  try {
    command.run(session);
  } catch (const std::exception& error) {
    session.messages.error(command.title + " did not work: " + error.what());
  }
}

std::string key_name(const Command& command) {
  if (command.keys.empty()) return {};
  const Shortcut& shortcut = command.keys.front();
  return std::string(shortcut.control ? "Ctrl+" : "") + (shortcut.shift ? "Shift+" : "") +
         key_name(shortcut.key);
}

bool is_enabled(const Command& command, const Session& session) {
  return !command.can_run || command.can_run(session);
}

}  // namespace sectile::viewer
