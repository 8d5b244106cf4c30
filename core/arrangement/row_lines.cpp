#include "arrangement/row_lines.h"

#include <algorithm>
#include <utility>

#include "numbers/disjoint_sets.h"
#include "search/piece_tree.h"

namespace sectile::arrangement {
namespace {

struct Segment {
  PointId from, to;
  friend auto operator<=>(const Segment&, const Segment&) = default;
};

// The lines, then the edges of faces, then the traces.
std::vector<Segment> all_segments(const Facets& facets, const Traces& traces,
                                  std::span<const PointPair> lines) {
  std::vector<Segment> segments;
  for (const PointPair& line : lines) segments.push_back({PointId(line.from), PointId(line.to)});
  const auto add = [&](PointId p, PointId q) {
    segments.push_back({std::min(p, q), std::max(p, q)});
  };
  for (std::uint32_t c = 0; c < facets.polygons.corners.size(); ++c)
    add(facets.from(c), facets.to(c));
  for (const Trace& t : traces.traces) add(t.from, t.to);
  const auto first = segments.begin() + static_cast<std::ptrdiff_t>(lines.size());
  std::sort(first, segments.end());
  segments.erase(std::unique(first, segments.end()), segments.end());
  return segments;
}

// What overlaps a line makes it longer, and then more may overlap it.
class LineGrower {
 public:
  LineGrower(std::vector<Segment> segments, std::size_t lines, const Kernel& kernel)
      : segments_(std::move(segments)), kernel_(kernel), same_(lines) {
    for (std::uint32_t line = 0; line < lines; ++line) {
      axis_.push_back(axis_of(segments_[line]));
      grown_.push_back(along(line, segments_[line]));
      added_.push_back({line, grown_.back()});
    }
  }

  std::vector<RowLines::On> run() {
    const PieceTree tree(pieces_of(segments_));
    while (!added_.empty()) {
      const std::vector<Part> parts = std::exchange(added_, {});
      std::vector<Segment> pieces;
      for (const Part& part : parts) pieces.push_back(part.segment);
      PieceTree::overlaps(tree, PieceTree(pieces_of(pieces)),
                          [&](std::uint32_t i, std::uint32_t k) { visit(i, parts[k]); });
    }
    for (RowLines::On& on : on_) on.line = same_.first(on.line);
    std::sort(on_.begin(), on_.end());
    on_.erase(std::unique(on_.begin(), on_.end()), on_.end());
    return std::move(on_);
  }

 private:
  struct Part {
    std::uint32_t line;
    Segment segment;  // along the line
  };

  std::vector<PieceTree::Edge> pieces_of(const std::vector<Segment>& segments) const {
    const Geometry& g = kernel_.geometry();
    std::vector<PieceTree::Edge> pieces;
    pieces.reserve(segments.size());
    for (const Segment& s : segments) pieces.push_back({g.position(s.from), g.position(s.to)});
    return pieces;
  }

  int axis_of(const Segment& s) const {
    int axis = 0;
    while (kernel_.compare(s.from, s.to, axis) == Sign::zero) ++axis;
    return axis;
  }
  bool before(std::uint32_t line, PointId p, PointId q) const {
    return kernel_.compare(p, q, axis_[line]) == Sign::positive;
  }
  Segment along(std::uint32_t line, const Segment& s) const {
    return before(line, s.from, s.to) ? s : Segment{s.to, s.from};
  }
  bool is_on(std::uint32_t line, PointId p) const {
    const Segment& first = segments_[line];
    return p == first.from || p == first.to || are_on_one_line(kernel_, first.from, first.to, p);
  }

  void visit(std::uint32_t i, const Part& part) {
    const std::uint32_t line = part.line;
    if (!is_on(line, segments_[i].from) || !is_on(line, segments_[i].to)) return;
    const Segment s = along(line, segments_[i]);
    if (!before(line, s.from, part.segment.to) || !before(line, part.segment.from, s.to)) return;
    if (i < same_.size()) same_.unite(i, line);
    on_.push_back({s.from, line});
    on_.push_back({s.to, line});
    grow(line, s);
  }

  void grow(std::uint32_t line, const Segment& s) {
    Segment& all = grown_[line];
    if (before(line, s.from, all.from)) {
      added_.push_back({line, {s.from, all.from}});
      all.from = s.from;
    }
    if (before(line, all.to, s.to)) {
      added_.push_back({line, {all.to, s.to}});
      all.to = s.to;
    }
  }

  const std::vector<Segment> segments_;
  const Kernel& kernel_;
  DisjointSets same_;
  std::vector<int> axis_;       // per line: one on which it has an extent
  std::vector<Segment> grown_;  // per line: from end to end
  std::vector<Part> added_;     // of lines: what overlaps them is still to be found
  std::vector<RowLines::On> on_;
};

}  // namespace

RowLines::RowLines(const Facets& facets, const Traces& traces, std::span<const PointPair> lines,
                   const Kernel& kernel) {
  if (!lines.empty())
    on_ = LineGrower(all_segments(facets, traces, lines), lines.size(), kernel).run();
}

std::uint32_t RowLines::line_through(PointId p, PointId q) const {
  const auto of_p = lines_of(p), of_q = lines_of(q);
  for (const On& on : of_p)
    for (const On& other : of_q)
      if (on.line == other.line) return on.line;
  return none;
}

std::span<const RowLines::On> RowLines::lines_of(PointId p) const {
  const auto from = std::ranges::lower_bound(on_, p, {}, &On::point),
             to = std::ranges::upper_bound(on_, p, {}, &On::point);
  return {from, to};
}

}  // namespace sectile::arrangement
