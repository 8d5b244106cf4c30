// Computes the solids and surfaces of one scene after another, in the calling thread.
#pragma once

#include <atomic>
#include <functional>
#include <map>
#include <span>
#include <vector>

#include "evaluation/evaluator.h"
#include "evaluation/value_table.h"

namespace sectile::viewer {

class SceneComputation {
 public:
  /// Throws Cancelled when `cancel` is set, soon; what is made by then is kept for the next time.
  Evaluation run(const Scene& scene, const std::atomic<bool>* cancel,
                 const std::function<void(double)>& progress);

 private:
  ValuePointer inside(const Node& node);  // in the node's own coordinates
  ValuePointer make_inside(const Node& node);
  ValuePointer operation(const Node& node, Operation operation);
  ValuePointer fold(std::vector<ValuePointer> operands, Operation operation);
  ValuePointer combined(const ValuePointer& a, const ValuePointer& b, Operation operation);
  ValuePointer repeated(const Node& node, const Pattern& pattern);
  ValuePointer united(std::span<const ValuePointer> parts);
  ValuePointer cut(const Node& node, const SplitNode& split);
  ValuePointer placed(const ValuePointer& value, const Transform& by);
  ValuePointer placed(const ValuePointer& value, const Placement& by);
  ValuePointer in_world(const Node& node);
  std::vector<ValuePointer> placed_children(const Node& node);
  ValuePointer failed(const ValueKey& key, std::string error);
  template <class Make>
  ValuePointer known_or_made(const ValueKey& key, Make&& make);
  BooleanOptions options();
  void tell(double part_of_current);

  void enter(NodeId id, const Transform& parent_world, bool is_needed, bool is_shown,
             Evaluation& made);
  void fill(const Node& node, bool is_shown, Evaluation::Entry& entry);
  void make_surfaces();

  ValueTable values_;
  const Scene* scene_ = nullptr;
  const std::atomic<bool>* cancel_ = nullptr;
  const std::function<void(double)>* progress_ = nullptr;
  std::map<NodeId, ValuePointer> insides_;  // of the current scene
  std::vector<ValuePointer> to_draw_;
  std::size_t steps_ = 1, steps_done_ = 0;  // nodes with children, and the surfaces
  std::size_t parts_ = 1, part_ = 0;        // of the current step
};

}  // namespace sectile::viewer
