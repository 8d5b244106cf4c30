// The plane of a split, as far as the solid reaches and a little farther.
#pragma once

#include "story/story_record.h"

namespace sectile::viewer {

Surface plane_of_split(const StoryRecord& record, const Colour& colour);

}  // namespace sectile::viewer
