#include "arrangement/edge_lines.h"

#include "arrangement/edge_uses.h"
#include "parallel/parallel.h"
#include "sectile/errors.h"

namespace sectile::arrangement {
namespace {

class LineFinder {
 public:
  LineFinder(const Facets& facets, const Kernel& kernel) : facets_(facets), kernel_(kernel) {}

  /// The second plane stays invalid if none is known.
  EdgeLine operator()(std::span<const EdgeUse> uses) const {
    EdgeLine line;
    line.a = plane(uses[0]);
    for (std::size_t i = 1; i < uses.size() && !line.b.valid(); ++i)
      if (!kernel_.parallel(line.a, plane(uses[i]))) line.b = plane(uses[i]);
    if (!line.b.valid() && !facets_.second_plane.empty())
      line.b = facets_.second_plane[uses[0].corner];
    find_points(uses[0], line);
    return line;
  }

 private:
  PlaneId plane(const EdgeUse& use) const { return facets_.plane[facets_.face_of[use.corner]]; }

  void find_points(const EdgeUse& use, EdgeLine& line) const {
    const Geometry& g = kernel_.geometry();
    if (!g.is_constructed(use.low) && !g.is_constructed(use.high)) {
      line.from = use.low;
      line.to = use.high;
      return;
    }
    // A piece of an input edge: an end that was made by cutting it still knows the whole.
    for (const PointId p : {use.low, use.high}) {
      if (!g.is_constructed(p)) continue;
      const Construction& known = g.construction(p);
      if (!known.line_from.valid()) continue;
      if ((known.a == line.a && known.b == line.b) || (known.a == line.b && known.b == line.a)) {
        line.from = known.line_from;
        line.to = known.line_to;
      }
    }
  }

  const Facets& facets_;
  const Kernel& kernel_;
};

}  // namespace

EdgeLines::EdgeLines(const Facets& facets, const std::vector<std::uint8_t>& wanted,
                     Geometry& geometry, Kernel& kernel)
    : line_of_(facets.polygons.corners.size(), none), across_(facets.polygons.corners.size()) {
  const std::vector<EdgeUse> uses = edge_uses(facets, wanted);
  std::vector<std::size_t> first;
  for (std::size_t i = 0; i < uses.size(); ++i)
    if (i == 0 || !uses[i].has_same_ends(uses[i - 1])) first.push_back(i);
  lines_.resize(first.size());
  const LineFinder find(facets, kernel);
  const auto uses_on = [&](std::size_t i) {
    const std::size_t end = i + 1 < first.size() ? first[i + 1] : uses.size();
    return std::span(uses).subspan(first[i], end - first[i]);
  };
  parallel::loop(parallel::Range<std::size_t>(0, first.size(), 256), [&](const auto& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) {
      lines_[i] = find(uses_on(i));
      for (const EdgeUse& use : uses_on(i)) line_of_[use.corner] = static_cast<std::uint32_t>(i);
    }
  });
  for (EdgeLine& line : lines_) {
    if (line.b.valid()) continue;
    if (!line.from.valid()) throw InternalError("nothing pins down an edge between flat faces");
    line.b = geometry.add_plane(
        PlaneDefinition::along_axis(line.from, line.to, kernel.main_axis(line.a)));
  }
  kernel.refresh();
  parallel::loop(parallel::Range<std::size_t>(0, uses.size(), 256), [&](const auto& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) {
      const std::uint32_t corner = uses[i].corner;
      const EdgeLine& l = line(corner);
      across_[corner] = kernel.parallel(facets.plane[facets.face_of[corner]], l.a) ? l.b : l.a;
    }
  });
}

}  // namespace sectile::arrangement
