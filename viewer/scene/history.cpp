#include "scene/history.h"

#include <stdexcept>

namespace sectile::viewer {

History::History(Scene scene, Selection selection) {
  selection = existing(scene, std::move(selection));
  steps_.push_back({std::move(scene), std::move(selection), {}, 0});
}

Selection History::existing(const Scene& scene, Selection selection) {
  std::erase_if(selection, [&](NodeId id) { return !scene.find(id); });
  return selection;
}

void History::select(Selection selection) {
  selection = existing(scene(), std::move(selection));
  steps_[now_].selection = selection;
  if (draft_) draft_->selection = std::move(selection);
}

void History::apply(std::string description, Scene scene, Selection selection) {
  if (draft_) ++revision_;
  draft_.reset();
  selection = existing(scene, std::move(selection));
  if (scene == steps_[now_].scene) {
    steps_[now_].selection = std::move(selection);
    return;
  }
  steps_.resize(now_ + 1);
  steps_.push_back(
      {std::move(scene), std::move(selection), std::move(description), ++last_number_});
  ++now_;
  ++revision_;
}

void History::begin(std::string description) {
  if (draft_) commit();
  draft_ = steps_[now_];
  draft_->description = std::move(description);
}

void History::update(Scene scene) {
  if (!draft_) throw std::logic_error("History::update without begin");
  draft_->scene = std::move(scene);
  ++revision_;
}

void History::commit() {
  if (!draft_) return;
  Step done = std::move(*draft_);
  draft_.reset();
  apply(std::move(done.description), std::move(done.scene), std::move(done.selection));
}

void History::cancel() {
  if (!draft_) return;
  draft_.reset();
  ++revision_;
}

std::string History::undo_description() const {
  if (draft_) return draft_->description;
  return now_ > 0 ? steps_[now_].description : std::string();
}

std::string History::redo_description() const {
  return can_redo() ? steps_[now_ + 1].description : std::string();
}

void History::undo() {
  if (draft_) return cancel();
  if (now_ == 0) return;
  --now_;
  ++revision_;
}

void History::redo() {
  if (!can_redo()) return;
  ++now_;
  ++revision_;
}

std::vector<std::string> History::descriptions() const {
  std::vector<std::string> made;
  for (std::size_t i = 1; i < steps_.size(); ++i) made.push_back(steps_[i].description);
  return made;
}

}  // namespace sectile::viewer
