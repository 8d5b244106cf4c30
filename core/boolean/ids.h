// The ids of the records that the phases hand over.
#pragma once

#include "numbers/id.h"
#include "numbers/table.h"

namespace sectile {

struct PlaceTag {
  static constexpr char letter = 'q';
};
struct ContactTag {
  static constexpr char letter = 'k';
};
struct SegmentTag {
  static constexpr char letter = 'g';
};
struct CarrierTag {
  static constexpr char letter = 'c';
};
struct HalfPlaneTag {
  static constexpr char letter = 'w';
};
struct SiteTag {
  static constexpr char letter = 'i';
};
struct PlannedEndTag {
  static constexpr char letter = 'n';
};
struct CutEndTag {
  static constexpr char letter = 'd';
};

using PlaceId = Id<PlaceTag>;
using ContactId = Id<ContactTag>;
using SegmentId = Id<SegmentTag>;
using CarrierId = Id<CarrierTag>;
using HalfPlaneId = Id<HalfPlaneTag>;
using SiteId = Id<SiteTag>;
using PlannedEndId = Id<PlannedEndTag>;
using CutEndId = Id<CutEndTag>;

}  // namespace sectile
