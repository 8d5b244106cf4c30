#include "boolean/report/report.h"

#include <algorithm>
#include <tuple>

#include "boolean/report/report_names.h"
#include "boolean/report/report_places.h"

namespace sectile {
namespace {

void send(const Workspace& w, Phase phase, const std::vector<TraceEvent>& events) {
  w.options.observer->phase_done(phase, events);
}

std::array<TracePlace, 2> ends_of(const Workspace& w, const Contacts& contacts,
                                  const PlaceId (&place)[2]) {
  return {place_at(w, contacts, place[0]), place_at(w, contacts, place[1])};
}

NeighborhoodEvent neighborhood(const Workspace& w, const Contacts& contacts, const Neighborhoods& n,
                               const Segment& s, Operation operation) {
  NeighborhoodEvent event;
  event.ends = ends_of(w, contacts, s.place);
  for (const CarrierId id : s.carriers) {
    const Carrier& c = n.carriers[id];
    (c.operand == Operand::a ? event.a : event.b).push_back(traced(w.patch[c.operand], c.entity));
  }
  event.half_planes = trace_half_planes(w, contacts, n, s, operation);
  return event;
}

// A segment belongs to 6.2 if at one of its ends a vertex of A meets a vertex of B: once the edges
// are subdivided, that is where no face's inside takes part.
bool is_vertex_vertex(const Neighborhoods& n, const Segment& s) {
  for (int which = 0; which < 2; ++which) {
    bool inside_face = false;
    for (const CarrierId id : s.carriers) inside_face |= n.carriers[id].end[which].is_face();
    if (!inside_face) return true;
  }
  return false;
}

// As one reads them: vertices before edges, and these before faces.
std::vector<Contact> by_entities(const Contacts& contacts) {
  std::vector<Contact> sorted(contacts.contacts.begin(), contacts.contacts.end());
  std::stable_sort(sorted.begin(), sorted.end(), [](const Contact& p, const Contact& q) {
    return std::tie(p.on[Operand::a], p.on[Operand::b]) <
           std::tie(q.on[Operand::a], q.on[Operand::b]);
  });
  return sorted;
}

}  // namespace

void report_reduction(const Workspace& w, const Contacts& contacts) {
  std::vector<TraceEvent> events;
  const auto traced_pair = [&](const PerOperand<Entity>& on) {
    return std::pair(traced(w.patch[Operand::a], on[Operand::a]),
                     traced(w.patch[Operand::b], on[Operand::b]));
  };
  for (const Contact& c : by_entities(contacts)) {
    const auto [a, b] = traced_pair(c.on);
    ContactEvent event{a, b, place_at(w, contacts, c.place), {}};
    for (const Operand s : both_operands) add_sectors(w, s, c.on[s], event.sectors);
    events.emplace_back(std::move(event));
  }
  for (const SegmentRecord& r : contacts.segments) {
    const auto [a, b] = traced_pair(r.on);
    events.emplace_back(SegmentEvent{a, b, ends_of(w, contacts, r.place)});
  }
  send(w, Phase::reduction, events);
}

void report_neighborhoods(const Workspace& w, const Contacts& contacts,
                          const Neighborhoods& neighborhoods, Operation operation) {
  for (const Phase phase : {Phase::vertex_face, Phase::vertex_vertex}) {
    std::vector<TraceEvent> events;
    for (const Segment& s : neighborhoods.segments)
      if (is_vertex_vertex(neighborhoods, s) == (phase == Phase::vertex_vertex))
        events.emplace_back(neighborhood(w, contacts, neighborhoods, s, operation));
    send(w, phase, events);
  }
}

void report_joining(const Workspace& w, const Contacts& contacts,
                    const Neighborhoods& neighborhoods, const JoinedCuts& joined) {
  std::vector<TraceEvent> events;
  for (const Segment& s : neighborhoods.segments)
    for (const CarrierId id : s.carriers) {
      const Carrier& c = neighborhoods.carriers[id];
      if (!c.cut) continue;
      const CutSides& sides = joined.sides[id];
      events.emplace_back(CutEvent{number_of(c.operand), traced(w.patch[c.operand], c.entity),
                                   ends_of(w, contacts, s.place), sides.forward.value(),
                                   sides.backward.value()});
    }
  send(w, Phase::joining, events);
}

void report_components(const Workspace& w, const FaceLabels& kept_faces, Operation operation) {
  std::vector<TraceEvent> events;
  for (const Operand s : both_operands) {
    std::size_t stays = 0, all = 0;
    for (const FaceId f : kept_faces.loaded[s].ids()) {
      if (!w.patch[s].is_real(f)) continue;
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
      events.emplace_back(PartEvent{number_of(s), c == Class::in ? TraceClass::in : TraceClass::out,
                                    fate, is_kept ? stays : all - stays});
    }
  }
  send(w, Phase::components, events);
}

void report_gluing(const Workspace& w, const Contacts& contacts, const Neighborhoods& neighborhoods,
                   const std::vector<WedgePair>& wedges) {
  std::vector<TraceEvent> events;
  // Wedges stand in the order of their segments.
  auto segment = neighborhoods.segments.begin();
  for (const WedgePair& pair : wedges) {
    while (!segment->half_planes.contains(pair.first)) ++segment;
    const auto side = [&](HalfPlaneId id) {
      const HalfPlane& h = neighborhoods.half_planes[id];
      return WedgeEvent::Side{number_of(h.operand), traced(w.patch[h.operand], h.face)};
    };
    const HalfPlane& first = neighborhoods.half_planes[pair.first];
    events.emplace_back(WedgeEvent{ends_of(w, contacts, segment->place),
                                   {side(pair.first), side(pair.second)},
                                   neighborhoods.carriers[first.carrier].cut});
  }
  send(w, Phase::gluing, events);
}

void report_cleanup(const Workspace& w, const Solid& result) {
  send(w, Phase::cleanup, {ResultEvent{result.counts()}});
}

}  // namespace sectile
