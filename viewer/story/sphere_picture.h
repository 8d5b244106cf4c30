// The neighborhood of a place on the unit sphere around it.
#pragma once

#include "story/story_record.h"

namespace sectile::viewer {

SpherePicture sphere_at(const StoryRecord& record, std::uint32_t place);

}  // namespace sectile::viewer
