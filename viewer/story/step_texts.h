// A step in words and tables.
#pragma once

#include "story/story_record.h"

namespace sectile::viewer {

Step tell_step(const StoryRecord& record, std::size_t number);

// One for each kind of event; they fill title, words, columns and table.
void tell_contact(const StoryRecord& record, const TraceEvent& event, Step& step);
void tell_segment(const TraceEvent& event, Step& step);
void tell_neighborhood(const StoryRecord& record, const TraceEvent& event, Step& step);
void tell_null_edge(const StoryRecord& record, const TraceEvent& event, Step& step);
void tell_cut(const StoryRecord& record, const TraceEvent& event, Step& step);
void tell_part(const StoryRecord& record, const TraceEvent& event, Step& step);
void tell_wedge(const StoryRecord& record, const TraceEvent& event, Step& step);
void tell_result(const StoryRecord& record, const TraceEvent& event, Step& step);

}  // namespace sectile::viewer
