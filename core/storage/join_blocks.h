// The boundary of a solid in several blocks as one structure.
#pragma once

#include "storage/solid_data.h"

namespace sectile {

/// Faces in the order of the slots and of the blocks' faces. Vertices at one point share it.
void join_blocks(const SolidData& solid, Brep& brep, Geometry& geometry);

}  // namespace sectile
