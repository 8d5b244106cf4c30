// Where one boundary is certainly clear of the other one: boxes around slots that no box of a slot
// of the other solid overlaps. All that is in one such box, or in several that hang together, lies
// on one side of the other boundary, whether it is connected there or not.
#pragma once

#include <cstdint>
#include <vector>

#include "storage/solid_data.h"

namespace sectile {

struct ClearRegions {
  static constexpr std::uint32_t none = 0xFFFFFFFFu;
  /// Beyond the box around the other solid, and so outside of it.
  static constexpr std::uint32_t beyond = 0;

  std::vector<std::uint32_t> of_slot;  ///< none for slots near the other solid, and empty ones
  std::uint32_t count = 0;             ///< `beyond` is one of them, though nothing may be there
};

/// Both solids have faces. Takes time with the number of slots near the other solid; and, like a
/// copy of numbers, with that of all.
ClearRegions clear_regions(const SolidData& solid, const SolidData& other);

}  // namespace sectile
