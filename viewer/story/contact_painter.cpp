#include "story/contact_painter.h"

#include <set>
#include <span>

#include "story/enlarged.h"
#include "story/wording.h"

namespace sectile::viewer {

Picture ContactPainter::run() {
  if (phase_ == Phase::reduction)
    paint_reduction();
  else if (phase_ == Phase::joining)
    paint_joining();
  else
    paint_neighborhoods();
  return finished();
}

void ContactPainter::paint_reduction() {
  paint_operands(false);
  paint_contacts(first_, done());
  if (!current()) return;
  const TraceEvent shown = enlarged(record_, *current());
  highlight(shown);
  light_names(shown, record_.main_place(shown), neighborhood_size(record_, shown));
}

void ContactPainter::paint_neighborhoods() {
  paint_operands(true);
  if (!current()) return paint_all_contacts();
  const TraceEvent event = enlarged(record_, *current());
  const std::uint32_t here = record_.main_place(event);
  Lines before = lines(theme_.contact_segment, 1.5f);
  std::set<std::uint32_t> places{here};
  ClassMeshes earlier;
  for (std::size_t i = done(); i-- > first_;) {
    const TraceEvent& other = record_.event(i);
    add_segment(before, other);
    const std::uint32_t place = record_.main_place(other);
    if (places.size() < most_fans && places.insert(place).second)
      add_fans(record_, place, 0.8 * neighborhood_size(record_, other), earlier);
  }
  add(before, "done before");
  const double size = neighborhood_size(record_, event);
  ClassMeshes meshes;
  add_fans(record_, here, size, meshes, shown_place(event, here));
  add_strips(std::get<NeighborhoodEvent>(event), 0.5 * size, 1.15 * size, meshes);
  paint_classes(earlier, 0.4f, false);
  paint_classes(meshes, 0.75f, true);
  highlight(event, 3);
  light_names(event, here, size);
  light_row(event, size);
  const std::string note = note_on_enlargement(record_, *current());
  if (!note.empty())
    picture_.labels.push_back({to_glm(places_of(event)[1].point), note, theme_.text, true});
}

void ContactPainter::paint_joining() {
  paint_operands(true);
  if (first_ == last_) return paint_all_contacts();
  Lines joined = lines(theme_.cut, 3), waiting = lines(theme_.contact_segment, 1);
  Points ends = points(theme_.null_edge, 6);
  for (std::size_t i = first_; i < last_; ++i) {
    const TraceEvent& event = record_.event(i);
    add_segment(i < done() ? joined : waiting, event);
    if (i > done() || !current())
      for (const TracePlace& p : places_of(event))
        ends.places.push_back(glm::vec3(to_glm(p.point)));
  }
  add(waiting, "to be cut");
  add(joined, "cut");
  add(ends, "null edges to be joined");
  if (!current()) return;
  const TraceEvent shown = enlarged(record_, *current());
  highlight(shown);
  name_middle(shown);
  light_row(shown, neighborhood_size(record_, shown));
}

}  // namespace sectile::viewer
