// Loads the faces that may meet.
#pragma once

#include <cstdint>
#include <span>

#include "boolean/neighborhoods/neighborhoods.h"
#include "boolean/reduction/reduction.h"
#include "boolean/workspace.h"

namespace sectile {

/// `pairs` are pairs of loaded faces, ascending. What `wanted` says will be made of them, and
/// nothing else.
void load(Workspace& w, const SolidData& a, const SolidData& b, FacePairs& pairs,
          const Wanted& wanted = {});

/// Both operands are one solid, of which nothing but the faces in some of its slots can be loaded.
void load_slots(Workspace& w, const SolidData& solid, std::span<const std::uint32_t> slots,
                FacePairs& pairs, const Wanted& wanted = {});

}  // namespace sectile
