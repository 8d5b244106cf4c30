#include "app/session.h"

#include <algorithm>
#include <cmath>

#include "scene/transforms.h"

namespace sectile::viewer {
Session::Session(const std::filesystem::path& data_folder, bool dark) : document(data_folder) {
  view.dark = dark;
}

bool Session::change(const std::string& what, const std::function<void(Scene&)>& edit) {
  Scene changed = document.scene();
  try {
    edit(changed);
  } catch (const std::exception& error) {
    document.drop_draft();
    interface.messages.error(what + " did not work: " + error.what());
    return false;
  }
  document.commit(what, std::move(changed));
  return true;
}

void Session::undo() {
  if (document.has_draft()) {
    document.drop_draft();
    if (interface.tool) interface.tool->preview_undone(*this);
    return;
  }
  if (!document.can_undo()) return;
  const std::string what = document.undo_name();
  document.undo();
  interface.messages.tell("Undone: " + what);
}

void Session::redo() {
  if (document.has_draft() || !document.can_redo()) return;
  const std::string what = document.redo_name();
  document.redo();
  interface.messages.tell("Redone: " + what);
}

bool Session::is_selected(NodeId id) const {
  return std::find(selection().begin(), selection().end(), id) != selection().end();
}

bool Session::is_selected_with_group(NodeId id) const {
  if (is_selected(id)) return true;
  const Node* node = scene().find(id);
  const Node* parent = node ? scene().find(node->parent) : nullptr;
  return parent && std::holds_alternative<Group>(parent->what) &&
         is_selected_with_group(parent->id);
}

void Session::select(NodeId id, bool add) {
  if (id == 0) {
    if (!add) document.select({});
    return;
  }
  Selection chosen;
  if (add) chosen = selection();
  if (std::erase(chosen, id) == 0) chosen.push_back(id);
  document.select(std::move(chosen));
}

Selection Session::topmost_selected() const {
  return scene().topmost(selection());
}

bool Session::is_modelling() const {
  return mode_ == Mode::model && !results.repair.is_open();
}

void Session::set_mode(Mode wanted) {
  if (wanted == Mode::steps && story_node() == 0) {
    interface.messages.error(
        "There are no steps yet: select two solids and choose Unite, Intersect or Subtract first, "
        "or "
        "open one of the samples.");
    return;
  }
  if (mode_ == Mode::model && wanted == Mode::steps) camera_of_model_ = view.camera;
  if (mode_ == Mode::steps && wanted == Mode::model) {
    results.player.play(false);
    // Who followed the steps into a corner wants to see the model again.
    if (view.follow_steps) view.camera = camera_of_model_;
  }
  mode_ = wanted;
}

void Session::look_at_selection() {
  const Bounds bounds = bounds_shown(true);
  if (bounds.is_empty()) return look_at_all();
  view.look_at(bounds);
}

void Session::look_at_all() {
  view.look_at(bounds_shown(false));
}

void Session::show_section(bool on, int axis) {
  view.section = on;
  view.section_axis = axis;
  const Bounds bounds = results.repair.is_open() ? bounds_shown(false) : bounds_of_all();
  if (!on || view.section_oblique || bounds.is_empty()) return;
  const double low = bounds.low[axis], high = bounds.high[axis];
  if (view.section_place <= low || view.section_place >= high)
    view.section_place = 0.5 * (low + high);
}

bool Session::is_isolating() const {
  return std::any_of(isolated_.begin(), isolated_.end(),
                     [&](NodeId id) { return scene().find(id) != nullptr; });
}

bool Session::passes_isolation(NodeId id) const {
  if (!is_isolating()) return true;
  return std::any_of(isolated_.begin(), isolated_.end(), [&](NodeId isolated) {
    return scene().find(isolated) &&
           (scene().is_below(id, isolated) || scene().is_below(isolated, id));
  });
}

void Session::isolate_selected() {
  if (is_isolating()) {
    isolated_.clear();
    return;
  }
  isolated_ = topmost_selected();
  if (!isolated_.empty())
    interface.messages.tell("Only the selection is shown. Press / to show all again.");
}

void Session::begin_tool(std::unique_ptr<PictureTool> wanted) {
  end_tool();
  document.drop_draft();
  interface.tool = std::move(wanted);
  tool_knows_ = document.committed_number();
}

void Session::tell_tool_of_changes() {
  if (!interface.tool || tool_knows_ == document.committed_number()) return;
  tool_knows_ = document.committed_number();
  interface.tool->scene_changed(*this);
}

void Session::end_tool() {
  if (interface.tool) interface.tool->give_up(*this);
  interface.tool.reset();
}

void Session::drop_done_tool() {
  if (interface.tool && interface.tool->is_done()) interface.tool.reset();
}

void Session::after_saving(const std::string& about, std::function<void()> then) {
  if (!document.is_changed()) return then();
  Question question;
  question.title = about;
  question.text = "The scene has changes that are not saved. Save them first?";
  const auto save_first = [this, then] {
    if (!document.path().empty()) {
      if (save(document.path())) then();
      return;
    }
    interface.dialogs.browse(FileBrowser::Purpose::save, "scene.sectile",
                             [this, then](const std::filesystem::path& path) {
                               if (save(path)) then();
                             });
  };
  question.answers = {{"question.save", "Save", save_first},
                      {"question.discard", "Do not save", then},
                      {"question.cancel", "Cancel", [] {}}};
  interface.dialogs.ask(std::move(question));
}

}  // namespace sectile::viewer
