// Undo and redo of everything. Steps are whole scenes, which share all nodes that are the same.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace sectile::viewer {

/// The selected nodes; the last one is the main one.
using Selection = std::vector<NodeId>;

class History {
 public:
  History() : History(Scene()) {}
  explicit History(Scene scene, Selection selection = {});

  /// What is to be shown: with a drag under way, its draft.
  const Scene& scene() const { return draft_ ? draft_->scene : steps_[now_].scene; }
  const Selection& selection() const { return draft_ ? draft_->selection : steps_[now_].selection; }
  /// No step; undo and redo bring the selection back that belongs to the scene. Ids that the scene
  /// does not have are left out.
  void select(Selection selection);

  /// One step. A scene that equals the one before makes none, and ends a drag like any other.
  void apply(std::string description, Scene scene, Selection selection);
  void apply(std::string description, Scene scene) {
    apply(std::move(description), std::move(scene), selection());
  }

  /// A drag: any number of updates between begin and commit make one step, cancel makes none.
  void begin(std::string description);
  void update(Scene scene);  ///< throws std::logic_error without begin
  void commit();
  void cancel();
  bool is_dragging() const { return draft_.has_value(); }

  bool can_undo() const { return draft_ || now_ > 0; }
  bool can_redo() const { return !draft_ && now_ + 1 < steps_.size(); }
  std::string undo_description() const;  ///< empty if there is nothing to undo
  std::string redo_description() const;
  void undo();  ///< of a drag under way: cancels it
  void redo();
  /// Descriptions of all steps after the first scene, and how many of them are done.
  std::vector<std::string> descriptions() const;
  std::size_t done() const { return now_; }

  void mark_saved() { saved_ = steps_[now_].number; }
  /// Is what is in the file? Also true when undo went back to what was saved.
  bool is_saved() const { return !draft_ && saved_ == steps_[now_].number; }
  /// Without the draft of a drag under way, which is not decided yet.
  const Scene& committed() const { return steps_[now_].scene; }
  std::uint64_t committed_number() const { return steps_[now_].number; }  ///< of no other step
  bool is_committed_saved() const { return saved_ == steps_[now_].number; }
  /// Changes whenever scene() may have changed.
  std::uint64_t revision() const { return revision_; }

 private:
  struct Step {
    Scene scene;
    Selection selection;
    std::string description;
    std::uint64_t number = 0;
  };
  static Selection existing(const Scene& scene, Selection selection);

  std::vector<Step> steps_;
  std::size_t now_ = 0;
  std::optional<Step> draft_;
  std::uint64_t last_number_ = 0, saved_ = 0, revision_ = 0;
};

}  // namespace sectile::viewer
