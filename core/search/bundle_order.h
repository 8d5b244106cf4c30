// An order in which long things that lie side by side come one after another, also where others in
// other directions lie between them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "search/oriented_box.h"

namespace sectile {

/// Along a curve through the places of both ends of the boxes, in six dimensions.
std::vector<std::uint32_t> order_in_bundles(std::span<const OrientedBox> boxes);

}  // namespace sectile
