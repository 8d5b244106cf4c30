// The trace: names are the operands' own, directions fit the geometry, and the JSON holds it all.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <set>
#include <sstream>

#include "samples/samples.h"
#include "sectile/sectile.h"
#include "storage/solid_data.h"

namespace sectile {
namespace {

struct Collector : Observer {
  void phase_done(Phase phase, const std::vector<TraceEvent>& found) override {
    phases.push_back(phase);
    events.insert(events.end(), found.begin(), found.end());
  }
  std::vector<Phase> phases;
  std::vector<TraceEvent> events;
};

Collector traced(const Solid& a, const Solid& b, Operation operation) {
  Collector collector;
  BooleanOptions options;
  options.observer = &collector;
  boolean(a, b, operation, options);
  return collector;
}

double dot(const Vec3& u, const Vec3& v) {
  return u.x * v.x + u.y * v.y + u.z * v.z;
}
Vec3 minus(const Vec3& p, const Vec3& q) {
  return {p.x - q.x, p.y - q.y, p.z - q.z};
}
Vec3 cross(const Vec3& u, const Vec3& v) {
  return {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
}
double length(const Vec3& v) {
  return std::sqrt(dot(v, v));
}

std::vector<Collector> all_traces() {
  std::vector<Collector> traces;
  for (const samples::Sample& sample : samples::all()) {
    if (sample.b.is_empty()) continue;
    for (const Operation o : {Operation::unite, Operation::intersect, Operation::subtract})
      traces.push_back(traced(sample.a, sample.b, o));
  }
  return traces;
}

template <class Event, class Visit>
void for_each(const Collector& trace, const Visit& visit) {
  for (const TraceEvent& event : trace.events)
    if (const auto* found = std::get_if<Event>(&event)) visit(*found);
}

// How far a place is from the entity of the solid that is said to be there.
double distance(const Solid& solid, const TraceEntity& entity, const Vec3& place) {
  const SolidData& data = *solid.data();
  const auto at = [&](VertexId v) { return data.geometry().position(data.brep().point_of(v)); };
  if (entity.is_vertex()) return length(minus(place, at(VertexId(entity.number))));
  if (entity.is_edge()) {
    const HalfEdgeId h = Brep::half_edge(EdgeId(entity.number));
    const Vec3 p = at(data.brep().from(h)), along = minus(at(data.brep().to(h)), p);
    const double t = dot(minus(place, p), along) / dot(along, along);
    if (t < 0 || t > 1) return 1;
    return length(cross(minus(place, p), along)) / length(along);
  }
  const LoopId loop = data.brep().outer_loop[FaceId(entity.number)];
  const HalfEdgeId h = data.brep().loop_half_edge[loop], next = data.brep().next_of(h);
  const Vec3 p = at(data.brep().from(h)),
             normal = cross(minus(at(data.brep().to(h)), p), minus(at(data.brep().to(next)), p));
  return std::abs(dot(minus(place, p), normal)) / length(normal);
}

void expect_right_names(const Solid& a, const Solid& b, const Collector& trace) {
  std::size_t contacts = 0;
  for (const TraceEvent& event : trace.events) {
    if (!std::holds_alternative<ContactEvent>(event) &&
        !std::holds_alternative<SegmentEvent>(event) && !std::holds_alternative<CutEvent>(event))
      continue;
    ++contacts;
    for (const TracePlace& place : places_of(event))
      for (const int s : {0, 1})
        for (const TraceEntity& entity : entities_of(event, s))
          EXPECT_LT(distance(s == 0 ? a : b, entity, place.point), 1e-12) << name_of(entity);
  }
  EXPECT_GT(contacts, 0u);
}

TEST(Trace, NamesEntitiesAsTheOperandsDo) {
  for (const char* name : {"fig01", "fig12", "fig22"}) {
    const samples::Sample sample = samples::get(name);
    expect_right_names(sample.a, sample.b, traced(sample.a, sample.b, Operation::unite));
  }
}

// Only a small part of the sphere is loaded, and numbered anew there.
TEST(Trace, NamesEntitiesOfPartlyLoadedOperands) {
  const Solid ball = sphere(4, 64, 32), cube = block({3, -1, -1}, {6, 1, 1});
  const Collector trace = traced(cube, ball, Operation::subtract);
  expect_right_names(cube, ball, trace);
  std::uint32_t largest = 0;
  for_each<ContactEvent>(
      trace, [&](const ContactEvent& contact) { largest = std::max(largest, contact.b.number); });
  EXPECT_GT(largest, 500u);
}

// Turned inside out it is paired anew along the line, in blocks of which some are new.
TEST(Trace, OfALargeSolidThatTouchesItselfAndIsTakenAway) {
  const Solid touching = subtract(sphere(1, 64, 32), std::vector{block({0, 0, -.3}, {2, 2, .3}),
                                                                 block({-2, -2, -.3}, {0, 0, .3})});
  ASSERT_GT(touching.data()->slots().size(), 1u);
  const Solid around = block({-2, -2, -.5}, {2, 2, 2});
  Collector collector;
  BooleanOptions options;
  options.observer = &collector;
  const Solid observed = boolean(around, touching, Operation::subtract, options);
  EXPECT_TRUE(observed == boolean(around, touching, Operation::subtract));
  EXPECT_FALSE(collector.events.empty());
}

TEST(Trace, NewEntitiesHaveNewNames) {
  const samples::Sample sample = samples::get("fig12");
  const Collector trace = traced(sample.a, sample.b, Operation::unite);
  std::set<std::pair<int, std::uint32_t>> names;
  std::size_t count = 0;
  for_each<NullEdgeEvent>(trace, [&](const NullEdgeEvent& event) {
    ++count;
    const Solid& solid = event.solid == 1 ? sample.b : sample.a;
    EXPECT_GE(event.edge.number, solid.counts().edges);
    names.insert({event.solid, event.edge.number});
  });
  EXPECT_EQ(count, 12u);
  EXPECT_EQ(names.size(), count);
}

TEST(Trace, ReportsEachPhaseOnce) {
  const std::vector<Phase> all = {Phase::reduction,  Phase::vertex_face, Phase::vertex_vertex,
                                  Phase::null_edges, Phase::joining,     Phase::components,
                                  Phase::gluing,     Phase::cleanup};
  for (const Collector& trace : all_traces()) EXPECT_EQ(trace.phases, all);
}

// Half-planes lie in their faces' planes, at right angles to the segment, and turn
// counter-clockwise; the material of each solid is before its forward ones.
TEST(Trace, HalfPlanesTurnAroundTheirSegment) {
  for (const Collector& trace : all_traces())
    for_each<NeighborhoodEvent>(trace, [](const NeighborhoodEvent& event) {
      const Vec3 along = minus(event.ends[1].point, event.ends[0].point);
      const Vec3& start = event.half_planes[0].direction;
      double before = -1e-9;
      for (const TraceHalfPlane& h : event.half_planes) {
        EXPECT_NEAR(dot(h.direction, along), 0, 1e-9);
        EXPECT_NEAR(dot(h.direction, h.normal), 0, 1e-12);
        EXPECT_NEAR(length(h.direction), 1, 1e-12);
        EXPECT_EQ(dot(cross(along, h.direction), h.normal) > 0, h.forward);
        double turn = std::atan2(dot(cross(start, h.direction), along) / length(along),
                                 dot(start, h.direction));
        if (turn < -1e-9) turn += 2 * std::numbers::pi;
        EXPECT_GT(turn, before - 1e-9);
        before = turn;
        if (h.coplanar < 0) continue;
        const TraceHalfPlane& other = event.half_planes.at(static_cast<std::size_t>(h.coplanar));
        EXPECT_NE(other.solid, h.solid);
        EXPECT_NEAR(dot(other.direction, h.direction), 1, 1e-12);
        EXPECT_NEAR(dot(other.normal, h.normal), h.before == TraceClass::on_plus ? 1 : -1, 1e-12);
      }
    });
}

TEST(Trace, OnClassesComeWithAPartner) {
  for (const Collector& trace : all_traces())
    for_each<NeighborhoodEvent>(trace, [](const NeighborhoodEvent& event) {
      for (const TraceHalfPlane& h : event.half_planes) EXPECT_EQ(h.coplanar >= 0, is_on(h.before));
    });
}

// The neighborhood of a vertex is a cycle of sectors that share its edges.
TEST(Trace, SectorsMakeCycles) {
  for (const Collector& trace : all_traces())
    for_each<ContactEvent>(trace, [](const ContactEvent& event) {
      for (const std::uint8_t s : {0, 1}) {
        std::vector<TraceSector> cycle;
        for (const TraceSector& sector : event.sectors)
          if (sector.solid == s) cycle.push_back(sector);
        const TraceEntity& entity = s == 0 ? event.a : event.b;
        if (entity.is_face()) {
          ASSERT_EQ(cycle.size(), 1u);
          EXPECT_EQ(cycle[0].face, entity.number);
          continue;
        }
        ASSERT_GE(cycle.size(), entity.is_edge() ? 2u : 3u);
        for (std::size_t i = 0; i < cycle.size(); ++i) {
          const TraceSector& next = cycle[(i + 1) % cycle.size()];
          EXPECT_EQ(cycle[i].to_edge, next.from_edge);
          EXPECT_LT(length(minus(cycle[i].to, next.from)), 1e-12);
          EXPECT_NEAR(dot(cycle[i].from, cycle[i].normal), 0, 1e-12);
        }
      }
    });
}

// All vertices of a chain of null edges move to different places.
TEST(Trace, EndsOfNullEdgesMoveApart) {
  for (const Collector& trace : all_traces())
    for_each<NullEdgeEvent>(trace, [](const NullEdgeEvent& event) {
      for (const Vec3& pull : event.pulls) EXPECT_LE(length(pull), 1 + 1e-12);
      EXPECT_GT(length(minus(event.pulls[0], event.pulls[1])), 0.1) << name_of(event.edge);
    });
}

TEST(Trace, PartsCountAllFaces) {
  const samples::Sample sample = samples::get("fig11");
  std::vector<std::string> found;
  for_each<PartEvent>(traced(sample.a, sample.b, Operation::subtract), [&](const PartEvent& part) {
    found.push_back(part_name(part.solid, part.side) + " " + std::to_string(part.faces) + " " +
                    std::string(name_of(part.fate)));
  });
  const std::vector<std::string> expected = {"AinB 3 dropped", "AoutB 6 kept",
                                             "BinA 3 kept, turned inside out", "BoutA 6 dropped"};
  EXPECT_EQ(found, expected);
}

// Table I as corrected (docs/paper.md).
TEST(Trace, ReclassifiesByTableOne) {
  for (const Operation o : {Operation::unite, Operation::intersect, Operation::subtract}) {
    const bool unite = o == Operation::unite;
    using enum TraceClass;
    EXPECT_EQ(reclassified(o, 0, on_plus), unite ? out : in);
    EXPECT_EQ(reclassified(o, 0, on_minus), unite ? in : out);
    EXPECT_EQ(reclassified(o, 1, on_plus), unite ? in : out);
    EXPECT_EQ(reclassified(o, 1, on_minus), unite ? in : out);
    for (const int s : {0, 1})
      for (const TraceClass c : {in, out}) EXPECT_EQ(reclassified(o, s, c), c);
  }
}

TEST(Trace, EveryKindOfEventHasItsOwnName) {
  const std::vector<std::pair<TraceEvent, std::string>> kinds = {
      {ContactEvent{}, "contact"},
      {SegmentEvent{}, "segment"},
      {NeighborhoodEvent{}, "neighborhood"},
      {NullEdgeEvent{}, "null edge"},
      {CutEvent{}, "cut"},
      {PartEvent{}, "part"},
      {WedgeEvent{}, "wedge"},
      {ResultEvent{}, "result"}};
  for (const auto& [event, name] : kinds) EXPECT_EQ(kind_of(event), name);
}

TEST(Trace, IsWrittenAsJson) {
  const samples::Sample sample = samples::get("fig13");
  std::ostringstream out;
  write_trace(out, sample.a, sample.b, Operation::subtract);
  const nlohmann::json document = nlohmann::json::parse(out.str());
  EXPECT_EQ(document.at("format"), "sectile trace 1");
  EXPECT_EQ(document.at("operation"), "subtract");
  const std::vector<std::size_t> expected = {6, 3, 0, 6, 6, 4, 3, 1};
  std::vector<std::size_t> counts;
  for (const auto& phase : document.at("phases")) {
    EXPECT_EQ(phase.at("count"), phase.at("events").size());
    counts.push_back(phase.at("count"));
  }
  EXPECT_EQ(counts, expected);
  const auto& contact = document.at("phases")[0].at("events")[0];
  EXPECT_EQ(contact.at("facts")[1], nlohmann::json({"place", contact.at("places")[0].dump()}));
  EXPECT_EQ(contact.at("sectors").size(), 4u);  // a face of A, three corners of B
  const auto& neighborhood = document.at("phases")[1].at("events")[0];
  EXPECT_EQ(neighborhood.at("half_planes").size(), 4u);
  EXPECT_EQ(neighborhood.at("facts").size(), 6u);  // the half-planes in words, the rule
  EXPECT_EQ(neighborhood.at("facts")[4], nlohmann::json({"rule", "figure 14"}));
  EXPECT_EQ(document.at("phases")[3].at("events")[0].at("pulls").size(), 2u);
}

}  // namespace
}  // namespace sectile
