#include <ostream>

#include "sectile/trace.h"
#include "trace/json_text.h"

namespace sectile {

std::string_view name_of(Phase phase) {
  switch (phase) {
    case Phase::reduction:
      return "reduction";
    case Phase::vertex_face:
      return "vertex_face";
    case Phase::vertex_vertex:
      return "vertex_vertex";
    case Phase::null_edges:
      return "null_edges";
    case Phase::joining:
      return "joining";
    case Phase::components:
      return "components";
    case Phase::gluing:
      return "gluing";
    case Phase::cleanup:
      break;
  }
  return "cleanup";
}

namespace {

std::string entity(char kind, std::uint32_t number) {
  return kind + std::to_string(number);
}

const char* letter(std::uint8_t solid) {
  return solid == 0 ? "A" : "B";
}

template <class Value>
void write(JsonText& json, const Value& value) {
  json.value(value);
}

void write(JsonText& json, std::uint32_t number) {
  json.value(std::size_t{number});
}

template <class Value>
void member(JsonText& json, std::string_view name, const Value& value);

void write(JsonText& json, const Vec3& v) {
  json.begin_array();
  for (const double x : {v.x, v.y, v.z}) json.value(x);
  json.end_array();
}

void write(JsonText& json, const TraceSector& sector) {
  json.begin_object();
  member(json, "solid", letter(sector.solid));
  member(json, "face", entity('f', sector.face));
  if (sector.from_edge != TraceSector::no_edge) {
    member(json, "from_edge", entity('e', sector.from_edge));
    member(json, "to_edge", entity('e', sector.to_edge));
    member(json, "from", sector.from);
    member(json, "to", sector.to);
  }
  member(json, "normal", sector.normal);
  json.end_object();
}

void write(JsonText& json, const TraceHalfPlane& h) {
  json.begin_object();
  member(json, "solid", letter(h.solid));
  member(json, "face", entity('f', h.face));
  member(json, "of", h.carrier);
  member(json, "forward", h.forward);
  member(json, "direction", h.direction);
  member(json, "normal", h.normal);
  member(json, "before", h.before);
  member(json, "after", h.after);
  if (h.coplanar >= 0) member(json, "coplanar_with", h.coplanar);
  member(json, "kept", h.kept);
  member(json, "cut", h.cut);
  json.end_object();
}

using Fact = std::pair<std::string, std::string>;

void write(JsonText& json, const Fact& fact) {
  json.begin_array();
  json.value(fact.first);
  json.value(fact.second);
  json.end_array();
}

template <class Value>
void member(JsonText& json, std::string_view name, const Value& value) {
  json.name(name);
  write(json, value);
}

template <class T>
void write_list(JsonText& json, std::string_view name, const std::vector<T>& list) {
  if (list.empty()) return;
  json.name(name);
  json.begin_array();
  for (const T& item : list) write(json, item);
  json.end_array();
}

std::vector<Fact> all_facts(const TraceEvent& event, Operation operation) {
  std::vector<Fact> facts = event.facts;
  if (event.kind == "contact") facts.emplace_back("place", std::to_string(event.places.at(0)));
  if (event.kind == "neighborhood") {
    for (const TraceHalfPlane& h : event.half_planes) facts.emplace_back("half-plane", describe(h));
    const PaperRule rule = paper_rule(event, operation);
    facts.emplace_back("rule", rule.where);
    facts.emplace_back("says", rule.says);
  }
  return facts;
}

void write(JsonText& json, const TraceEvent& event, Operation operation) {
  json.begin_object();
  member(json, "kind", event.kind);
  if (!event.a.empty()) member(json, "a", event.a);
  if (!event.b.empty()) member(json, "b", event.b);
  write_list(json, "points", event.points);
  write_list(json, "facts", all_facts(event, operation));
  write_list(json, "places", event.places);
  write_list(json, "sectors", event.sectors);
  write_list(json, "half_planes", event.half_planes);
  write_list(json, "pulls", event.pulls);
  json.end_object();
}

struct PhaseEvents {
  Phase phase;
  std::vector<TraceEvent> events;
};

void write(JsonText& json, const PhaseEvents& done, Operation operation) {
  json.begin_object();
  member(json, "phase", name_of(done.phase));
  member(json, "count", done.events.size());
  json.name("events");
  json.begin_array();
  for (const TraceEvent& event : done.events) write(json, event, operation);
  json.end_array();
  json.end_object();
}

struct Recorder : Observer {
  void phase_done(Phase phase, const std::vector<TraceEvent>& events) override {
    phases.push_back({phase, events});
  }
  std::vector<PhaseEvents> phases;
};

std::string_view name_of(Operation operation) {
  switch (operation) {
    case Operation::unite:
      return "union";
    case Operation::intersect:
      return "intersect";
    case Operation::subtract:
      break;
  }
  return "subtract";
}

}  // namespace

void write_trace(std::ostream& out, const Solid& a, const Solid& b, Operation operation) {
  Recorder recorder;
  BooleanOptions options;
  options.observer = &recorder;
  const Solid result = boolean(a, b, operation, options);
  JsonText json(out);
  json.begin_object();
  member(json, "format", "sectile trace 1");
  member(json, "operation", name_of(operation));
  member(json, "volume", result.volume());
  json.name("phases");
  json.begin_array();
  for (const PhaseEvents& done : recorder.phases) write(json, done, operation);
  json.end_array();
  json.end_object();
  out << '\n';
}

}  // namespace sectile
