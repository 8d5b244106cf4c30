// What the rows of a step's table stand for, to be lit while one is pointed at.
#pragma once

#include <optional>
#include <string>

#include "story/story_record.h"

namespace sectile::viewer {

/// A sector at a place, or a half-plane beside a segment.
struct RowElement {
  int solid = 0;
  std::string name;               ///< "A f3", as on the sphere
  std::optional<TraceClass> cls;  ///< if known
  const TraceSector* sector = nullptr;
  const TraceHalfPlane* half_plane = nullptr;
};

/// Nothing if the row stands for none.
std::optional<RowElement> element_of_row(const StoryRecord& record, std::size_t step,
                                         std::size_t row);

}  // namespace sectile::viewer
