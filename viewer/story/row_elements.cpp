#include "story/row_elements.h"

namespace sectile::viewer {
namespace {

std::string face_name(int solid, std::uint32_t face) {
  return (solid == 0 ? "A f" : "B f") + std::to_string(face);
}

RowElement of(const TraceHalfPlane& h) {
  return {h.solid, face_name(h.solid, h.face), h.before, nullptr, &h};
}

// The rows of a cut are those half-planes around its segment that its carrier has.
const TraceHalfPlane* half_plane_of_cut(const CutEvent& cut, const NeighborhoodEvent& around,
                                        std::size_t row) {
  for (const TraceHalfPlane& h : around.half_planes)
    if (h.solid == cut.solid && h.carrier == cut.carrier && row-- == 0) return &h;
  return nullptr;
}

}  // namespace

std::optional<RowElement> element_of_row(const StoryRecord& record, std::size_t step,
                                         std::size_t row) {
  const TraceEvent& event = record.event(step);
  if (const auto* contact = std::get_if<ContactEvent>(&event)) {
    if (row >= contact->sectors.size()) return std::nullopt;
    const TraceSector& s = contact->sectors[row];
    return RowElement{s.solid, face_name(s.solid, s.face), std::nullopt, &s, nullptr};
  }
  const auto half_plane_in = [&](const NeighborhoodEvent& around) -> std::optional<RowElement> {
    if (row >= around.half_planes.size()) return std::nullopt;
    return of(around.half_planes[row]);
  };
  if (const auto* here = std::get_if<NeighborhoodEvent>(&event)) return half_plane_in(*here);
  if (const auto* wedge = std::get_if<WedgeEvent>(&event)) {
    const NeighborhoodEvent* around = record.neighborhood(wedge->ends);
    return around ? half_plane_in(*around) : std::nullopt;
  }
  if (const auto* cut = std::get_if<CutEvent>(&event)) {
    const NeighborhoodEvent* around = record.neighborhood(cut->ends);
    const TraceHalfPlane* h = around ? half_plane_of_cut(*cut, *around, row) : nullptr;
    if (h) return of(*h);
  }
  return std::nullopt;
}

}  // namespace sectile::viewer
