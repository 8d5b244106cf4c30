#include "app/document.h"

namespace sectile::viewer {

Document::Document(const std::filesystem::path& data_folder) {
  if (!data_folder.empty()) recovery_ = std::make_unique<Recovery>(data_folder);
  history_.mark_saved();
}

void Document::commit(const std::string& what, Scene scene) {
  drop_draft();
  history_.apply(what, std::move(scene));
}

void Document::show_draft(const std::string& what, Scene scene) {
  if (!history_.is_dragging()) history_.begin(what);
  history_.update(std::move(scene));
}

void Document::drop_draft() {
  if (history_.is_dragging()) history_.cancel();
}

void Document::commit_draft() {
  if (history_.is_dragging()) history_.commit();
}

void Document::start(Scene scene, std::filesystem::path path) {
  // Revisions never come back, whatever the new history counts from.
  started_ += history_.revision() + 1;
  history_ = History(std::move(scene));
  history_.mark_saved();
  path_ = std::move(path);
  if (recovery_) recovery_->forget();
}

void Document::save(const std::filesystem::path& path) {
  drop_draft();
  write_scene(path, {history_.scene(), {}});
  path_ = path;
  history_.mark_saved();
  if (recovery_) recovery_->forget();
}

void Document::keep_copy() {
  const std::pair state(started_, history_.committed_number());
  if (!recovery_ || state == kept_) return;
  kept_ = state;
  // What undo led back to is in the file: an older copy would bring back what was undone.
  if (history_.is_committed_saved())
    recovery_->forget();
  else
    recovery_->keep({committed(), {}}, path_.empty() ? "unnamed" : path_.filename().string());
}

bool Document::keep_copy_now() {
  keep_copy();
  if (!recovery_) return false;
  recovery_->flush();
  return recovery_->error().empty();
}

}  // namespace sectile::viewer
