// What stays of the blocks of both operands: as they are, trimmed, or to be made anew with what is
// glued, if they have few faces.
#pragma once

#include <optional>
#include <vector>

#include "boolean/components/components.h"
#include "storage/kept_loops.h"
#include "storage/shared_slots.h"
#include "storage/trimmed_blocks.h"

namespace sectile {

class KeptBlocks {
 public:
  KeptBlocks(const Workspace& w, Operation operation, const FaceLabels& kept);

  /// The slots of A and then of B: all but the links to what is made anew are true.
  SharedSlots shared;

  /// The slots of an operand whose faces that stay are made anew, ascending.
  const std::vector<std::uint32_t>& made_anew(Operand s) const { return made_anew_[s]; }
  /// Of loaded faces that stay or parts of them, by their ids in the patch: the blocks from which
  /// they are taken are in `shared`.
  std::vector<KeptLoops>& kept_loops(Operand s) { return kept_loops_[s]; }
  /// Is this a half-edge of a block in `shared`, which stays?
  bool is_shared(Operand s, std::uint32_t slot, HalfEdgeId h) const;
  /// Where it is there, or InternalError.
  BorderEdge border_edge(Operand s, std::uint32_t slot, HalfEdgeId h) const;

 private:
  void share(Operand s, bool turned);
  void keep_loops(Operand s, const FarLoops& far, bool turned);

  const Workspace& w_;
  const FaceLabels& kept_;
  PerOperand<std::uint32_t> first_slot_;
  PerOperand<std::optional<TrimmedBlocks>> trimmed_;
  PerOperand<std::vector<std::uint32_t>> made_anew_;
  PerOperand<std::vector<KeptLoops>> kept_loops_;
};

}  // namespace sectile
