// Of a face with very many loops, those that no contact comes near: they are not loaded. The face
// is alone in its block, and loops that stay go from there into the result, as they are: where the
// face is turned around in the result, its slot is.
//
// Whatever lies on both the face and what it may meet is outside of the boxes around these loops,
// so they count in no test there. What has to be found out about such a loop is to which part of
// the face it belongs, once that is divided.
#pragma once

#include <functional>
#include <vector>

#include "boolean/operand.h"
#include "geometry/geometry.h"
#include "storage/solid_data.h"

namespace sectile {

struct FarLoops {
  FaceId face;  ///< loaded without them
  std::uint32_t slot = 0;
  std::vector<LoopId> loops;  ///< of the slot's block, ascending
  std::size_t corners = 0;    ///< of all of them
  /// Per loop of the block: the part of the face to which it belongs; none if it is loaded.
  Table<LoopId, FaceId> part;

  bool has(LoopId l) const { return part[l].valid(); }
  /// All of them.
  void lie_in(FaceId one_part) {
    for (const LoopId l : loops) part[l] = one_part;
  }
};

/// Is there a face with many corners, alone in the slot's block?
bool may_have_far_loops(const Slot& slot);

/// A face in such a slot, and a box around something that it may meet.
struct FaceAndBox {
  FaceId face;
  Box box;
};
/// `faces`: all that are loaded of a solid. `near`: of those of them that may have far loops all
/// that they may meet. In the order of their slots.
std::vector<FarLoops> find_far_loops(const SolidData& solid, const std::vector<FaceId>& faces,
                                     std::vector<FaceAndBox> near);
/// All faces may meet the same: `meets` says whether a box around a loop does.
std::vector<FarLoops> find_far_loops(const SolidData& solid, const std::vector<FaceId>& faces,
                                     const std::function<bool(const Box&)>& meets);

}  // namespace sectile
