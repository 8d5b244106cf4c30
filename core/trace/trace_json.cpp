#include <nlohmann/json.hpp>

#include <cmath>
#include <ostream>

#include "sectile/trace.h"

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

using Json = nlohmann::ordered_json;

Json to_json(const Vec3& v) {
  return {v.x, v.y, v.z};
}

const char* letter(std::uint8_t solid) {
  return solid == 0 ? "A" : "B";
}

Json to_json(const TraceSector& sector) {
  Json json{{"solid", letter(sector.solid)}, {"face", "f" + std::to_string(sector.face)}};
  if (sector.from_edge != TraceSector::no_edge) {
    json["from_edge"] = "e" + std::to_string(sector.from_edge);
    json["to_edge"] = "e" + std::to_string(sector.to_edge);
    json["from"] = to_json(sector.from);
    json["to"] = to_json(sector.to);
  }
  json["normal"] = to_json(sector.normal);
  return json;
}

Json to_json(const TraceHalfPlane& h) {
  Json json{{"solid", letter(h.solid)},
            {"face", "f" + std::to_string(h.face)},
            {"of", h.carrier},
            {"forward", h.forward},
            {"direction", to_json(h.direction)},
            {"normal", to_json(h.normal)},
            {"before", h.before},
            {"after", h.after}};
  if (h.coplanar >= 0) json["coplanar_with"] = h.coplanar;
  json["kept"] = h.kept;
  json["cut"] = h.cut;
  return json;
}

template <class T>
void add_list(Json& json, const char* name, const std::vector<T>& list) {
  for (const T& item : list) json[name].push_back(to_json(item));
}

Json to_json(const TraceEvent& event, Operation operation) {
  Json json{{"kind", event.kind}};
  if (!event.a.empty()) json["a"] = event.a;
  if (!event.b.empty()) json["b"] = event.b;
  add_list(json, "points", event.points);
  for (const auto& [name, value] : event.facts) json["facts"].push_back({name, value});
  if (event.kind == "contact")
    json["facts"].push_back({"place", std::to_string(event.places.at(0))});
  if (event.kind == "neighborhood") {
    for (const TraceHalfPlane& h : event.half_planes)
      json["facts"].push_back({"half-plane", describe(h)});
    const PaperRule rule = paper_rule(event, operation);
    json["facts"].push_back({"rule", rule.where});
    json["facts"].push_back({"says", rule.says});
  }
  if (!event.places.empty()) json["places"] = event.places;
  add_list(json, "sectors", event.sectors);
  add_list(json, "half_planes", event.half_planes);
  add_list(json, "pulls", event.pulls);
  return json;
}

class JsonObserver : public Observer {
 public:
  explicit JsonObserver(Operation operation) : operation_(operation) {}
  void phase_done(Phase phase, const std::vector<TraceEvent>& events) override {
    Json list = Json::array();
    for (const TraceEvent& event : events) list.push_back(to_json(event, operation_));
    phases.push_back({{"phase", name_of(phase)}, {"count", events.size()}, {"events", list}});
  }
  Json phases = Json::array();

 private:
  Operation operation_;
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
  JsonObserver observer(operation);
  BooleanOptions options;
  options.observer = &observer;
  const Solid result = boolean(a, b, operation, options);
  const Json document{{"format", "sectile trace 1"},
                      {"operation", name_of(operation)},
                      {"volume", result.volume()},
                      {"phases", observer.phases}};
  out << document.dump(1) << '\n';
}

}  // namespace sectile
