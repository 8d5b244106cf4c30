#include "story/null_edge_painter.h"

#include <algorithm>
#include <set>

#include "story/enlarged.h"
#include "story/wording.h"

namespace sectile::viewer {

Picture NullEdgePainter::run() {
  paint_null_edges();
  return finished();
}

// How far the ends of a null edge are drawn from their common place.
double NullEdgePainter::pull(const NullEdgeEvent& event) const {
  const double scene = record_.bounds.radius();
  const double room = event.site ? 0.5 * shortest_segment_shown(record_, event.place.number) : 0;
  return std::clamp(room, 0.02 * scene, 0.16 * scene) * (0.75 + 0.25 * view_.exploded);
}

void NullEdgePainter::add_null_edge(const TraceEvent& event, Lines& edge, Points& from,
                                    Points& to) const {
  const auto& null_edge = std::get<NullEdgeEvent>(event);
  const glm::dvec3 place =
      null_edge.site ? place_shown(record_, null_edge.place) : to_glm(null_edge.place.point);
  const double by = pull(null_edge);
  const glm::vec3 ends[2] = {glm::vec3(place + to_glm(null_edge.pulls[0]) * by),
                             glm::vec3(place + to_glm(null_edge.pulls[1]) * by)};
  edge.ends.insert(edge.ends.end(), ends, ends + 2);
  from.places.push_back(ends[0]);
  to.places.push_back(ends[1]);
}

// The neighborhoods of all places are whole.
void NullEdgePainter::paint_uncut() {
  ClassMeshes meshes;
  std::set<std::uint32_t> places;
  const double size = 0.1 * record_.bounds.radius();
  for (std::size_t i = record_.first_step[0]; i < record_.first_step[1]; ++i)
    for (const TracePlace& place : places_of(record_.event(i)))
      if (places.size() < most_fans && places.insert(place.number).second)
        add_fans(record_, place.number, size, meshes);
  paint_classes(meshes, 0.6f, true);
}

void NullEdgePainter::paint_null_edges() {
  paint_operands(true);
  if (first_ == last_) return paint_uncut();
  Lines edges = lines(theme_.null_edge, 2);
  Points from = points(theme_.null_edge_above, 6), to = points(theme_.null_edge_below, 6);
  for (std::size_t i = first_; i < done(); ++i) add_null_edge(record_.event(i), edges, from, to);
  add(edges, "null edge");
  add(from, "its end above");
  add(to, "its end below");
  if (!current()) return;
  Lines edge = lines(theme_.step, 4);
  Points one = points(theme_.null_edge_above, 9), other = points(theme_.null_edge_below, 9);
  add_null_edge(*current(), edge, one, other);
  const glm::vec3 ends[2] = {one.places.back(), other.places.back()};
  add(edge, "this step");
  add(one, "its end above");
  add(other, "its end below");
  const auto& event = std::get<NullEdgeEvent>(*current());
  name_place(glm::dvec3(0.5f * (ends[0] + ends[1])), event.solid, name_of(event.edge));
  name_place(glm::dvec3(ends[0]), event.solid, name_of(event.from));
  name_place(glm::dvec3(ends[1]), event.solid, name_of(event.to));
  const std::string note = note_on_place(record_, event.place);
  if (!note.empty())
    picture_.labels.push_back({glm::dvec3(0.5f * (ends[0] + ends[1])), note, theme_.text, true});
}

}  // namespace sectile::viewer
