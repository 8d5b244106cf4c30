#include "story/story_pictures.h"

#include <span>

#include "story/contact_painter.h"
#include "story/enlarged.h"
#include "story/null_edge_painter.h"
#include "story/parts_painter.h"

namespace sectile::viewer {
namespace {

Picture draw(const StoryRecord& record, Phase phase, std::size_t step, const StoryView& view) {
  switch (phase) {
    case Phase::reduction:
    case Phase::vertex_face:
    case Phase::vertex_vertex:
    case Phase::joining:
      return ContactPainter(record, phase, step, view).run();
    case Phase::null_edges:
      return NullEdgePainter(record, phase, step, view).run();
    case Phase::components:
    case Phase::gluing:
    case Phase::cleanup:
      break;
  }
  return PartsPainter(record, phase, step, view).run();
}

}  // namespace

Picture draw_step(const StoryRecord& record, std::size_t step, const StoryView& view) {
  return draw(record, record.steps.at(step).phase, step, view);
}

Picture draw_phase(const StoryRecord& record, Phase phase, const StoryView& view) {
  return draw(record, phase, StoryCanvas::no_step, view);
}

Bounds place_of_step(const StoryRecord& record, std::size_t step) {
  const TraceEvent event = enlarged(record, record.events[record.steps.at(step).event]);
  const std::span<const TracePlace> places = places_of(event);
  if (places.empty()) return record.bounds;
  Bounds bounds;
  for (const TracePlace& p : places) bounds.add(to_glm(p.point));
  const double room = 2 * neighborhood_size(record, event);
  bounds.add(bounds.low - room);
  bounds.add(bounds.high + room);
  return bounds;
}

}  // namespace sectile::viewer
