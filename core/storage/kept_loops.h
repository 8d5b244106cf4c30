// Faces of very many loops: what is made anew of such a face are the loops that changed. The others
// are taken from the block that it had, where it was alone.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "storage/shared_slots.h"

namespace sectile {

/// Inner loops of the face that is alone in the block of a slot, ascending. They belong to a face
/// of a new part from now on. Beyond their edges are shared blocks, or what is new and says so.
struct KeptLoops {
  FaceId face;
  std::uint32_t slot = 0;
  std::vector<LoopId> loops;
};

/// Each new face with kept loops is alone in the block of a slot: `made`, by the faces in `kept`.
/// Makes blocks that have these loops, too. In a slot from which loops were kept is what the first
/// face made of it, or nothing.
void add_kept_loops(SharedSlots& shared, std::vector<KeptLoops> kept,
                    std::span<const std::uint32_t> made);

}  // namespace sectile
