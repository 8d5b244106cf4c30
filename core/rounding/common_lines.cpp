#include "rounding/common_lines.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>
#include <vector>

#include "parallel/parallel.h"
#include "rounding/triangle_corners.h"
#include "search/box_index.h"
#include "search/edges_by_line.h"
#include "search/piece_tree.h"
#include "search/places_on_line.h"
#include "sectile/errors.h"

namespace sectile {
namespace {

class CornersOnEdges {
 public:
  CornersOnEdges(const TriangleSurface& surface, const Kernel& kernel,
                 const std::function<bool(PointId)>& moves)
      : kernel_(kernel) {
    collect(surface, moves);
    keep_those_near_each_other();
  }

  std::vector<CornerOnEdge> run() const {
    std::vector<CornerOnEdge> on = on_edges();
    std::ranges::sort(on);
    return on;
  }

 private:
  const Vec3& at(std::uint32_t point) const { return kernel_.geometry().position(PointId(point)); }
  bool moves(std::uint32_t point) const { return moves_[point] != 0; }
  bool moves(const PointPair& edge) const { return moves(edge.from) || moves(edge.to); }

  Box box(std::uint32_t point) const { return box_around(at(point), at(point)); }
  Box box(const PointPair& edge) const { return box_around(at(edge.from), at(edge.to)); }

  void collect(const TriangleSurface& surface, const std::function<bool(PointId)>& moves) {
    std::vector<std::uint8_t> is_corner(kernel_.geometry().positions.size(), 0);
    for (const auto& corners : surface.corners)
      for (std::size_t k = 0; k < 3; ++k) {
        const PointId p = corners[k], q = corners[next_corner(k)];
        is_corner[p.value()] = 1;
        if (p < q) edges_.push_back({p.value(), q.value()});
      }
    moves_.assign(is_corner.size(), 0);
    for (std::uint32_t p = 0; p < is_corner.size(); ++p) {
      if (is_corner[p] == 0) continue;
      points_.push_back(p);
      moves_[p] = moves(PointId(p));
    }
  }

  // Most of what does not move meets nothing that does.
  void keep_those_near_each_other() {
    std::vector<Box> edges, points;
    for (const PointPair& e : edges_)
      if (moves(e)) edges.push_back(box(e));
    for (const std::uint32_t p : points_)
      if (moves(p)) points.push_back(box(p));
    const BoxIndex moving_edges(edges), moving_points(points);
    keep_near(edges_, moving_points);
    keep_near(points_, moving_edges);
    std::ranges::sort(edges_);
    edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
  }
  template <class T>
  void keep_near(std::vector<T>& all, const BoxIndex& moving) const {
    std::vector<std::uint8_t> is_near(all.size());
    parallel::loop(parallel::Range<std::size_t>(0, all.size(), 4096), [&](const auto& range) {
      for (std::size_t i = range.begin(); i < range.end(); ++i)
        is_near[i] = moves(all[i]) || moving.any_overlaps(box(all[i]));
    });
    std::size_t kept = 0;
    for (std::size_t i = 0; i < all.size(); ++i)
      if (is_near[i] != 0) all[kept++] = all[i];
    all.resize(kept);
  }

  std::vector<CornerOnEdge> on_edges() const {
    std::vector<PieceTree::Edge> edges, places;
    for (const PointPair& e : edges_) edges.push_back({at(e.from), at(e.to)});
    for (const std::uint32_t p : points_) places.push_back({at(p), at(p)});
    std::vector<CornerOnEdge> on;
    PieceTree::overlaps(PieceTree(edges), PieceTree(places), [&](std::uint32_t i, std::uint32_t j) {
      const PointPair& edge = edges_[i];
      const PointId p(points_[j]);
      if (is_within_edge(kernel_, p, PointId(edge.from), PointId(edge.to))) on.push_back({edge, p});
    });
    return on;
  }

  const Kernel& kernel_;
  std::vector<std::uint32_t> points_;  // numbers in the geometry
  std::vector<PointPair> edges_;       // of such
  std::vector<std::uint8_t> moves_;    // per point of the geometry
};

// Where edges are to be divided.
class DividedEdges {
 public:
  DividedEdges(const Kernel& kernel, std::span<const CornerOnEdge> on,
               const std::function<bool(PointId)>& moves)
      : kernel_(kernel), moves_(moves) {
    for (std::size_t begin = 0, end; begin < on.size(); begin = end) {
      for (end = begin; end < on.size() && on[end].edge == on[begin].edge;) ++end;
      divide(on[begin].edge, on.subspan(begin, end - begin));
    }
  }

  bool empty() const { return divided_.empty(); }
  /// The points in which an edge is divided, in their order. Nothing if it stays whole.
  std::vector<PointId> between(PointId from, PointId to) const {
    const PointPair edge = PointPair::between(from.value(), to.value());
    const auto at = std::ranges::lower_bound(divided_, edge, {}, &Divided::edge);
    if (at == divided_.end() || at->edge != edge) return {};
    std::vector<PointId> points = at->points;
    if (edge.from != from.value()) std::ranges::reverse(points);
    return points;
  }

 private:
  struct Divided {
    PointPair edge;  // numbers of points of the geometry
    std::vector<PointId> points;
  };

  void divide(const PointPair& edge, std::span<const CornerOnEdge> on) {
    std::vector<PointId> points{PointId(edge.from), PointId(edge.to)};
    for (const auto& [same_edge, p] : on) points.push_back(p);
    if (std::ranges::none_of(points, moves_)) return;
    const PlacesOnLine places(kernel_, points);
    std::vector<PointId> between;
    for (std::size_t i = 1; i + 1 < places.count(); ++i) between.push_back(places.at(i));
    if (places.of(PointId(edge.from)) > 0) std::ranges::reverse(between);
    divided_.push_back({edge, std::move(between)});
  }

  const Kernel& kernel_;
  const std::function<bool(PointId)>& moves_;
  std::vector<Divided> divided_;  // by edge
};

// The surface anew, triangle by triangle.
class Divider {
 public:
  Divider(const TriangleSurface& surface, const DividedEdges& edges)
      : old_(surface), edges_(edges), pieces_(surface.size()) {}

  TriangleSurface run() {
    result_.doubtful = old_.doubtful;
    for (std::uint32_t t = 0; t < old_.size(); ++t) add(t);
    for (std::uint32_t t = 0; t < old_.size(); ++t)
      for (std::size_t k = 0; k < 3; ++k) link_to_neighbour(t, k);
    return std::move(result_);
  }

 private:
  struct Piece {
    std::uint32_t triangle;
    std::size_t k;
  };
  using Pieces = std::vector<Piece>;

  std::uint32_t add(std::uint32_t t, PointId a, PointId b, PointId c) {
    result_.corners.push_back({a, b, c});
    result_.plane.push_back(old_.plane[t]);
    result_.face.push_back(old_.face[t]);
    result_.mate.push_back({});
    return static_cast<std::uint32_t>(result_.size() - 1);
  }
  void link(const Piece& p, const Piece& q) {
    result_.mate[p.triangle][p.k] = q.triangle;
    result_.mate[q.triangle][q.k] = p.triangle;
  }

  // Triangles from the apex to each part of a chain; these pieces are returned. `last` leads from
  // the chain's end to the apex, `first` from the apex to its beginning.
  Pieces fan(std::uint32_t t, PointId from, std::span<const PointId> between, PointId to,
             PointId apex, Piece& last, Piece& first) {
    Pieces parts;
    for (std::size_t i = 0; i <= between.size(); ++i) {
      const std::uint32_t added =
          add(t, i == 0 ? from : between[i - 1], i == between.size() ? to : between[i], apex);
      if (i == 0) first = {added, 2};
      if (i > 0) link({added - 1, 1}, {added, 2});
      parts.push_back({added, 0});
    }
    last = {parts.back().triangle, 1};
    return parts;
  }

  // Side k is divided, if any is.
  void add(std::uint32_t t) {
    const auto& corners = old_.corners[t];
    std::array<std::vector<PointId>, 3> between;
    for (std::size_t k = 0; k < 3; ++k)
      between[k] = edges_.between(corners[k], corners[next_corner(k)]);
    const std::size_t k = !between[0].empty()   ? 0
                          : !between[1].empty() ? 1
                                                : 2,
                      l = next_corner(k), m = previous_corner(k);
    std::array<Pieces, 3>& sides = pieces_[t];
    if (between[k].empty()) {
      const std::uint32_t added = add(t, corners[0], corners[1], corners[2]);
      for (std::size_t i = 0; i < 3; ++i) sides[i] = {{added, i}};
      return;
    }
    add_divided(t, {corners[k], corners[l], corners[m]}, {between[k], between[l], between[m]},
                {&sides[k], &sides[l], &sides[m]});
  }

  // The first side is divided. What is around its ends takes the other two.
  void add_divided(std::uint32_t t, const std::array<PointId, 3>& corner,
                   const std::array<std::span<const PointId>, 3>& between,
                   const std::array<Pieces*, 3>& sides) {
    const auto [a, b, c] = corner;
    const PointId first_between = between[0].front(), last_between = between[0].back();
    Piece last, first;
    *sides[2] = fan(t, c, between[2], a, first_between, last, first);
    Pieces& along = *sides[0];
    along = {last};
    Piece inner = first;  // from first_between to c
    if (between[0].size() > 1) {
      const Pieces middle = fan(t, first_between, between[0].subspan(1, between[0].size() - 2),
                                last_between, c, last, first);
      link(inner, first);
      inner = last;  // from last_between to c
      along.insert(along.end(), middle.begin(), middle.end());
    }
    *sides[1] = fan(t, b, between[1], c, last_between, last, first);
    link(inner, last);
    along.push_back(first);
  }

  void link_to_neighbour(std::uint32_t t, std::size_t k) {
    const std::uint32_t s = old_.mate[t][k];
    if (s < t) return;
    const PointId from = old_.corners[t][k], to = old_.corners[t][next_corner(k)];
    for (std::size_t j = 0; j < 3; ++j) {
      if (old_.mate[s][j] != t || old_.corners[s][j] != to ||
          old_.corners[s][next_corner(j)] != from)
        continue;
      const Pieces &mine = pieces_[t][k], &others = pieces_[s][j];
      for (std::size_t i = 0; i < mine.size(); ++i) link(mine[i], others[others.size() - 1 - i]);
      return;
    }
    throw InternalError("the triangles of a solid do not fit together");
  }

  const TriangleSurface& old_;
  const DividedEdges& edges_;
  std::vector<std::array<Pieces, 3>> pieces_;  // per old triangle, of its sides in their order
  TriangleSurface result_;
};

}  // namespace

std::vector<CornerOnEdge> corners_on_edges(const TriangleSurface& surface, const Kernel& kernel,
                                           const std::function<bool(PointId)>& moves) {
  return CornersOnEdges(surface, kernel, moves).run();
}

void divide_on_common_lines(TriangleSurface& surface, const Kernel& kernel,
                            const std::function<bool(PointId)>& moves) {
  divide_on_common_lines(surface, kernel, moves, corners_on_edges(surface, kernel, moves));
}

void divide_on_common_lines(TriangleSurface& surface, const Kernel& kernel,
                            const std::function<bool(PointId)>& moves,
                            std::span<const CornerOnEdge> on_edges) {
  const DividedEdges edges(kernel, on_edges, moves);
  if (!edges.empty()) surface = Divider(surface, edges).run();
}

}  // namespace sectile
