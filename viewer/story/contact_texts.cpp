// The reduction in words: contacts and segments (paper, section 5, steps 1 to 8).
#include <array>

#include "story/step_texts.h"
#include "story/wording.h"

namespace sectile::viewer {
namespace {

using Kind = TraceEntity::Kind;

struct ContactWords {
  Kind a, b;
  const char* link;
  const char* words;
};

constexpr std::array<ContactWords, 8> contact_words = {{
    {Kind::edge, Kind::edge, " crosses ",
     "The two edges cross at inner points of both (section 5, step 1). Both are divided here, so "
     "that two vertices coincide."},
    {Kind::edge, Kind::vertex, " through ",
     "The edge of A passes through the vertex of B (step 2). It is divided here, so that two "
     "vertices coincide."},
    {Kind::vertex, Kind::edge, " on ",
     "The edge of B passes through the vertex of A (step 3). It is divided here, so that two "
     "vertices coincide."},
    {Kind::vertex, Kind::vertex, " on ", "The two vertices coincide (step 4)."},
    {Kind::edge, Kind::face, " crosses ",
     "The edge of A goes through the inside of the face of B (step 5). It is divided here, so "
     "that a vertex of A lies in a face of B."},
    {Kind::face, Kind::edge, " crossed by ",
     "The edge of B goes through the inside of the face of A (step 6). It is divided here, so "
     "that a vertex of B lies in a face of A."},
    {Kind::vertex, Kind::face, " on ", "The vertex of A lies inside the face of B (step 7)."},
    {Kind::face, Kind::vertex, " under ", "The vertex of B lies inside the face of A (step 8)."},
}};

const ContactWords& words_for(const ContactEvent& event) {
  for (const ContactWords& words : contact_words)
    if (words.a == event.a.kind && words.b == event.b.kind) return words;
  throw std::logic_error("a contact of an impossible kind: " + meeting_of(event.a, event.b));
}

std::string sector_bounds(const TraceSector& sector) {
  if (sector.from_edge == TraceSector::no_edge) return "all around";
  if (sector.from_edge == sector.to_edge) return "beside e" + std::to_string(sector.from_edge);
  return "e" + std::to_string(sector.from_edge) + " to e" + std::to_string(sector.to_edge);
}

}  // namespace

void tell_contact(const StoryRecord& record, const ContactEvent& event, Step& step) {
  const ContactWords& words = words_for(event);
  step.title = of_solid(0, event.a) + words.link + of_solid(1, event.b);
  step.words = words.words;
  const bool in_face = event.a.is_face() || event.b.is_face();
  step.words += in_face ? " Section 6.1 will settle its neighborhood."
                        : " Section 6.2 will settle their neighborhoods, all sectors of A against "
                          "all sectors of B.";
  const std::size_t here = record.contacts.at(event.place.number).size();
  step.words += " It is place " + std::to_string(event.place.number) + ", at " +
                coordinates(event.place.point);
  step.words += here > 1 ? ", where " + std::to_string(here) + " contacts meet." : ".";
  step.columns = {"solid", "face", "sector"};
  for (const TraceSector& sector : event.sectors)
    step.table.push_back(
        {sector.solid == 0 ? "A" : "B", "f" + std::to_string(sector.face), sector_bounds(sector)});
}

void tell_segment(const SegmentEvent& event, Step& step) {
  const bool edge[2] = {event.a.is_edge(), event.b.is_edge()};
  const std::string places = "between places " + std::to_string(event.ends[0].number) + " and " +
                             std::to_string(event.ends[1].number);
  if (edge[0] && edge[1]) {
    step.title = of_solid(0, event.a) + " along " + of_solid(1, event.b);
    step.words = "The two edges coincide " + places + " (figure 16b).";
  } else if (edge[0] || edge[1]) {
    const int s = edge[0] ? 0 : 1;
    const std::string in_face = of_solid(1 - s, s == 0 ? event.b : event.a);
    step.title = of_solid(s, s == 0 ? event.a : event.b) + " within " + in_face;
    step.words = "The edge lies in the face " + places + " (figure 16a).";
  } else {
    step.title = of_solid(0, event.a) + " across " + of_solid(1, event.b);
    step.words = "The two faces cross each other " + places + " (figure 14).";
  }
  step.words +=
      " No other place lies in between, so all that meets in the segment meets in all "
      "of it: what lies around one of its points lies around each.";
  step.columns = {"place", "at"};
  for (const TracePlace& end : event.ends)
    step.table.push_back({std::to_string(end.number), coordinates(end.point)});
}

}  // namespace sectile::viewer
