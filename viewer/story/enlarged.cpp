#include "story/enlarged.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

namespace sectile::viewer {
namespace {

// Of the size of the scene.
constexpr double shortest_to_be_seen = 0.02, length_when_enlarged = 0.22;

double length_of(std::span<const TracePlace> ends) {
  return glm::length(to_glm(ends[1].point) - to_glm(ends[0].point));
}

bool is_too_short(const StoryRecord& record, const TraceEvent& event) {
  const std::span<const TracePlace> places = places_of(event);
  return places.size() == 2 && length_of(places) < shortest_to_be_seen * record.bounds.radius();
}

// Rounded ends may be in one place; what lies beside the segment knows where it goes.
glm::dvec3 direction_of(const StoryRecord& record, const TraceEvent& event) {
  const std::span<const TracePlace> places = places_of(event);
  const NeighborhoodEvent* around = record.neighborhood({places[0], places[1]});
  if (around && !around->half_planes.empty()) {
    const TraceHalfPlane& h = around->half_planes[0];
    const glm::dvec3 forward = glm::cross(to_glm(h.direction), to_glm(h.normal));
    return h.forward ? forward : -forward;
  }
  const glm::dvec3 along = to_glm(places[1].point) - to_glm(places[0].point);
  const double length = glm::length(along);
  return length > 0 ? along / length : glm::dvec3(1, 0, 0);
}

// Of the events that have a segment.
std::array<TracePlace, 2>* ends_of(TraceEvent& event) {
  return std::visit(
      [](auto& one) -> std::array<TracePlace, 2>* {
        if constexpr (requires { one.ends; })
          return &one.ends;
        else
          return nullptr;
      },
      event);
}

}  // namespace

double shortest_segment_at(const StoryRecord& record, std::uint32_t place) {
  double shortest = std::numeric_limits<double>::max();
  for (const std::uint32_t i : record.neighborhoods.at(place))
    shortest = std::min(shortest, length_of(places_of(record.events[i])));
  return shortest;
}

double neighborhood_size(const StoryRecord& record, const TraceEvent& event) {
  const double scene = record.bounds.radius();
  double shortest = 0.4 * scene;
  for (const TracePlace& place : places_of(event))
    shortest = std::min(shortest, shortest_segment_at(record, place.number));
  return std::clamp(0.45 * shortest, 0.07 * scene, 0.2 * scene);
}

TraceEvent enlarged(const StoryRecord& record, const TraceEvent& event) {
  TraceEvent shown = event;
  if (!is_too_short(record, event)) return shown;
  std::array<TracePlace, 2>& places = *ends_of(shown);
  const glm::dvec3 middle = 0.5 * (to_glm(places[0].point) + to_glm(places[1].point));
  const glm::dvec3 half =
      direction_of(record, event) * (0.5 * length_when_enlarged * record.bounds.radius());
  const glm::dvec3 ends[2] = {middle - half, middle + half};
  for (std::size_t i = 0; i < 2; ++i) places[i].point = {ends[i].x, ends[i].y, ends[i].z};
  return shown;
}

glm::dvec3 place_shown(const StoryRecord& record, const TracePlace& place) {
  for (const std::uint32_t i : record.neighborhoods.at(place.number)) {
    if (!is_too_short(record, record.events[i])) continue;
    const TraceEvent shown = enlarged(record, record.events[i]);
    for (const TracePlace& end : places_of(shown))
      if (end.number == place.number) return to_glm(end.point);
  }
  return to_glm(place.point);
}

double shortest_segment_shown(const StoryRecord& record, std::uint32_t place) {
  const double least = length_when_enlarged * record.bounds.radius();
  double shortest = std::numeric_limits<double>::max();
  for (const std::uint32_t i : record.neighborhoods.at(place)) {
    const TraceEvent& event = record.events[i];
    shortest =
        std::min(shortest, is_too_short(record, event) ? least : length_of(places_of(event)));
  }
  return shortest;
}

std::string note_on_place(const StoryRecord& record, const TracePlace& place) {
  if (place.number == TracePlace::no_number) return "";
  for (const std::uint32_t i : record.neighborhoods.at(place.number))
    if (std::string note = note_on_enlargement(record, record.events[i]); !note.empty())
      return note;
  return "";
}

std::string note_on_enlargement(const StoryRecord& record, const TraceEvent& event) {
  if (!is_too_short(record, event)) return "";
  const double length = length_of(places_of(event));
  if (length == 0) return "enlarged: closer than doubles can tell";
  const double times = length_when_enlarged * record.bounds.radius() / length;
  if (times < 1000) return "enlarged " + std::to_string(std::lround(times)) + " times";
  return "enlarged 10^" + std::to_string(std::lround(std::log10(times))) + " times";
}

}  // namespace sectile::viewer
