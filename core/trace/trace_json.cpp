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
  member(json, "of", name_of(h.carrier));
  member(json, "forward", h.forward);
  member(json, "direction", h.direction);
  member(json, "normal", h.normal);
  member(json, "before", name_of(h.before));
  member(json, "after", name_of(h.after));
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

// What an event says beside entities and places, as pairs of words.
class Facts {
 public:
  explicit Facts(Operation operation) : operation_(operation) {}

  std::vector<Fact> operator()(const ContactEvent& e) const {
    return {{"kind", meeting_of(e.a, e.b)}, {"place", std::to_string(e.place.number)}};
  }
  std::vector<Fact> operator()(const SegmentEvent& e) const {
    return {{"kind", meeting_of(e.a, e.b)}};
  }
  std::vector<Fact> operator()(const NeighborhoodEvent& e) const {
    std::vector<Fact> facts;
    for (const TraceHalfPlane& h : e.half_planes) facts.emplace_back("half-plane", describe(h));
    const PaperRule rule = paper_rule(e, operation_);
    facts.emplace_back("rule", rule.where);
    facts.emplace_back("says", rule.says);
    return facts;
  }
  std::vector<Fact> operator()(const NullEdgeEvent& e) const {
    std::vector<Fact> facts{{"from", name_of(e.from)}, {"to", name_of(e.to)}};
    if (e.site) {
      facts.emplace_back("at", name_of(e.site->at));
      facts.emplace_back("cuts there", std::to_string(e.site->cuts));
    } else {
      facts.emplace_back("links", "corners that touch each other");
    }
    return facts;
  }
  std::vector<Fact> operator()(const CutEvent& e) const {
    return {{"forward side", std::to_string(e.forward_side)},
            {"backward side", std::to_string(e.backward_side)}};
  }
  std::vector<Fact> operator()(const PartEvent& e) const {
    return {{"part", part_name(e.solid, e.side)},
            {"becomes", std::string(name_of(e.fate))},
            {"faces", std::to_string(e.faces)}};
  }
  std::vector<Fact> operator()(const WedgeEvent& e) const {
    return {{"between", describe(e.between)}, {"glued", e.glued ? "yes" : "no, never apart"}};
  }
  std::vector<Fact> operator()(const ResultEvent& e) const {
    const SolidCounts& c = e.counts;
    return {{"vertices", std::to_string(c.vertices)}, {"edges", std::to_string(c.edges)},
            {"faces", std::to_string(c.faces)},       {"loops", std::to_string(c.loops)},
            {"shells", std::to_string(c.shells)},     {"genus", std::to_string(c.genus)}};
  }

 private:
  Operation operation_;
};

void write_entities(JsonText& json, std::string_view name, const TraceEvent& event, int solid) {
  std::string names;
  for (const TraceEntity& entity : entities_of(event, solid))
    names += (names.empty() ? "" : " ") + name_of(entity);
  if (!names.empty()) member(json, name, names);
}

void write_numbers(JsonText& json, std::span<const TracePlace> places) {
  std::vector<std::uint32_t> numbers;
  for (const TracePlace& place : places)
    if (place.number != TracePlace::no_number) numbers.push_back(place.number);
  write_list(json, "places", numbers);
}

void write_points(JsonText& json, std::span<const TracePlace> places) {
  std::vector<Vec3> points;
  for (const TracePlace& place : places) points.push_back(place.point);
  write_list(json, "points", points);
}

void write(JsonText& json, const TraceEvent& event, Operation operation) {
  json.begin_object();
  member(json, "kind", kind_of(event));
  write_entities(json, "a", event, 0);
  write_entities(json, "b", event, 1);
  write_points(json, places_of(event));
  write_list(json, "facts", std::visit(Facts(operation), event));
  write_numbers(json, places_of(event));
  if (const auto* contact = std::get_if<ContactEvent>(&event))
    write_list(json, "sectors", contact->sectors);
  if (const auto* neighborhood = std::get_if<NeighborhoodEvent>(&event))
    write_list(json, "half_planes", neighborhood->half_planes);
  if (const auto* null_edge = std::get_if<NullEdgeEvent>(&event))
    write_list(json, "pulls", std::vector<Vec3>(null_edge->pulls.begin(), null_edge->pulls.end()));
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
