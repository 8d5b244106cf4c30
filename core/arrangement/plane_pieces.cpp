#include "arrangement/plane_pieces.h"

#include <algorithm>
#include <array>
#include <tuple>

#include "arrangement/rows_of_traces.h"
#include "numbers/threshold.h"
#include "search/edge_box.h"
#include "search/edge_fans.h"
#include "search/piece_tree.h"

namespace sectile::arrangement {

PlanePieces::PlanePieces(const Facets& facets, const EdgeLines& lines, const Traces& traces,
                         const RowLines& rows, std::span<const std::uint32_t> faces,
                         const Kernel& kernel)
    : plane_(facets.plane[faces[0]]) {
  std::vector<Piece> left;
  std::vector<PointId> ends;
  for (const std::uint32_t f : faces) {
    for (std::uint32_t c = facets.begin(f); c < facets.end(f); ++c) {
      pieces_.push_back({facets.from(c), facets.to(c), lines.across(c), c,
                         rows.of(facets.from(c), facets.to(c))});
      ends.push_back(facets.from(c));
    }
    for (const Trace& t : traces.of(f)) {
      left.push_back(
          {std::min(t.from, t.to), std::max(t.from, t.to), t.across, none, rows.of(t.from, t.to)});
      ends.insert(ends.end(), {t.from, t.to});
    }
  }
  // Several partners may leave the same trace.
  std::sort(left.begin(), left.end(), [](const Piece& a, const Piece& b) {
    return std::tie(a.from, a.to, a.across) < std::tie(b.from, b.to, b.across);
  });
  left.erase(
      std::unique(left.begin(), left.end(),
                  [](const Piece& a, const Piece& b) { return a.from == b.from && a.to == b.to; }),
      left.end());
  const std::vector<Piece> whole = take_rows(kernel, left);
  divide_rows(kernel, left);
  pieces_.insert(pieces_.end(), left.begin(), left.end());
  pieces_.insert(pieces_.end(), whole.begin(), whole.end());
  std::sort(ends.begin(), ends.end());
  std::vector<PointId> points;
  for (const std::uint32_t f : faces)
    for (const PointId p : traces.points_of(f))
      if (!std::binary_search(ends.begin(), ends.end(), p)) points.push_back(p);
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  for (const PointId p : points) pieces_.push_back({p, p, PlaneId(), none});
}

void PlanePieces::test(const Kernel& kernel, const EdgeLines& lines, std::uint32_t i,
                       std::uint32_t j) {
  const Piece &a = pieces_[i], &b = pieces_[j];
  const auto side = [&](PointId p, const Piece& line) {
    if (p == line.from || p == line.to) return Sign::zero;
    return kernel.side(p, line.across);
  };
  const bool has_length_a = a.across.valid(), has_length_b = b.across.valid();
  if (!has_length_a && !has_length_b) return;
  // What stays whole is divided by other pieces only.
  if ((a.row != none && !has_length_b) || (b.row != none && !has_length_a)) return;
  Sign a_from = Sign::zero, a_to = Sign::zero, b_from = Sign::zero, b_to = Sign::zero;
  if (has_length_b) {
    a_from = side(a.from, b);
    a_to = has_length_a ? side(a.to, b) : a_from;
    if (a_from == a_to && a_from != Sign::zero) return;
  }
  if (has_length_a) {
    b_from = side(b.from, a);
    b_to = has_length_b ? side(b.to, a) : b_from;
    if (b_from == b_to && b_from != Sign::zero) return;
  }
  if (a_from * a_to == Sign::negative && b_from * b_to == Sign::negative) {
    const auto made = static_cast<std::uint32_t>(constructions_.size());
    if (a.corner != none)
      constructions_.push_back(lines.cut(a.corner, b.across));
    else if (b.corner != none)
      constructions_.push_back(lines.cut(b.corner, a.across));
    else
      constructions_.push_back({plane_, a.across, b.across, PointId(), PointId()});
    incidences_.push_back({i, PointId(), made});
    incidences_.push_back({j, PointId(), made});
    return;
  }
  const auto add = [&](PointId p, Sign at, std::uint32_t number, const Piece& piece) {
    if (at != Sign::zero || !piece.across.valid() || p == piece.from || p == piece.to) return;
    if (kernel.is_between(piece.from, p, piece.to)) incidences_.push_back({number, p, none});
  };
  add(a.from, a_from, j, b);
  if (has_length_a) add(a.to, a_to, j, b);
  add(b.from, b_from, i, a);
  if (has_length_b) add(b.to, b_to, i, a);
}

void PlanePieces::find_crossings(const Kernel& kernel, const EdgeLines& lines) {
  const Geometry& g = kernel.geometry();
  const auto count = static_cast<std::uint32_t>(pieces_.size());
  constexpr std::uint32_t few = threshold(24, 1);
  if (count <= few) {
    std::array<Box, few> boxes;
    for (std::uint32_t i = 0; i < count; ++i)
      boxes[i] = edge_box(g, pieces_[i].from, pieces_[i].to);
    for (std::uint32_t i = 0; i < count; ++i)
      for (std::uint32_t j = i + 1; j < count; ++j)
        if (boxes[i].overlaps(boxes[j])) test(kernel, lines, i, j);
    return;
  }
  std::vector<PieceTree::Edge> edges;
  std::vector<EdgeFans::Ends> ends;
  edges.reserve(count);
  ends.reserve(count);
  for (const Piece& piece : pieces_) {
    edges.push_back({g.position(piece.from), g.position(piece.to)});
    ends.push_back({piece.from.value(), piece.to.value()});
  }
  const auto test_pair = [&](std::uint32_t i, std::uint32_t j) { test(kernel, lines, i, j); };
  const EdgeFans fans(ends);
  PieceTree(edges, fans.of_edge()).self_overlaps(test_pair);
  fans.for_each_pair([&](std::uint32_t end) { return g.position(PointId(end)); }, test_pair);
}

void PlanePieces::divide(const Kernel& kernel, std::span<const PointId> made,
                         std::span<const PointId> first_at, const Facets& facets) {
  for (Incidence& i : incidences_) {
    if (i.made != none) i.point = made[i.made];
    i.point = first_at[i.point.value()];
  }
  std::sort(incidences_.begin(), incidences_.end(), [](const Incidence& a, const Incidence& b) {
    return std::tie(a.piece, a.point) < std::tie(b.piece, b.point);
  });
  struct Part {
    PointId low, high;
    PlaneId across;
    std::uint32_t corner, row;
    bool forward;
  };
  std::vector<Part> parts;
  std::vector<PointId> stops;
  for (std::uint32_t i = 0, next = 0; i < pieces_.size(); ++i) {
    const Piece& piece = pieces_[i];
    if (!piece.across.valid()) continue;
    stops.assign(1, piece.from);
    while (next < incidences_.size() && incidences_[next].piece < i) ++next;
    for (; next < incidences_.size() && incidences_[next].piece == i; ++next) {
      const PointId p = incidences_[next].point;
      if (p != piece.from && p != piece.to && (stops.size() == 1 || p != stops.back()))
        stops.push_back(p);
    }
    if (stops.size() > 2) {
      int axis = 0;
      Sign up;
      while ((up = kernel.compare(piece.from, piece.to, axis)) == Sign::zero) ++axis;
      std::sort(stops.begin() + 1, stops.end(),
                [&](PointId p, PointId q) { return kernel.compare(p, q, axis) == up; });
    }
    stops.push_back(piece.to);
    for (std::size_t k = 0; k + 1 < stops.size(); ++k) {
      const bool forward = stops[k] < stops[k + 1];
      parts.push_back({std::min(stops[k], stops[k + 1]), std::max(stops[k], stops[k + 1]),
                       piece.across, piece.corner, piece.row, forward});
    }
  }
  std::sort(parts.begin(), parts.end(), [](const Part& a, const Part& b) {
    return std::tie(a.low, a.high, a.corner, a.across) <
           std::tie(b.low, b.high, b.corner, b.across);
  });
  for (std::size_t from = 0, to; from < parts.size(); from = to) {
    PlaneEdge edge{parts[from].low,
                   parts[from].high,
                   parts[from].across,
                   static_cast<std::uint32_t>(borders_.size()),
                   0,
                   parts[from].row};
    for (to = from; to < parts.size() && parts[to].low == edge.low && parts[to].high == edge.high;
         ++to)
      if (parts[to].corner != none)
        borders_.push_back({facets.face_of[parts[to].corner], parts[to].forward});
    edge.border_end = static_cast<std::uint32_t>(borders_.size());
    edges_.push_back(edge);
  }
}

}  // namespace sectile::arrangement
