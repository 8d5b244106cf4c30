// Does a boundary that touches itself do so in lines, or in single places only?
#pragma once

#include <cstdint>
#include <vector>

#include "storage/solid_data.h"

namespace sectile {

/// The slots around places from which two edges, or an edge and a face, may lead along each other:
/// at which several vertices are, or from which several edges lead to one place. Ascending; none
/// only if it is certain that there are no such places.
std::vector<std::uint32_t> slots_touching_in_lines(const SolidData& solid);

}  // namespace sectile
