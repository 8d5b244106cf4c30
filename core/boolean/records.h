// What the reduction finds.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "boolean/entity.h"
#include "boolean/ids.h"
#include "boolean/operand.h"
#include "boolean/patch.h"

namespace sectile {

/// A place where the two boundaries meet in a point: one entity of each. Several contacts may be at
/// one place.
struct Contact {
  PerOperand<Entity> on;
  PointId point;
  PlaceId place;
};

/// A segment between two neighbouring places in which two entities meet (face or edge each).
struct SegmentRecord {
  PlaceId place[2];                       ///< ascending
  PerOperand<Entity> on;                  ///< the face or edge of each solid
  PerOperand<std::array<Entity, 2>> end;  ///< at each place: the entity of the solid's closure
};

}  // namespace sectile
