// What is computed from the document: its solids, the story of the steps, the repair of a mesh.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "app/document.h"
#include "app/repair_bench.h"
#include "app/story_player.h"
#include "evaluation/evaluator.h"

namespace sectile::viewer {

struct SolidNumbers {
  Solid of;
  double volume = 0, area = 0;
  SolidCounts counts;
};

class Results {
 public:
  /// Asks for the solids of the document, if it has changed. True if it has.
  bool ask(const Document& document);
  /// Takes what was computed in the meantime. True if there is something new. `wait`: until all is.
  bool take(bool wait);
  /// What could not be computed, and was not told before: sentences.
  std::vector<std::string> new_errors(const Scene& scene);
  void forget_errors() { told_errors_.clear(); }

  const Evaluation* evaluation() const { return evaluation_.get(); }
  /// Null: not computed, or an error, or a group that no operation uses.
  const Solid* solid(NodeId id) const;
  /// The same in the node's own coordinates; null also if it is empty.
  const Solid* inside(NodeId id) const;
  std::string error_of(NodeId id) const;  ///< why there is none, in plain words; or empty
  /// Whose union the solid of a node is: itself, or the members of a group. Empty if there is none.
  std::vector<Solid> members_of(const Scene& scene, NodeId id) const;
  /// The solids that an operation is made of; empty if one is missing.
  std::vector<Solid> operands_of(const Scene& scene, const Node& node) const;
  /// Volume, area and counts, computed once for each solid.
  const SolidNumbers& numbers(NodeId id, const Solid& solid);
  Bounds bounds_of(const Scene& scene, NodeId id) const;
  Bounds bounds_of_all(const Scene& scene) const;

  bool is_computing() const { return evaluator_.is_busy(); }
  bool is_current() const;  ///< are they of what was asked for last?
  bool knows(const Document& document) const { return document.revision() == seen_revision_; }
  double progress() const { return evaluator_.is_busy() ? evaluator_.progress() : 0; }
  void cancel();

  StoryPlayer player;
  RepairBench repair;  ///< of files that are no solids

 private:
  Evaluator evaluator_;
  std::shared_ptr<const Evaluation> evaluation_;
  std::uint64_t seen_revision_ = 0, newest_request_ = 0;
  std::map<NodeId, std::string> told_errors_;
  std::map<NodeId, SolidNumbers> numbers_;
};

}  // namespace sectile::viewer
