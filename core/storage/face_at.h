// A face where it lies in a solid.
#pragma once

#include <cstdint>

#include "topology/brep.h"

namespace sectile {

/// A face of a slot's block.
struct FaceAt {
  std::uint32_t slot;
  FaceId face;
};

}  // namespace sectile
