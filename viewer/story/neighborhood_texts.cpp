// Sections 6.1 and 6.2 in words: what lies around a segment, and what becomes of it.
#include <algorithm>

#include "story/step_texts.h"
#include "story/wording.h"

namespace sectile::viewer {
namespace {

bool is_on(const TraceHalfPlane& h) {
  return is_on(h.before);
}

std::string all_of(int solid, const std::vector<TraceEntity>& entities) {
  std::string text;
  for (const TraceEntity& entity : entities) text += (text.empty() ? "" : ", ") + with_kind(entity);
  return text + (solid == 0 ? " of A" : " of B");
}

std::string how_sorted(const StoryRecord& record, const NeighborhoodEvent& event, Phase phase) {
  std::string text = phase == Phase::vertex_face
                         ? "This segment starts and ends at vertices inside faces (section 6.1). "
                         : "At an end of this segment vertices of A and B coincide (section 6.2). ";
  text += "Around it lie " + std::to_string(event.half_planes.size()) +
          " half-planes, sorted counter-clockwise; each is classified against the other solid. ";
  const PaperRule rule = paper_rule(event, record.operation);
  return text + capital(rule.where) + ": " + rule.says;
}

std::string reclassifications(const StoryRecord& record, const NeighborhoodEvent& event) {
  std::string text;
  for (const TraceHalfPlane& h : event.half_planes) {
    if (!is_on(h)) continue;
    const std::string sentence = " By Table I, row " + sign(record.operation) + ", " +
                                 part_name(h.solid, h.before) + " goes to " +
                                 part_name(h.solid, h.after) + ".";
    if (text.find(sentence) == std::string::npos) text += sentence;
  }
  return text;
}

std::string cuts(const NeighborhoodEvent& event) {
  std::vector<std::string> names;
  for (const TraceHalfPlane& h : event.half_planes) {
    const std::string name = of_solid(h.solid, h.carrier);
    if (h.cut && std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  if (names.empty())
    return " Nothing is cut here: of each face or edge both sides stay together or go together.";
  std::string text = " A cut follows in ";
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0 ? "" : i + 1 == names.size() ? " and in " : ", in ") + names[i];
  return text + ".";
}

std::string null_edges(const StoryRecord& record, const NeighborhoodEvent& event) {
  constexpr std::size_t most = 6;
  std::vector<std::string> names;
  for (const TracePlace& end : event.ends)
    for (const std::uint32_t i : record.null_edges.at(end.number)) {
      const auto& edge = std::get<NullEdgeEvent>(record.events[i]);
      names.push_back(name_of(edge.edge) + (edge.solid == 0 ? " of A" : " of B"));
    }
  if (names.empty()) return "";
  std::string text = " Null edges that follow at its ends: ";
  for (std::size_t i = 0; i < std::min(names.size(), most); ++i)
    text += (i == 0 ? "" : ", ") + names[i];
  if (names.size() > most) text += " and " + std::to_string(names.size() - most) + " more";
  return text + ".";
}

std::string rule_of(const StoryRecord& record, const TraceHalfPlane& h) {
  if (!is_on(h)) return "";
  return "Table I, " + sign(record.operation) + ", " + part_name(h.solid, h.before);
}

}  // namespace

void tell_neighborhood(const StoryRecord& record, const NeighborhoodEvent& event, Step& step) {
  step.title = "around " + all_of(0, event.a) + " and " + all_of(1, event.b);
  step.words = how_sorted(record, event, step.phase) + reclassifications(record, event) + " " +
               equation_4(record.operation) + cuts(event) + null_edges(record, event);
  step.columns = {"solid", "face", "side", "class", "reclassified", "rule", "becomes", "cut"};
  for (const TraceHalfPlane& h : event.half_planes)
    step.table.push_back({h.solid == 0 ? "A" : "B", "f" + std::to_string(h.face),
                          (h.carrier.is_edge() ? name_of(h.carrier) + " " : "") +
                              (h.forward ? "forward" : "backward"),
                          std::string(name_of(h.before)), std::string(name_of(h.after)),
                          rule_of(record, h), h.kept ? "kept" : "dropped", h.cut ? "cut" : ""});
}

}  // namespace sectile::viewer
