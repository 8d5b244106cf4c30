// Computes the solids of a scene away from the user interface's thread; the newest request wins.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>

#include "scene/scene.h"

namespace sectile::viewer {

/// The solid of each node in its world place, or why there is none.
struct Evaluation {
  struct Entry {
    Solid solid;
    std::string error;
  };
  std::map<NodeId, Entry> nodes;
  std::uint64_t request = 0;  ///< the number that request() gave
  double seconds = 0;
};

class Evaluator {
 public:
  Evaluator();
  ~Evaluator();  ///< cancels what runs
  Evaluator(const Evaluator&) = delete;
  Evaluator& operator=(const Evaluator&) = delete;

  /// Starts to compute `scene`; a computation still under way is cancelled. Nodes that did not
  /// change since the last evaluation are not computed again.
  std::uint64_t request(const Scene& scene);
  /// The newest finished evaluation; never blocks. Null before the first.
  std::shared_ptr<const Evaluation> latest() const;
  bool is_busy() const;
  double progress() const;  ///< 0 … 1 of what runs
  void cancel();
  void wait();              ///< for tests and screenshots

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// The same at once, in the calling thread.
Evaluation evaluate(const Scene& scene);

}  // namespace sectile::viewer
