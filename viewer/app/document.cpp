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
  if (!recovery_ || has_draft() || !is_changed() || kept_ == revision()) return;
  kept_ = revision();
  recovery_->keep({scene(), {}}, path_.empty() ? "unnamed" : path_.filename().string());
}

}  // namespace sectile::viewer
