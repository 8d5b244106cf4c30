// How large what lies around a place is drawn, and segments too short to be seen.
#pragma once

#include <string>

#include "story/story_record.h"

namespace sectile::viewer {

/// The shortest segment that leaves a place; a huge number if none does.
double shortest_segment_at(const StoryRecord& record, std::uint32_t place);
/// The radius at which sectors at the places of an event are drawn: not larger than the segments
/// there, but to be seen in any case.
double neighborhood_size(const StoryRecord& record, const TraceEvent& event);

/// The event, with the ends of a segment that is too short to be seen moved apart.
TraceEvent enlarged(const StoryRecord& record, const TraceEvent& event);
/// Where a place is drawn: at its end of such a segment, if it has one.
glm::dvec3 place_shown(const StoryRecord& record, const TracePlace& place);
/// How long the shortest segment that leaves a place is drawn; a huge number if none does.
double shortest_segment_shown(const StoryRecord& record, std::uint32_t place);
/// Of a place that is drawn elsewhere: says so; else nothing.
std::string note_on_place(const StoryRecord& record, const TracePlace& place);
/// Says by how much; nothing if the event is drawn as it is.
std::string note_on_enlargement(const StoryRecord& record, const TraceEvent& event);

}  // namespace sectile::viewer
