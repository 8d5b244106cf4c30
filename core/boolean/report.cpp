#include "boolean/report.h"

#include "boolean/report_names.h"
#include "boolean/report_places.h"
#include "boolean/tables.h"

namespace sectile {
namespace {

void send(const Workspace& w, Phase phase, const std::vector<TraceEvent>& events) {
  w.options.observer->phase_done(phase, events);
}

std::array<TracePlace, 2> ends_of(const Workspace& w, const PlaceId (&place)[2]) {
  return {place_at(w, place[0]), place_at(w, place[1])};
}

NeighborhoodEvent neighborhood(const Workspace& w, const Segment& s, Operation operation) {
  NeighborhoodEvent event;
  event.ends = ends_of(w, s.place);
  for (std::uint32_t i = 0; i < s.carrier_count; ++i) {
    const Carrier& c = w.carriers[s.first_carrier + i];
    (c.solid == 0 ? event.a : event.b).push_back(traced(w.patch[c.solid], c.entity));
  }
  event.half_planes = trace_half_planes(w, s, operation);
  return event;
}

// A segment belongs to 6.2 if at one of its ends a vertex of A meets a vertex of B: once the edges
// are subdivided, that is where no face's inside takes part.
bool is_vertex_vertex(const Workspace& w, const Segment& s) {
  for (int which = 0; which < 2; ++which) {
    bool inside_face = false;
    for (std::uint32_t i = 0; i < s.carrier_count; ++i)
      inside_face |= w.carriers[s.first_carrier + i].end[which].is_face();
    if (!inside_face) return true;
  }
  return false;
}

}  // namespace

void report_reduction(const Workspace& w) {
  std::vector<TraceEvent> events;
  for (const Contact& c : w.contacts) {
    ContactEvent event{
        traced(w.patch[0], c.on[0]), traced(w.patch[1], c.on[1]), place_at(w, c.place), {}};
    for (int s = 0; s < 2; ++s) add_sectors(w, s, c.on[s], event.sectors);
    events.emplace_back(std::move(event));
  }
  for (const SegmentRecord& r : w.records)
    events.emplace_back(SegmentEvent{traced(w.patch[0], r.on[0]), traced(w.patch[1], r.on[1]),
                                     ends_of(w, r.place)});
  send(w, Phase::reduction, events);
}

void report_neighborhoods(const Workspace& w, Operation operation) {
  for (const Phase phase : {Phase::vertex_face, Phase::vertex_vertex}) {
    std::vector<TraceEvent> events;
    for (const Segment& s : w.segments)
      if (is_vertex_vertex(w, s) == (phase == Phase::vertex_vertex))
        events.emplace_back(neighborhood(w, s, operation));
    send(w, phase, events);
  }
}

void report_joining(const Workspace& w) {
  std::vector<TraceEvent> events;
  for (const Segment& s : w.segments)
    for (std::uint32_t i = 0; i < s.carrier_count; ++i) {
      const Carrier& c = w.carriers[s.first_carrier + i];
      if (!c.cut) continue;
      events.emplace_back(CutEvent{c.solid, traced(w.patch[c.solid], c.entity), ends_of(w, s.place),
                                   c.forward.value(), c.backward.value()});
    }
  send(w, Phase::joining, events);
}

void report_components(const Workspace& w, const FaceLabels& kept_faces, Operation operation) {
  std::vector<TraceEvent> events;
  for (int s = 0; s < 2; ++s) {
    std::size_t stays = 0, all = 0;
    for (std::size_t f = 0; f < kept_faces.loaded[s].size(); ++f) {
      if (!w.patch[s].is_real(FaceId(f))) continue;
      ++all;
      stays += kept_faces.loaded[s][f];
    }
    if (const RestLabels& rest = kept_faces.rest[s]; !rest.empty())
      for (std::size_t f = 0; f < w.patch[s].solid->face_count(); ++f) {
        const std::uint8_t label = rest.label(0, FaceId(f));
        all += label != RestLabels::loaded;
        stays += label == 1;
      }
    for (const Class c : {Class::in, Class::out}) {
      const bool is_kept = kept(operation, s, c);
      const PartEvent::Fate fate = !is_kept                 ? PartEvent::Fate::dropped
                                   : reversed(operation, s) ? PartEvent::Fate::turned
                                                            : PartEvent::Fate::kept;
      events.emplace_back(PartEvent{static_cast<std::uint8_t>(s),
                                    c == Class::in ? TraceClass::in : TraceClass::out, fate,
                                    is_kept ? stays : all - stays});
    }
  }
  send(w, Phase::components, events);
}

void report_gluing(const Workspace& w, const std::vector<WedgePair>& wedges) {
  std::vector<TraceEvent> events;
  // Wedges stand in the order of their segments.
  auto segment = w.segments.begin();
  for (const WedgePair& pair : wedges) {
    while (pair.first >= segment->first_half_plane + segment->half_plane_count) ++segment;
    const auto side = [&](std::uint32_t half_plane) {
      const HalfPlane& h = w.half_planes[half_plane];
      return WedgeEvent::Side{h.solid, traced(w.patch[h.solid], h.face)};
    };
    const bool glued = w.carriers[w.half_planes[pair.first].carrier].cut;
    events.emplace_back(
        WedgeEvent{ends_of(w, segment->place), {side(pair.first), side(pair.second)}, glued});
  }
  send(w, Phase::gluing, events);
}

void report_cleanup(const Workspace& w, const Solid& result) {
  send(w, Phase::cleanup, {ResultEvent{result.counts()}});
}

}  // namespace sectile
