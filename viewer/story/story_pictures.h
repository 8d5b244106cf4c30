// The picture of each phase.
#pragma once

#include "story/story.h"
#include "story/story_record.h"

namespace sectile::viewer {

Picture draw_step(const StoryRecord& record, std::size_t step, const StoryView& view);
Picture draw_phase(const StoryRecord& record, Phase phase, const StoryView& view);
Bounds place_of_step(const StoryRecord& record, std::size_t step);

}  // namespace sectile::viewer
