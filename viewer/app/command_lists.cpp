#include "app/command_lists.h"

#include <algorithm>

#include "app/icons.h"
#include "app/words.h"

namespace sectile::viewer {
namespace {

constexpr int code(Key key) {
  return static_cast<int>(key);
}

bool has_selection(const Session& s) {
  return !s.selection().empty();
}
bool has_solids(const Session& s) {
  return s.scene().size() > 0;
}

bool can_combine(const Session& s) {
  return s.topmost_selected().size() >= 2 || s.scene().roots().size() == 2;
}

void save_as(Session& s) {
  const std::string name =
      s.document.path().empty() ? "scene.sectile" : s.document.path().filename().string();
  s.dialogs.browse(FileBrowser::Purpose::save, name,
                   [&s](const std::filesystem::path& path) { s.save(path); });
}

void save(Session& s) {
  if (s.document.path().empty()) return save_as(s);
  s.save(s.document.path());
}

void open(Session& s) {
  s.dialogs.browse(FileBrowser::Purpose::open, "",
                   [&s](const std::filesystem::path& path) { s.open(path); });
}

void import(Session& s) {
  s.dialogs.browse(FileBrowser::Purpose::import, "",
                   [&s](const std::filesystem::path& path) { s.import(path); });
}

void export_solid(Session& s) {
  s.dialogs.browse(FileBrowser::Purpose::export_solid, "result.obj",
                   [&s](const std::filesystem::path& path) { s.export_solid(path); });
}

}  // namespace

std::vector<Command> file_commands() {
  return {
      {"file.new",
       "New",
       "Starts an empty scene.",
       icons::file,
       {{'N', true}},
       [](Session& s) { s.after_saving("New scene", [&s] { s.new_scene(); }); },
       {},
       {}},
      {"file.open",
       "Open\u2026",
       "Opens a scene, or adds a mesh to this one.",
       icons::folder_open,
       {{'O', true}},
       open,
       {},
       {}},
      {"file.save", "Save", "Saves the scene.", icons::save, {{'S', true}}, save, {}, {}},
      {"file.save_as",
       "Save as\u2026",
       "Saves the scene under another name.",
       "",
       {{'S', true, true}},
       save_as,
       {},
       {}},
      {"file.import",
       "Import mesh\u2026",
       "Adds the solid of an OBJ, STL, OFF or PLY file.",
       icons::download,
       {{'I', true}},
       import,
       {},
       {}},
      {"file.export",
       "Export result\u2026",
       "Writes the selected solid as OBJ, STL, OFF or PLY.",
       icons::upload,
       {{'E', true}},
       export_solid,
       has_solids,
       {}},
      {"file.quit",
       "Quit",
       "Closes the program.",
       "",
       {{'Q', true}},
       [](Session& s) { s.after_saving("Quit", [&s] { s.wants_to_close = true; }); },
       {},
       {}},
  };
}

std::vector<Command> edit_commands() {
  return {
      {"edit.undo",
       "Undo",
       "Takes back the last change.",
       icons::undo,
       {{'Z', true}},
       [](Session& s) { s.undo(); },
       [](const Session& s) { return s.document.can_undo(); },
       {}},
      {"edit.redo",
       "Redo",
       "Makes the change again that was taken back.",
       icons::redo,
       {{'Z', true, true}, {'Y', true}},
       [](Session& s) { s.redo(); },
       [](const Session& s) { return s.document.can_redo(); },
       {}},
      {"edit.duplicate",
       "Duplicate",
       "Makes a copy beside the selected solids.",
       "",
       {{'D', true}},
       [](Session& s) { s.duplicate_selected(); },
       has_selection,
       {}},
      {"edit.delete",
       "Delete",
       "Takes the selected solids away.",
       "",
       {{code(Key::del)}, {code(Key::backspace)}},
       [](Session& s) { s.remove_selected(); },
       has_selection,
       {}},
      {"edit.group",
       "Group",
       "Puts the selected solids together so that they move as one.",
       "",
       {{'G', true}},
       [](Session& s) { s.group_selected(); },
       has_selection,
       {}},
      {"edit.ungroup",
       "Ungroup",
       "Takes the selected group apart.",
       "",
       {{'G', true, true}},
       [](Session& s) { s.ungroup_selected(); },
       has_selection,
       {}},
      {"edit.rename",
       "Rename",
       "Gives the selected solid another name.",
       "",
       {{code(Key::f2)}},
       [](Session& s) {
         s.renaming = {s.selected(), false, {}};
       },
       has_selection,
       {}},
      {"edit.hide",
       "Hide or show",
       "Hides the selected solids, or shows them again.",
       "",
       {{'H'}},
       [](Session& s) { s.hide_selected(); },
       has_selection,
       {}},
      {"edit.select_all",
       "Select all",
       "Selects all solids.",
       "",
       {{'A', true}},
       [](Session& s) { s.select(s.scene().roots()); },
       has_solids,
       {}},
  };
}

std::vector<Command> add_commands() {
  std::vector<Command> commands = {{"tool.add",
                                    "Add",
                                    "Adds a solid to the scene.",
                                    icons::plus,
                                    {{'A', false, true}},
                                    [](Session& s) { s.adding = true; },
                                    {},
                                    {}}};
  for (const Primitive::Shape shape : all_shapes)
    commands.push_back({"add." + name_of(shape),
                        capitalised(name_of(shape)),
                        "Adds a " + name_of(shape) + ".",
                        "",
                        {},
                        [shape](Session& s) { s.add(shape); },
                        {},
                        {}});
  return commands;
}

std::vector<Command> operation_commands() {
  return {
      {"operation.unite",
       "Unite",
       "Joins the selected solids into one: A \u222A B.",
       "\u222A",
       {{'U'}},
       [](Session& s) { s.combine(Operation::unite); },
       can_combine,
       {}},
      {"operation.intersect",
       "Intersect",
       "Keeps what the selected solids share: A \u2229 B.",
       "\u2229",
       {{'I'}},
       [](Session& s) { s.combine(Operation::intersect); },
       can_combine,
       {}},
      {"operation.subtract",
       "Subtract",
       "Cuts the solids selected later out of the one selected first: A \\ B.",
       "\\",
       {{'D'}, {'-'}},
       [](Session& s) { s.combine(Operation::subtract); },
       can_combine,
       {}},
      {"operation.split",
       "Split",
       "Cuts the selected solid in two along the section plane.",
       icons::scissors,
       {{'P'}},
       [](Session& s) { s.split(); },
       [](const Session& s) { return s.topmost_selected().size() == 1; },
       {}},
  };
}

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

std::vector<Command> step_commands() {
  const auto in_steps = [](const Session& s) {
    return s.mode() == Mode::steps && s.player.story() != nullptr;
  };
  const auto change_phase = [](Session& s, int by) {
    const int phase = static_cast<int>(s.player.phase()) + by;
    if (phase >= 0 && phase <= static_cast<int>(Phase::cleanup))
      s.player.go_to(static_cast<Phase>(phase), 0);
  };
  return {
      {"mode.model",
       "Model",
       "Place solids and combine them.",
       icons::cubes,
       {},
       [](Session& s) { s.set_mode(Mode::model); },
       {},
       [](const Session& s) { return s.mode() == Mode::model; }},
      {"mode.steps",
       "Steps",
       "Watch how the result of an operation comes about.",
       icons::list,
       {},
       [](Session& s) { s.set_mode(Mode::steps); },
       {},
       [](const Session& s) { return s.mode() == Mode::steps; }},
      {"mode.toggle",
       "Model or steps",
       "Changes between placing solids and watching the steps.",
       "",
       {{code(Key::tab)}},
       [](Session& s) { s.set_mode(s.mode() == Mode::model ? Mode::steps : Mode::model); },
       {},
       {}},
      {"steps.previous",
       "Step back",
       "One step back.",
       icons::step_back,
       {{code(Key::left)}},
       [](Session& s) { s.player.previous(); },
       in_steps,
       {}},
      {"steps.next",
       "Step forward",
       "One step forward.",
       icons::step_forward,
       {{code(Key::right)}},
       [](Session& s) { s.player.next(); },
       in_steps,
       {}},
      {"steps.play",
       "Play",
       "Plays the steps, or stops.",
       icons::play,
       {{code(Key::space)}},
       [](Session& s) { s.player.play(!s.player.is_playing()); },
       in_steps,
       [](const Session& s) { return s.player.is_playing(); }},
      {"steps.next_special",
       "Next special case",
       "To the next step at which something touches instead of crossing.",
       icons::star,
       {{'N'}},
       [](Session& s) {
         if (!s.player.next_special(false)) s.messages.tell("No further special case.");
       },
       in_steps,
       {}},
      {"steps.previous_special",
       "Previous special case",
       "Back to the special case before.",
       "",
       {{'N', false, true}},
       [](Session& s) {
         if (!s.player.next_special(true)) s.messages.tell("No special case before this one.");
       },
       in_steps,
       {}},
      {"steps.next_stop",
       "To the next break point",
       "To the next step that a break point names.",
       icons::flag,
       {{'B'}},
       [](Session& s) {
         if (s.player.stops.empty())
           s.messages.tell("Choose break points first: they are in the time line.");
         else if (!s.player.next_stop())
           s.messages.tell("No further step matches a break point.");
       },
       in_steps,
       {}},
      {"steps.next_phase",
       "Next phase",
       "To the first step of the next phase.",
       "",
       {{code(Key::page_down)}},
       [change_phase](Session& s) { change_phase(s, 1); },
       in_steps,
       {}},
      {"steps.previous_phase",
       "Previous phase",
       "To the first step of the phase before.",
       "",
       {{code(Key::page_up)}},
       [change_phase](Session& s) { change_phase(s, -1); },
       in_steps,
       {}},
      {"steps.follow",
       "Camera follows",
       "The camera goes to the place of each step.",
       icons::crosshairs,
       {{'C'}},
       [](Session& s) { s.view.follow_steps = !s.view.follow_steps; },
       in_steps,
       [](const Session& s) { return s.view.follow_steps; }},
  };
}

std::vector<Command> help_commands() {
  return {
      {"help.keys",
       "Keys and gestures",
       "Lists all keys.",
       "",
       {{code(Key::f1)}},
       [](Session& s) { s.dialogs.keys = true; },
       {},
       {}},
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
       [](Session& s) { s.dialogs.about = true; },
       {},
       {}},
  };
}

}  // namespace sectile::viewer
