// A step in words and tables.
#pragma once

#include "story/story_record.h"

namespace sectile::viewer {

Step tell_step(const StoryRecord& record, std::size_t number);

// One for each kind of event; they fill title, words, columns and table.
void tell_contact(const StoryRecord& record, const ContactEvent& event, Step& step);
void tell_segment(const SegmentEvent& event, Step& step);
void tell_neighborhood(const StoryRecord& record, const NeighborhoodEvent& event, Step& step);

/// Fills the verdict, the bullets and the paper's tables.
void judge(const StoryRecord& record, const TraceEvent& event, Step& step);
/// Says of a split what was said of an intersection with a half-space: S, the plane, above, below.
void put_in_words_of_split(const StoryRecord& record, Step& step);

}  // namespace sectile::viewer
