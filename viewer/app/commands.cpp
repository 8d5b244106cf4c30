#include "app/commands.h"

#include <algorithm>
#include <iterator>
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
    case Key::backspace:
      return "Backspace";
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
    case Key::end:
      return "End";
    case Key::enter:
      return "Enter";
    default:
      if (key >= Key::f1 && key <= Key::f12) {
        std::string name = "F";
        return name += std::to_string(static_cast<int>(key) - static_cast<int>(Key::f1) + 1);
      }
      return std::string(1, static_cast<char>(key));
  }
}

std::string name_of(const Shortcut& shortcut) {
  std::string name = shortcut.control ? "Ctrl+" : "";
  if (shortcut.shift) name += "Shift+";
  return name += key_name(shortcut.key);
}

/// The tour of the paper stands before the last entry.
std::vector<Command> help_menu() {
  std::vector<Command> menu = help_commands(), tour = tour_commands();
  tour.front().begins_group = menu.back().begins_group = true;
  menu.insert(menu.end() - 1, std::make_move_iterator(tour.begin()),
              std::make_move_iterator(tour.end()));
  return menu;
}

/// All menus, from left to right.
struct MenuRow {
  const char* name;
  const char* title;
  std::vector<Command> (*commands)();
};
constexpr MenuRow menu_table[] = {
    {"menu.file", "File", file_commands},
    {"menu.edit", "Edit", edit_commands},
    {"menu.add", "Add", add_commands},
    {"menu.transform", "Transform", transform_commands},
    {"menu.place", "Place", place_commands},
    {"menu.repeat", "Repeat", pattern_commands},
    {"menu.operations", "Operations", operation_commands},
    {"menu.view", "View", view_commands},
    {"menu.steps", "Steps", step_commands},
    {"menu.help", "Help", help_menu},
};

}  // namespace

Command Command::after_line() && {
  begins_group = true;
  return std::move(*this);
}

Command Command::hidden() && {
  in_menu = false;
  return std::move(*this);
}

Commands::Commands() {
  for (const MenuRow& row : menu_table) menus_.push_back({row.name, row.title, row.commands()});
}

const Command& Commands::get(std::string_view name) const {
  for (const CommandMenu& menu : menus_)
    for (const Command& command : menu.commands)
      if (command.name == name) return command;
  throw std::out_of_range("There is no command " + std::string(name));
}

bool Commands::press(Session& session, const Event& key_down) const {
  const auto means = [&](const Shortcut& shortcut) {
    return shortcut.key == key_down.key && shortcut.control == key_down.control &&
           shortcut.shift == key_down.shift && !key_down.alt;
  };
  for (const CommandMenu& menu : menus_)
    for (const Command& command : menu.commands)
      if (std::any_of(command.keys.begin(), command.keys.end(), means) &&
          is_enabled(command, session)) {
        run(session, command);
        return true;
      }
  return false;
}

void Commands::run(Session& session, const Command& command) const {
  try {
    command.run(session);
  } catch (const std::exception& error) {
    session.interface.messages.error(command.title + " did not work: " + error.what());
  }
}

std::string key_name(const Command& command) {
  return command.keys.empty() ? std::string() : name_of(command.keys.front());
}

std::string key_names(const Command& command) {
  std::string names;
  for (const Shortcut& shortcut : command.keys) {
    if (!names.empty()) names += ", ";
    names += name_of(shortcut);
  }
  return names;
}

namespace {

/// While a mesh is being repaired the scene is not seen, and stays as it is.
bool looks_only(const std::string& name) {
  for (const char* other : {"view.measure", "view.section_tool", "view.isolate"})
    if (name == other) return false;
  return name.starts_with("view.") || name.starts_with("help.") || name == "file.quit";
}

}  // namespace

bool is_enabled(const Command& command, const Session& session) {
  if (session.results.repair.is_open() && !looks_only(command.name)) return false;
  return !command.can_run || command.can_run(session);
}

}  // namespace sectile::viewer
