#include "rounding/rounded_triangles.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <span>

#include "geometry/axes.h"
#include "numbers/disjoint_sets.h"
#include "parallel/parallel.h"
#include "rounding/crowded_edges.h"
#include "rounding/triangle_corners.h"
#include "search/box_index.h"
#include "search/bucket_sort.h"
#include "storage/block_elements.h"

namespace sectile {
namespace {

template <class Body>
void for_each(std::size_t count, const Body& body) {
  parallel::loop(parallel::Range<std::size_t>(0, count, 4096), [&](const auto& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) body(i);
  });
}

// Beyond the part an edge has no mate.
// False if it has more than one.
bool find_mates(TriangleSurface& surface, std::size_t points) {
  struct Edge {
    PointId low, high;
    std::uint32_t triangle, k;
    auto operator<=>(const Edge&) const = default;
  };
  std::vector<Edge> edges(3 * surface.size());
  surface.mate.resize(surface.size());
  for_each(surface.size(), [&](std::size_t i) {
    const auto t = static_cast<std::uint32_t>(i);
    for (std::uint32_t k = 0; k < 3; ++k) {
      const PointId p = surface.corners[t][k], q = surface.corners[t][next_corner(k)];
      edges[3 * i + k] = {std::min(p, q), std::max(p, q), t, k};
      surface.mate[t][k] = t | TriangleSurface::partial;
    }
  });
  bucket_sort(
      edges, points, [](const Edge& e) { return e.low.value(); }, std::less<>());
  const auto same = [&](std::size_t i) {
    return i + 1 < edges.size() && edges[i].low == edges[i + 1].low &&
           edges[i].high == edges[i + 1].high;
  };
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (!same(i)) continue;
    const Edge &a = edges[i], &b = edges[i + 1];
    surface.mate[a.triangle][a.k] = b.triangle;
    surface.mate[b.triangle][b.k] = a.triangle;
    if (same(++i)) return false;
  }
  return true;
}

bool any_slot(std::size_t) {
  return true;
}

}  // namespace

RoundedTriangles::RoundedTriangles(const SolidData& data, BlockTriangles triangles,
                                   const RoundingGrid& grid)
    : data_(data),
      triangles_(std::move(triangles)),
      bounds_(data.slots().size()),
      has_unsettled_(data.slots().size(), 0) {
  parallel::invoke([&] { positions_.resize(triangles_.vertex_count); },
                   [&] { moved_at_.assign(triangles_.vertex_count, none); });
  round(grid);
}

void RoundedTriangles::round(const RoundingGrid& grid) {
  const auto slots = data_.slots();
  const bool stay = grid.has_all_doubles();  // but for what doubles cannot hold
  std::vector<std::vector<Moved>> moved(slots.size());
  parallel::loop(0, slots.size(), [&](std::size_t i) {
    const auto s = static_cast<std::uint32_t>(i);
    if (slots[s].empty()) return;
    const Block& block = *slots[s].block;
    if (stay) bounds_[s] = block.bounds();
    round(s, block, grid, moved[s]);
  });
  note_what_moved(moved);
}

void RoundedTriangles::round(std::uint32_t slot, const Block& block, const RoundingGrid& grid,
                             std::vector<Moved>& moved) {
  if (grid.has_all_doubles()) {
    triangles_.each_own_vertex(slot, block, [&](std::uint32_t v, const Vec3& from, bool is_exact) {
      positions_[v] = from;
      if (!is_exact) moved.push_back({v, from, false});
    });
    return;
  }
  Bounds bounds;
  BlockElements(block).each_vertex(
      [&](std::uint32_t, const Vec3& from, bool) { bounds.add(grid.nearest(from)); });
  bounds_[slot] = bounds.box();
  triangles_.each_own_vertex(slot, block, [&](std::uint32_t v, const Vec3& from, bool is_exact) {
    const Vec3 to = grid.nearest(from);
    positions_[v] = to;
    if (!is_exact || !(to == from)) moved.push_back({v, from, is_exact});
  });
}

void RoundedTriangles::note_what_moved(const std::vector<std::vector<Moved>>& moved) {
  for (const auto& some : moved)
    for (const Moved& m : some) {
      moved_at_[m.vertex] = static_cast<std::uint32_t>(moved_.size());
      moved_.push_back(m);
    }
  const auto& first = triangles_.first_vertex;
  parallel::loop(0, has_unsettled_.size(), [&](std::size_t s) {
    const auto of_slot = std::span(triangles_.number).subspan(first[s], first[s + 1] - first[s]);
    has_unsettled_[s] = std::any_of(of_slot.begin(), of_slot.end(),
                                    [&](std::uint32_t v) { return moved_at_[v] != none; });
  });
}

// Around a triangle and where its corners were.
Box RoundedTriangles::swept_box(std::uint32_t t) const {
  Bounds bounds;
  for (const std::uint32_t v : corners(t)) {
    bounds.add(place_of(v));
    bounds.add(positions_[v]);
  }
  return with_places(bounds);
}

double RoundedTriangles::farthest_move() const {
  double farthest = 0;
  for (const Moved& m : moved_)
    for (int k = 0; k < 3; ++k) {
      const double from = component(m.from, k), to = component(positions_[m.vertex], k);
      const double half_ulp = std::abs(from) * 0x1p-53 + std::numeric_limits<double>::denorm_min();
      farthest = std::max(farthest, std::abs(to - from) + (m.was_exact ? 0 : half_ulp));
    }
  return farthest * (1 + 0x1p-40) + std::numeric_limits<double>::denorm_min();
}

Box RoundedTriangles::box(std::uint32_t t) const {
  Bounds bounds;
  for (const std::uint32_t v : corners(t)) bounds.add(positions_[v]);
  return bounds.box();
}

std::size_t RoundedTriangles::slot_of(std::uint32_t t) const {
  const auto& first = triangles_.first_triangle;
  return static_cast<std::size_t>(std::upper_bound(first.begin(), first.end(), t) - first.begin()) -
         1;
}

RoundedTriangles::Triangles RoundedTriangles::unsettled() const {
  return select([&](std::size_t s) { return has_unsettled_[s] != 0; },
                [&](std::uint32_t t) { return is_unsettled(t); });
}

bool RoundedTriangles::is_unsettled(std::uint32_t t) const {
  const Corners c = corners(t);
  return is_changed(t) || moved_at_[c[0]] != none || moved_at_[c[1]] != none ||
         moved_at_[c[2]] != none;
}

std::vector<std::uint8_t> RoundedTriangles::marks(const Triangles& triangles) const {
  std::vector<std::uint8_t> marks(size(), 0);
  for (const std::uint32_t t : triangles) marks[t] = 1;
  return marks;
}

RoundedTriangles::Triangles RoundedTriangles::around(const Triangles& triangles) const {
  const std::vector<std::uint8_t> among = marks(triangles);
  std::vector<Box> boxes(triangles.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) boxes[i] = box(triangles[i]);
  const BoxIndex index(boxes);
  return select([&](std::size_t s) { return index.any_overlaps(bounds_[s]); },
                [&](std::uint32_t t) { return among[t] != 0 || index.any_overlaps(box(t)); });
}

RoundedTriangles::Triangles RoundedTriangles::neighbours(const Triangles& triangles,
                                                         int rings) const {
  std::vector<std::uint8_t> reached(positions_.size(), 0);
  Triangles found = triangles;
  for (int ring = 0; ring < rings; ++ring) {
    for (const std::uint32_t t : found)
      for (const std::uint32_t v : corners(t)) reached[v] = 1;
    found = select(any_slot, [&](std::uint32_t t) {
      const Corners c = corners(t);
      return (reached[c[0]] | reached[c[1]] | reached[c[2]]) != 0;
    });
  }
  return found;
}

bool RoundedTriangles::has_crowded_edges(const Triangles& among) const {
  std::vector<PlacedTriangle> placed;
  for (const std::uint32_t t : among) {
    const Corners c = corners(t);
    placed.push_back({c, {positions_[c[0]], positions_[c[1]], positions_[c[2]]}});
  }
  return have_crowded_edges(placed, farthest_move());
}

// Those of a part, in the order in which its triangles meet them.
std::vector<std::uint32_t> RoundedTriangles::number_vertices(MeshPart& part) const {
  std::vector<std::uint32_t> number(positions_.size(), none);
  for (const std::uint32_t t : part.triangle)
    for (const std::uint32_t v : corners(t)) {
      if (number[v] != none) continue;
      number[v] = static_cast<std::uint32_t>(part.vertex.size());
      part.vertex.push_back(v);
    }
  return number;
}

void RoundedTriangles::add_vertices(MeshPart& part) const {
  RoundedSurface& r = part.rounded;
  r.origin.resize(part.vertex.size());
  r.is_exact.resize(part.vertex.size());
  r.point.resize(part.vertex.size());
  for_each(part.vertex.size(), [&](std::size_t i) {
    const std::uint32_t moved = moved_at_[part.vertex[i]];
    r.origin[i] = place_of(part.vertex[i]);
    r.is_exact[i] = moved == none || moved_[moved].was_exact;
    r.point[i] = PointId(i);
  });
  r.geometry.positions.reserve(part.vertex.size());
  for (const std::uint32_t v : part.vertex) r.geometry.add_point(positions_[v]);
}

MeshPart RoundedTriangles::part(Triangles triangles, const Triangles& suspects) const {
  MeshPart part;
  part.triangle = std::move(triangles);
  const std::size_t count = part.triangle.size();
  const std::vector<std::uint32_t> number = number_vertices(part);
  add_vertices(part);
  RoundedSurface& r = part.rounded;
  r.corners.resize(count);
  r.source.resize(count);
  r.geometry.planes.resize(count);
  r.surface.corners.resize(count);
  r.surface.plane.resize(count);
  r.surface.face.resize(count);
  r.surface.settled.resize(count);
  const std::vector<std::uint8_t> is_suspect = marks(suspects);
  for_each(count, [&](std::size_t i) {
    const std::uint32_t t = part.triangle[i];
    const Corners of_mesh = corners(t);
    std::array<PointId, 3>& points = r.surface.corners[i];
    for (std::size_t k = 0; k < 3; ++k) {
      r.corners[i][k] = number[of_mesh[k]];
      points[k] = r.point[r.corners[i][k]];
    }
    r.source[i] = triangles_.source[t];
    r.surface.plane[i] = PlaneId(i);
    r.geometry.planes[PlaneId(i)] = PlaneDefinition::through(points[0], points[1], points[2]);
    r.surface.face[i] = static_cast<std::uint32_t>(i);
    r.surface.settled[i] = is_suspect[t] == 0;
  });
  part.corners = r.corners;
  r.alive.assign(count, 1);
  r.surface.along_curve = true;  // as blocks are
  part.is_manifold = find_mates(r.surface, part.vertex.size());
  r.fixed.assign(part.vertex.size(), 0);
  for (std::size_t t = 0; t < r.corners.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      if ((r.surface.mate[t][k] & TriangleSurface::partial) != 0)
        r.fixed[r.corners[t][k]] = r.fixed[r.corners[t][next_corner(k)]] = 1;
  return part;
}

// The places are off by half an ulp of doubles at most.
Box RoundedTriangles::with_places(Bounds bounds) {
  const auto ulp = [](double value) {
    return std::abs(value) * 0x1p-52 + std::numeric_limits<double>::denorm_min();
  };
  const auto [low, high] = bounds;
  bounds.low = {low.x - ulp(low.x), low.y - ulp(low.y), low.z - ulp(low.z)};
  bounds.high = {high.x + ulp(high.x), high.y + ulp(high.y), high.z + ulp(high.z)};
  return bounds.box();
}

void RoundedTriangles::note_unclear(const Triangles& unclear, const Triangles& not_looked_at) {
  if (!unclear.empty()) is_unclear_ = marks(unclear);
  swept_.resize(not_looked_at.size());
  for_each(swept_.size(), [&](std::size_t i) { swept_[i] = swept_box(not_looked_at[i]); });
}

bool RoundedTriangles::shells_stay() const {
  if (is_unclear_.empty()) return true;
  const BoxIndex index(swept_);
  const auto stays = [&](std::uint32_t t) {
    return is_unclear_[t] == 0 && !is_changed(t) && !index.any_overlaps(swept_box(t));
  };
  if (is_gone_.empty() && one_shell()) {
    for (std::uint32_t t = 0; t < size(); ++t)
      if (stays(t)) return true;
    return false;
  }
  // Vertices that others were joined to may be of several shells. Without them there may be more
  // pieces than shells, each of which needs such a triangle then.
  const std::vector<std::uint8_t> joined = joined_vertices();
  const auto first_own = [&](const Corners& c) {
    return joined[c[0]] == 0 ? c[0] : joined[c[1]] == 0 ? c[1] : c[2];
  };
  DisjointSets pieces(positions_.size());
  for (std::uint32_t t = 0; t < size(); ++t) {
    if (is_gone(t)) continue;
    const Corners c = corners(t);
    for (const std::uint32_t v : c)
      if (joined[v] == 0) pieces.unite(first_own(c), v);
  }
  enum : std::uint8_t { not_there, unknown, known_to_stay };
  std::vector<std::uint8_t> piece_is(positions_.size(), not_there);
  for (std::uint32_t t = 0; t < size(); ++t) {
    if (is_gone(t)) continue;
    const std::uint32_t own = first_own(corners(t));
    if (joined[own] != 0) return false;  // all of its corners are
    std::uint8_t& piece = piece_is[pieces.first(own)];
    if (piece != known_to_stay) piece = stays(t) ? known_to_stay : unknown;
  }
  return std::find(piece_is.begin(), piece_is.end(), unknown) == piece_is.end();
}

std::vector<std::uint8_t> RoundedTriangles::joined_vertices() const {
  std::vector<std::uint8_t> joined(positions_.size(), 0);
  for (const std::uint32_t into : gone_to_)
    if (into != none) joined[into] = 1;
  return joined;
}

void RoundedTriangles::note_moved(std::uint32_t vertex, const Vec3& from, bool was_exact) {
  if (moved_at_[vertex] != none) return;
  moved_at_[vertex] = static_cast<std::uint32_t>(moved_.size());
  moved_.push_back({vertex, from, was_exact});
}

RoundedTriangles::Triangles RoundedTriangles::take_back(const MeshPart& part,
                                                        const std::vector<std::uint32_t>& gone_to) {
  const RoundedSurface& r = part.rounded;
  std::vector<Vec3> before;
  for (std::uint32_t i = 0; i < part.vertex.size(); ++i) {
    const std::uint32_t v = part.vertex[i];
    before.push_back(positions_[v]);
    if (gone_to[i] != i) {
      gone_to_.resize(positions_.size(), none);
      gone_to_[v] = part.vertex[gone_to[i]];
    }
    if (gone_to[i] != i || !(r.position(i) == positions_[v]))
      note_moved(v, r.origin[i], r.is_exact[i] != 0);
    positions_[v] = r.position(i);
  }
  Triangles changed;
  for (std::size_t i = 0; i < part.triangle.size(); ++i) {
    const std::uint32_t t = part.triangle[i];
    if (r.alive[i] == 0) {
      is_gone_.resize(size(), 0);
      is_gone_[t] = 1;
      Bounds swept;
      for (const std::uint32_t v : part.corners[i]) {
        swept.add(before[v]);
        swept.add(r.position(gone_to[v]));
      }
      swept_.push_back(with_places(swept));
      continue;
    }
    const Corners was = part.corners[i], is = r.corners[i];
    const auto moves = [&](std::uint32_t v) { return !(r.position(v) == before[v]); };
    if (was == is && std::none_of(is.begin(), is.end(), moves)) continue;
    Bounds swept;
    for (std::size_t k = 0; k < 3; ++k) {
      triangles_.indices[3 * std::size_t(t) + k] = part.vertex[is[k]];
      swept.add(before[was[k]]);
      swept.add(before[is[k]]);
      swept.add(r.position(was[k]));
      swept.add(r.position(is[k]));
    }
    swept_.push_back(with_places(swept));
    triangles_.source[t] = r.source[i];
    is_changed_.resize(size(), 0);
    is_changed_[t] = 1;
    const std::size_t slot = slot_of(t);
    has_unsettled_[slot] = 1;
    bounds_[slot].add(box(t));
    changed.push_back(t);
  }
  return changed;
}

// Triangles, and vertices of which no triangle is left.
void RoundedTriangles::drop_what_is_gone() {
  std::vector<std::uint32_t> number(positions_.size(), none);
  std::vector<Vec3> positions;
  std::size_t kept = 0;
  for (std::uint32_t t = 0; t < size(); ++t) {
    if (is_gone(t)) continue;
    const Corners at = corners(t);
    for (std::size_t k = 0; k < 3; ++k) {
      std::uint32_t& n = number[at[k]];
      if (n == none) {
        n = static_cast<std::uint32_t>(positions.size());
        positions.push_back(positions_[at[k]]);
      }
      triangles_.indices[3 * kept + k] = n;
    }
    triangles_.source[kept++] = triangles_.source[t];
  }
  positions_ = std::move(positions);
  triangles_.indices.resize(3 * kept);
  triangles_.source.resize(kept);
}

void RoundedTriangles::move_into(RoundedMesh& result) {
  if (!is_gone_.empty()) drop_what_is_gone();
  result.mesh.face_sizes.assign(size(), 3);
  result.mesh.positions = std::move(positions_);
  result.mesh.indices = std::move(triangles_.indices);
  result.sources = std::move(triangles_.source);
}

}  // namespace sectile
