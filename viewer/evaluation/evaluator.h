// Computes the solids of a scene away from the user interface's thread; the newest request wins.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "picture/picture.h"
#include "scene/scene.h"

namespace sectile::viewer {

/// The solid of each node in its world place, or why there is none.
struct Evaluation {
  struct Entry {
    Solid solid;              ///< in the world
    Solid inside;             ///< the same in the node's own coordinates
    std::string error;        ///< in words; then there is neither solid nor surface
    bool is_computed = true;  ///< false for groups that no operation uses: they have no solid yet
    /// The boundary to draw and to pick, in the node's own coordinates, so that it stays the same
    /// object while the node is only moved. Null for what is empty, hidden or a group.
    std::shared_ptr<const SurfaceMesh> surface;
    glm::dmat4 model{1};  ///< from the node's own coordinates to the world's
    Bounds bounds;        ///< of the surface in the world
  };
  std::map<NodeId, Entry> nodes;
  std::uint64_t request = 0;  ///< the number that request() gave
  double seconds = 0;
  const Entry* find(NodeId id) const;
};

/// What the nodes and all that is below them takes up in the world; empty if nothing is drawn.
Bounds bounds_of(const Evaluation& evaluation, const Scene& scene, const std::vector<NodeId>& ids);

class Evaluator {
 public:
  /// Every computation starts with `before_work`, on the evaluator's thread: the place to save what
  /// must not be lost.
  explicit Evaluator(std::function<void(const Scene&)> before_work = {});
  ~Evaluator();  ///< cancels what runs
  Evaluator(const Evaluator&) = delete;
  Evaluator& operator=(const Evaluator&) = delete;

  /// Starts to compute `scene`; a computation still under way is cancelled, unless it began only
  /// just now: it may finish within half a second, so that a drag shows results all the time.
  /// What has been computed before is not computed again: a moved operand costs its ancestors only.
  std::uint64_t request(const Scene& scene);
  /// The newest finished evaluation; never blocks. Null before the first.
  std::shared_ptr<const Evaluation> latest();
  bool is_busy() const;     ///< something is computed, or is new and latest() was not called yet
  double progress() const;  ///< 0 … 1 of what runs
  void cancel();
  void wait();  ///< for tests and screenshots

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// The same at once, in the calling thread.
Evaluation evaluate(const Scene& scene);

}  // namespace sectile::viewer
