// Where a boundary in blocks touches itself.
#pragma once

#include <cstdint>
#include <vector>

#include "search/box.h"
#include "storage/solid_data.h"

namespace sectile {

/// The slots whose boxes meet a place where several vertices are, or an edge at whose place there
/// may be others, ascending. There may be more.
std::vector<std::uint32_t> find_touching_slots(const SolidData& solid);

/// The slots whose boxes meet any of these, ascending.
std::vector<std::uint32_t> slots_near(const SolidData& solid, const std::vector<Box>& boxes);

}  // namespace sectile
