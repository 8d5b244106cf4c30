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

Json to_json(const TraceEvent& event) {
  Json json{{"kind", event.kind}};
  if (!event.a.empty()) json["a"] = event.a;
  if (!event.b.empty()) json["b"] = event.b;
  for (const Vec3& p : event.points) json["points"].push_back({p.x, p.y, p.z});
  for (const auto& [name, value] : event.facts) json["facts"].push_back({name, value});
  return json;
}

class JsonObserver : public Observer {
 public:
  void phase_done(Phase phase, const std::vector<TraceEvent>& events) override {
    Json list = Json::array();
    for (const TraceEvent& event : events) list.push_back(to_json(event));
    phases.push_back({{"phase", name_of(phase)}, {"count", events.size()}, {"events", list}});
  }
  Json phases = Json::array();
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
  JsonObserver observer;
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
