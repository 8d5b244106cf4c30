// How many elements a boundary has, without joining its blocks.
#pragma once

#include "storage/solid_data.h"

namespace sectile {

struct ElementCounts {
  std::size_t vertices = 0, edges = 0, faces = 0, loops = 0;
};

/// Looks at the borders of the blocks only.
ElementCounts element_counts(const SolidData& solid);

/// The parts that hang together over edges: from piece to piece of the blocks.
std::size_t shell_count(const SolidData& solid);

}  // namespace sectile
