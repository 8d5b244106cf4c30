// The scene being edited with its history, its file, and the copy kept against crashes.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>

#include "scene/history.h"
#include "scene/recovery.h"

namespace sectile::viewer {

class Document {
 public:
  /// `data_folder`: where the copy against crashes is kept; empty: none is.
  explicit Document(const std::filesystem::path& data_folder);

  const Scene& scene() const { return history_.scene(); }
  std::uint64_t revision() const { return history_.revision() + started_; }
  const Selection& selection() const { return history_.selection(); }
  /// The one selected last; 0: none.
  NodeId selected() const { return selection().empty() ? 0 : selection().back(); }
  void select(Selection selection) { history_.select(std::move(selection)); }

  /// A new state, and one step of undo; nothing if it is the same. A draft is dropped.
  void commit(const std::string& what, Scene scene);
  /// Shows a state that is not decided yet, as while something is dragged.
  void show_draft(const std::string& what, Scene scene);
  void drop_draft();
  void commit_draft();
  bool has_draft() const { return history_.is_dragging(); }

  bool can_undo() const { return history_.can_undo(); }
  bool can_redo() const { return history_.can_redo(); }
  std::string undo_name() const { return history_.undo_description(); }
  std::string redo_name() const { return history_.redo_description(); }
  void undo() { history_.undo(); }
  void redo() { history_.redo(); }

  /// Another document with a history of its own; `path` is empty if it has no file yet.
  void start(Scene scene, std::filesystem::path path);
  void save(const std::filesystem::path& path);  ///< throws FileError
  const std::filesystem::path& path() const { return path_; }
  bool is_changed() const { return !history_.is_saved(); }

  /// Without what is being dragged.
  const Scene& committed() const { return history_.committed(); }
  /// The number of that step, which no other step of this document has.
  std::uint64_t committed_number() const { return history_.committed_number(); }
  /// Keeps a copy of what is decided and not saved; called whenever something may have been.
  void keep_copy();
  /// The same, at once on disk: false if it is not.
  bool keep_copy_now();

 private:
  History history_;
  std::unique_ptr<Recovery> recovery_;
  std::filesystem::path path_;
  std::uint64_t started_ = 0;
  std::pair<std::uint64_t, std::uint64_t> kept_{0, 0};  ///< of which document which step
};

}  // namespace sectile::viewer
