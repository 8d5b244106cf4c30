// The commands that change the scene.
#include <memory>

#include "app/box_select.h"
#include "app/chamfer_tool.h"
#include "app/command_lists.h"
#include "app/icons.h"
#include "app/modal_transform.h"
#include "app/words.h"
#include "scene/primitive_kind.h"

namespace sectile::viewer {
namespace {

bool has_selection(const Document& d) {
  return !d.selection().empty();
}
bool in_model_with_selection(const Session& s) {
  return s.mode() == Mode::model && s.selected() != 0;
}
bool is_group_selected(const Document& d) {
  const Node* node = d.scene().find(d.selected());
  return node && std::holds_alternative<Group>(node->what);
}
bool has_solids(const Document& d) {
  return d.scene().size() > 0;
}

bool can_combine(const Session& s) {
  return s.topmost_selected().size() >= 2 || s.scene().roots().size() == 2;
}

}  // namespace

std::vector<Command> edit_commands() {
  return {
      {"edit.undo",
       "Undo",
       "Takes back the last change.",
       icons::undo,
       {{'Z', true}},
       &Session::undo,
       [](const Document& d) { return d.can_undo(); }},
      {"edit.redo",
       "Redo",
       "Makes the change again that was taken back.",
       icons::redo,
       {{'Z', true, true}, {'Y', true}},
       &Session::redo,
       [](const Document& d) { return d.can_redo(); }},
      Command{"edit.duplicate",
              "Duplicate",
              "Makes a copy of the selected solids in the same place, and selects it.",
              "",
              {{'D', true}},
              &Session::duplicate_selected,
              has_selection}
          .after_line(),
      {"edit.duplicate_move",
       "Duplicate and move",
       "Makes a copy in the same place that follows the mouse; Esc leaves it there.",
       "",
       {{'D', false, true}},
       [](Session& s) {
         s.duplicate_selected();
         s.begin_tool(std::make_unique<ModalTransform>(s, HandleMode::move, s.interface.pointer));
       },
       in_model_with_selection},
      {"edit.copy",
       "Copy",
       "Puts the selected solids into the clipboard, also for other windows.",
       "",
       {{'C', true}},
       &Session::copy_selected,
       has_selection},
      {"edit.cut",
       "Cut",
       "Puts the selected solids into the clipboard and takes them away.",
       "",
       {{'X', true}},
       &Session::cut_selected,
       has_selection},
      {"edit.paste",
       "Paste",
       "Adds the solids that were copied, here or in another window, where they were.",
       "",
       {{'V', true}},
       &Session::paste},
      {"edit.delete",
       "Delete",
       "Takes the selected solids away.",
       "",
       {{Key::del}, {Key::backspace}},
       &Session::remove_selected,
       has_selection},
      Command{"edit.group",
              "Group",
              "Puts the selected solids together so that they move as one.",
              "",
              {{'G', true}},
              &Session::group_selected,
              has_selection}
          .after_line(),
      {"edit.ungroup",
       "Ungroup",
       "Takes the selected group apart.",
       "",
       {{'G', true, true}},
       &Session::ungroup_selected,
       is_group_selected},
      {"edit.rename",
       "Rename",
       "Gives the selected solid another name.",
       "",
       {{Key::f2}},
       [](Session& s) {
         s.interface.renaming = {s.selected(), false, {}};
       },
       has_selection},
      {"edit.hide",
       "Hide or show",
       "Hides the selected solids, or shows them again.",
       "",
       {{'H'}},
       &Session::hide_selected,
       has_selection},
      Command{"edit.select_all",
              "Select all",
              "Selects all solids.",
              "",
              {{'A', true}},
              [](Session& s) { s.select(s.scene().roots()); },
              has_solids}
          .after_line(),
      {"select.box",
       "Box select",
       "Drag a box over the solids to select. Shift and a drag do the same at any time.",
       "",
       {{'B'}},
       begins<BoxSelect>(),
       [](const Session& s) { return s.mode() == Mode::model && s.scene().size() > 0; }},
  };
}

std::vector<Command> add_commands() {
  std::vector<Command> commands = {{"tool.add",
                                    "Add",
                                    "Adds a solid to the scene.",
                                    icons::plus,
                                    {{'A', false, true}},
                                    [](InterfaceState& i) { i.adding = true; }}};
  commands.front().in_menu = false;
  for (const PrimitiveKind* kind : primitive_kinds()) {
    const std::string name(kind->name);
    commands.push_back({"add." + name,
                        capitalised(name),
                        (name.find_first_of("aeiou") == 0 ? "Adds an " : "Adds a ") + name + ".",
                        "",
                        {},
                        [kind](Session& s) { s.add(*kind); }});
  }
  for (Command& command : profile_commands()) commands.push_back(std::move(command));
  return commands;
}

std::vector<Command> operation_commands() {
  return {
      {"operation.unite",
       "Unite",
       "Joins the selected solids into one: A \u222A B.",
       icons::venn_union,
       {{'U'}},
       [](Session& s) { s.combine(Operation::unite); },
       can_combine},
      {"operation.intersect",
       "Intersect",
       "Keeps what the selected solids share: A \u2229 B.",
       icons::venn_intersection,
       {{'I'}},
       [](Session& s) { s.combine(Operation::intersect); },
       can_combine},
      {"operation.subtract",
       "Subtract",
       "Cuts the solids selected later out of the one selected first: A \\ B.",
       icons::venn_difference,
       {{'D'}, {'-'}},
       [](Session& s) { s.combine(Operation::subtract); },
       can_combine},
      {"operation.split",
       "Split",
       "Cuts the selected solid in two along the section plane.",
       icons::scissors,
       {{'P'}},
       &Session::split,
       [](const Session& s) { return s.topmost_selected().size() == 1; }},
      {"operation.chamfer",
       "Chamfer an edge",
       "Cuts off an edge: click it, and type how wide.",
       "",
       {{'B', true}},
       begins<ChamferTool>(),
       [](const Session& s) { return s.is_modelling() && s.scene().size() > 0; }},
  };
}

}  // namespace sectile::viewer
