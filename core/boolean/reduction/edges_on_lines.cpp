#include "boolean/reduction/edges_on_lines.h"

#include "search/edges_by_line.h"

namespace sectile {

// One end is between the ends of what is known of a line, and so its mark tells that line, but for
// what joins two crowds.
std::optional<std::uint32_t> EdgesOnLines::line_of(EdgeId edge) const {
  const HalfEdgeId h = Brep::half_edge(edge);
  const std::uint32_t from = patch_.on_crowded_line[patch_.brep.from(h)],
                      to = patch_.on_crowded_line[patch_.brep.to(h)];
  for (const std::uint32_t mark : {from, to})
    if (mark != 0 && mark != Patch::several && is_on(mark - 1, edge)) return mark - 1;
  if (from != Patch::several || to != Patch::several) return {};
  for (std::uint32_t line = 0; line < w_.crowded_lines.size(); ++line)
    if (is_on(line, edge)) return line;
  return {};
}

bool EdgesOnLines::is_on(std::uint32_t line, EdgeId edge) const {
  const auto& [p, q] = w_.crowded_lines[line];
  const HalfEdgeId h = Brep::half_edge(edge);
  return are_on_one_line(w_.tests(), p, q, patch_.brep.point_of(patch_.brep.from(h))) &&
         are_on_one_line(w_.tests(), p, q, patch_.brep.point_of(patch_.brep.to(h)));
}

}  // namespace sectile
