#include "boolean/report.h"

#include <sstream>

#include "boolean/tables.h"

namespace sectile {
namespace {

template <class T>
std::string text(const T& value) {
  std::ostringstream out;
  out << value;
  return out.str();
}

std::string_view word(Class c) {
  switch (c) {
    case Class::in:
      return "in";
    case Class::out:
      return "out";
    case Class::on_plus:
      return "on+";
    case Class::on_minus:
      break;
  }
  return "on-";
}

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

std::string kinds(Entity a, Entity b) {
  return std::string(word(a.kind())) + " on " + std::string(word(b.kind()));
}

void send(const Workspace& w, Phase phase, const std::vector<TraceEvent>& events) {
  w.options.observer->phase_done(phase, events);
}

const Vec3& position(const Workspace& w, std::uint32_t place) {
  return w.geometry.position(w.point(place));
}

std::vector<Vec3> ends(const Workspace& w, const Segment& s) {
  return {position(w, s.place[0]), position(w, s.place[1])};
}

// What lies around a segment, in counter-clockwise order.
TraceEvent neighborhood(const Workspace& w, const Segment& s, Operation operation) {
  TraceEvent event{"neighborhood", "", "", ends(w, s), {}};
  for (std::uint32_t i = 0; i < s.half_plane_count; ++i) {
    const HalfPlane& h = w.half_planes[s.first_half_plane + i];
    (h.solid == 0 ? event.a : event.b) += (h.solid == 0 ? event.a : event.b).empty() ? "" : " ";
    (h.solid == 0 ? event.a : event.b) += text(w.carriers[h.carrier].entity);
    const Class four_way = reclassified(operation, h.solid, h.cls);
    std::string value = std::string(h.solid == 0 ? "A " : "B ") + text(h.face) +
                        (h.forward ? " forward: " : " backward: ") + std::string(word(h.cls));
    if (four_way != h.cls) value += ", reclassified " + std::string(word(four_way)) + " (Table I)";
    value += kept(operation, h.solid, h.cls) ? ", kept" : ", dropped";
    event.facts.push_back({"half-plane", value});
  }
  return event;
}

// Vertices within faces are settled in 6.1, all other contacts in 6.2.
bool is_vertex_face(const Workspace& w, const Segment& s) {
  bool edge[2] = {false, false};
  for (std::uint32_t i = 0; i < s.carrier_count; ++i) {
    const Carrier& c = w.carriers[s.first_carrier + i];
    if (c.entity.is_edge()) edge[c.solid] = true;
  }
  return !edge[0] && !edge[1];
}

}  // namespace

void report_reduction(const Workspace& w) {
  std::vector<TraceEvent> events;
  for (const Contact& c : w.contacts)
    events.push_back({"contact",
                      text(c.on[0]),
                      text(c.on[1]),
                      {position(w, c.place)},
                      {{"kind", kinds(c.on[0], c.on[1])}, {"place", std::to_string(c.place)}}});
  for (const SegmentRecord& r : w.records)
    events.push_back({"segment",
                      text(r.on[0]),
                      text(r.on[1]),
                      {position(w, r.place[0]), position(w, r.place[1])},
                      {{"kind", kinds(r.on[0], r.on[1])}}});
  send(w, Phase::reduction, events);
}

void report_neighborhoods(const Workspace& w, Operation operation) {
  for (const Phase phase : {Phase::vertex_face, Phase::vertex_vertex}) {
    std::vector<TraceEvent> events;
    for (const Segment& s : w.segments)
      if (is_vertex_face(w, s) == (phase == Phase::vertex_face))
        events.push_back(neighborhood(w, s, operation));
    send(w, phase, events);
  }
}

void report_null_edges(const Workspace& w) {
  std::vector<TraceEvent> events;
  for (const auto& [solid, edge] : w.null_edges) {
    const Brep& brep = w.patch[solid].brep;
    const HalfEdgeId h = Brep::half_edge(edge);
    TraceEvent event{"null edge", "", "", {w.geometry.position(brep.point_of(brep.from(h)))}, {}};
    (solid == 0 ? event.a : event.b) = text(edge);
    event.facts = {{"from", text(brep.from(h))}, {"to", text(brep.to(h))}};
    events.push_back(event);
  }
  send(w, Phase::null_edges, events);
}

void report_joining(const Workspace& w) {
  std::vector<TraceEvent> events;
  for (const Segment& s : w.segments)
    for (std::uint32_t i = 0; i < s.carrier_count; ++i) {
      const Carrier& c = w.carriers[s.first_carrier + i];
      if (!c.cut) continue;
      TraceEvent event{"cut", "", "", ends(w, s), {}};
      (c.solid == 0 ? event.a : event.b) = text(c.entity);
      event.facts = {{"forward side", text(c.forward)}, {"backward side", text(c.backward)}};
      events.push_back(event);
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
    for (const std::uint8_t label : kept_faces.rest[s]) stays += label;
    const bool out = kept(operation, s, Class::out);
    const std::string name = s == 0 ? (out ? "AoutB" : "AinB") : (out ? "BoutA" : "BinA");
    events.push_back({"part",
                      "",
                      "",
                      {},
                      {{"kept", name + (reversed(operation, s) ? ", turned inside out" : "")},
                       {"faces", std::to_string(stays)},
                       {"loaded faces", std::to_string(all)}}});
  }
  send(w, Phase::components, events);
}

void report_gluing(const Workspace& w, const std::vector<WedgePair>& wedges) {
  std::vector<TraceEvent> events;
  // Wedges stand in the order of their segments.
  auto segment = w.segments.begin();
  for (const WedgePair& pair : wedges) {
    while (pair.first >= segment->first_half_plane + segment->half_plane_count) ++segment;
    const HalfPlane &p = w.half_planes[pair.first], &q = w.half_planes[pair.second];
    const auto side = [](const HalfPlane& h) {
      return std::string(h.solid == 0 ? "A " : "B ") + text(h.face);
    };
    events.push_back(
        {"wedge", "", "", ends(w, *segment), {{"between", side(p) + " and " + side(q)}}});
  }
  send(w, Phase::gluing, events);
}

void report_cleanup(const Workspace& w, const Solid& result) {
  const SolidCounts c = result.counts();
  send(w, Phase::cleanup,
       {{"result",
         "",
         "",
         {},
         {{"vertices", std::to_string(c.vertices)},
          {"edges", std::to_string(c.edges)},
          {"faces", std::to_string(c.faces)},
          {"loops", std::to_string(c.loops)},
          {"shells", std::to_string(c.shells)},
          {"genus", std::to_string(c.genus)}}}});
}

}  // namespace sectile
