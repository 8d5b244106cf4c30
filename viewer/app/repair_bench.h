// Meshes that are no solids: what is wrong with them, and what a repair would make of them, while a
// person decides. One at a time; others wait.
#pragma once

#include <atomic>
#include <deque>
#include <filesystem>
#include <memory>
#include <string>

#include "evaluation/mesh_defects.h"
#include "evaluation/mesh_repair.h"
#include "events/background.h"
#include "picture/theme.h"
#include "scene/mesh_parts.h"

namespace sectile::viewer {

/// A mesh of a file that was refused, and why.
struct BrokenMesh {
  std::filesystem::path path;
  MeshPart part;  ///< what it is to become, with the mesh of the file
  std::shared_ptr<const InvalidSolid> refusal;
  /// Its solid comes behind this one of the scene's, as it was asked for; 0: before all.
  NodeId behind = 0;
};

class RepairBench {
 public:
  RepairBench();
  ~RepairBench();  ///< cancels what runs

  void put(BrokenMesh mesh);
  bool is_open() const { return !meshes_.empty(); }
  const BrokenMesh& subject() const { return meshes_.front(); }
  std::size_t waiting() const { return meshes_.empty() ? 0 : meshes_.size() - 1; }

  /// Null while it is being found.
  const MeshDefects* defects() const { return defects_.get(); }
  const RepairChoice& choice() const { return choice_; }
  void choose(const RepairChoice& choice);
  /// What the choice leads to; null while it is being computed, or if that was cancelled.
  const RepairPreview* preview() const { return preview_.get(); }
  std::shared_ptr<const RepairPreview> shared_preview() const { return preview_; }

  void close();  ///< done with the first mesh
  /// Those that wait to come behind the one node are to come behind the other.
  void come_behind(NodeId one, NodeId other);
  /// Takes what was computed. `wait`: until all of it is.
  void update(bool wait);
  bool is_busy() const;
  std::string activity() const;
  double progress() const { return progress_; }
  void cancel();  ///< what is being computed

  bool shows_after = false;  ///< the picture shows the preview
  int lit = -1;              ///< the line of `defects` that the picture shows
  bool looks = false;        ///< the camera is to go to `lit`, or to all of it

 private:
  /// Of which mesh: the one before may have been finished when it was closed.
  struct Found {
    std::shared_ptr<const PolygonMesh> of;
    std::shared_ptr<const MeshDefects> defects;
  };
  struct Made {
    std::shared_ptr<const PolygonMesh> of;
    std::shared_ptr<const RepairPreview> preview;
  };
  struct Wish {
    BrokenMesh subject;
    RepairChoice choice;
  };
  void begin();

  std::deque<BrokenMesh> meshes_;
  RepairChoice choice_;
  bool chosen_ = false;  // the preview of the choice was asked for
  std::shared_ptr<const MeshDefects> defects_;
  std::shared_ptr<const RepairPreview> preview_;
  std::atomic<double> progress_{0};
  Background<Wish, Found> finder_;
  Background<Wish, Made> maker_;
};

/// The mesh with its defects lit and labelled, or what the repair would make of it.
Picture picture_of(const RepairBench& bench, const Theme& colours);

}  // namespace sectile::viewer
