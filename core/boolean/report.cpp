#include "boolean/report.h"

#include "boolean/report_names.h"
#include "boolean/report_places.h"
#include "boolean/tables.h"

namespace sectile {
namespace {

std::string_view word(Entity::Kind kind) {
  switch (kind) {
    case Entity::Kind::vertex:
      return "vertex";
    case Entity::Kind::edge:
      return "edge";
    case Entity::Kind::face:
      return "face";
    case Entity::Kind::nothing:
      break;
  }
  return "nothing";
}

std::string kinds(const Entity (&on)[2]) {
  return std::string(word(on[0].kind())) + " on " + std::string(word(on[1].kind()));
}

void send(const Workspace& w, Phase phase, const std::vector<TraceEvent>& events) {
  w.options.observer->phase_done(phase, events);
}

// An event about one entity of each solid, at one place or between two.
TraceEvent event_at(const Workspace& w, const char* kind, const Entity (&on)[2],
                    std::vector<std::uint32_t> places) {
  TraceEvent event;
  event.kind = kind;
  event.a = name_of(w.patch[0], on[0]);
  event.b = name_of(w.patch[1], on[1]);
  for (const std::uint32_t place : places)
    event.points.push_back(w.geometry.position(w.point(place)));
  event.facts.push_back({"kind", kinds(on)});
  event.places = std::move(places);
  return event;
}

TraceEvent event_along(const Workspace& w, const char* kind, const Segment& s) {
  TraceEvent event;
  event.kind = kind;
  for (const std::uint32_t place : s.place) {
    event.points.push_back(w.geometry.position(w.point(place)));
    event.places.push_back(place);
  }
  return event;
}

void add_name(std::string& names, const std::string& name) {
  if (!names.empty()) names += ' ';
  names += name;
}

TraceEvent neighborhood(const Workspace& w, const Segment& s, Operation operation) {
  TraceEvent event = event_along(w, "neighborhood", s);
  for (std::uint32_t i = 0; i < s.carrier_count; ++i) {
    const Carrier& c = w.carriers[s.first_carrier + i];
    add_name(c.solid == 0 ? event.a : event.b, name_of(w.patch[c.solid], c.entity));
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
    TraceEvent& event = events.emplace_back(event_at(w, "contact", c.on, {c.place}));
    for (int s = 0; s < 2; ++s) add_sectors(w, s, c.on[s], event.sectors);
  }
  for (const SegmentRecord& r : w.records)
    events.push_back(event_at(w, "segment", r.on, {r.place[0], r.place[1]}));
  send(w, Phase::reduction, events);
}

void report_neighborhoods(const Workspace& w, Operation operation) {
  for (const Phase phase : {Phase::vertex_face, Phase::vertex_vertex}) {
    std::vector<TraceEvent> events;
    for (const Segment& s : w.segments)
      if (is_vertex_vertex(w, s) == (phase == Phase::vertex_vertex))
        events.push_back(neighborhood(w, s, operation));
    send(w, phase, events);
  }
}

void report_joining(const Workspace& w) {
  std::vector<TraceEvent> events;
  for (const Segment& s : w.segments)
    for (std::uint32_t i = 0; i < s.carrier_count; ++i) {
      const Carrier& c = w.carriers[s.first_carrier + i];
      if (!c.cut) continue;
      TraceEvent& event = events.emplace_back(event_along(w, "cut", s));
      const Patch& patch = w.patch[c.solid];
      (c.solid == 0 ? event.a : event.b) = name_of(patch, c.entity);
      event.facts = {{"forward side", std::to_string(c.forward.value())},
                     {"backward side", std::to_string(c.backward.value())}};
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
      TraceEvent& event = events.emplace_back();
      event.kind = "part";
      const char* name =
          s == 0 ? (c == Class::out ? "AoutB" : "AinB") : (c == Class::out ? "BoutA" : "BinA");
      event.facts = {{"part", name},
                     {"becomes", !is_kept                 ? "dropped"
                                 : reversed(operation, s) ? "kept, turned inside out"
                                                          : "kept"},
                     {"faces", std::to_string(is_kept ? stays : all - stays)}};
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
    TraceEvent& event = events.emplace_back(event_along(w, "wedge", *segment));
    std::string sides;
    for (const std::uint32_t i : {pair.first, pair.second}) {
      const HalfPlane& h = w.half_planes[i];
      const std::string name = name_of(w.patch[h.solid], h.face);
      add_name(h.solid == 0 ? event.a : event.b, name);
      sides += (sides.empty() ? "" : " and ") + std::string(h.solid == 0 ? "A " : "B ") + name;
    }
    const bool glued = w.carriers[w.half_planes[pair.first].carrier].cut;
    event.facts = {{"between", sides}, {"glued", glued ? "yes" : "no, never apart"}};
  }
  send(w, Phase::gluing, events);
}

void report_cleanup(const Workspace& w, const Solid& result) {
  const SolidCounts c = result.counts();
  TraceEvent event;
  event.kind = "result";
  event.facts = {{"vertices", std::to_string(c.vertices)}, {"edges", std::to_string(c.edges)},
                 {"faces", std::to_string(c.faces)},       {"loops", std::to_string(c.loops)},
                 {"shells", std::to_string(c.shells)},     {"genus", std::to_string(c.genus)}};
  send(w, Phase::cleanup, {event});
}

}  // namespace sectile
