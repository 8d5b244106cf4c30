// Makes a solid of blocks that are shared and of a part that is new.
#pragma once

#include <memory>
#include <vector>

#include "storage/cut_into_blocks.h"
#include "storage/kept_loops.h"
#include "storage/shared_slots.h"

namespace sectile {

struct NewPart {
  Brep brep;                 ///< faces of kind `rest` stand for what is shared
  const Geometry& geometry;  ///< has all it needs, and maybe more
  /// Edge i < outside.size() leads from its even half-edge to this border edge of a shared block.
  std::vector<BorderEdge> outside;
  /// Further loops of its faces.
  std::vector<KeptLoops> kept_loops = {};
};

/// The links of `shared` are true, but for those to the new part, which is put into empty and
/// further slots. `touches_itself` is asked only if there are shared blocks: may several vertices
/// of the shared blocks be at one point?
std::shared_ptr<SolidData> splice(SharedSlots shared, NewPart part, bool touches_itself);

/// Are several vertices at one point, other than those that `rest` faces divide?
bool vertices_coincide(const Brep& brep, const Geometry& geometry);

}  // namespace sectile
