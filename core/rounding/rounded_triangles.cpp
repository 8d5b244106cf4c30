#include "rounding/rounded_triangles.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "numbers/disjoint_sets.h"
#include "parallel/parallel.h"
#include "storage/element_counts.h"

namespace sectile {
namespace {

std::size_t next(std::size_t k) {
  return k < 2 ? k + 1 : 0;
}

// Beyond the part an edge has no mate.
void find_mates(TriangleSurface& surface) {
  struct Edge {
    PointId low, high;
    std::uint32_t triangle, k;
    auto operator<=>(const Edge&) const = default;
  };
  std::vector<Edge> edges;
  surface.mate.resize(surface.size());
  for (std::uint32_t t = 0; t < surface.size(); ++t)
    for (std::uint32_t k = 0; k < 3; ++k) {
      const PointId p = surface.corners[t][k], q = surface.corners[t][next(k)];
      edges.push_back({std::min(p, q), std::max(p, q), t, k});
      surface.mate[t][k] = t | TriangleSurface::partial;
    }
  std::sort(edges.begin(), edges.end());
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
    const Edge &a = edges[i], &b = edges[i + 1];
    if (a.low != b.low || a.high != b.high) continue;
    surface.mate[a.triangle][a.k] = b.triangle;
    surface.mate[b.triangle][b.k] = a.triangle;
    ++i;
  }
}

bool any_slot(std::size_t) {
  return true;
}

}  // namespace

RoundedTriangles::RoundedTriangles(const SolidData& data, BlockTriangles triangles,
                                   const RoundingGrid& grid)
    : triangles_(std::move(triangles)),
      one_shell_(shell_count(data) == 1),
      positions_(triangles_.vertex_count),
      moved_at_(triangles_.vertex_count, none),
      is_changed_(size(), 0),
      bounds_(data.slots().size()) {
  round(data, grid);
}

void RoundedTriangles::round(const SolidData& data, const RoundingGrid& grid) {
  const auto slots = data.slots();
  std::vector<std::vector<Moved>> moved(slots.size());
  parallel::loop(0, slots.size(), [&](std::size_t i) {
    const auto s = static_cast<std::uint32_t>(i);
    if (slots[s].empty()) return;
    const Brep& brep = slots[s].block->brep();
    const Geometry& g = slots[s].block->geometry();
    Bounds bounds;
    for (const VertexId v : brep.vertices()) {
      const PointId p = brep.point_of(v);
      const Vec3& from = g.position(p);
      const Vec3 to = grid.nearest(from);
      bounds.add(to);
      if (!triangles_.owns(s, v)) continue;
      const std::uint32_t number = triangles_.vertex(s, v);
      positions_[number] = to;
      if (!g.is_explicit(p) || !(to == from)) moved[s].push_back({number, from, g.is_explicit(p)});
    }
    bounds_[s] = bounds.box();
  });
  for (const auto& some : moved)
    for (const Moved& m : some) {
      moved_at_[m.vertex] = static_cast<std::uint32_t>(moved_.size());
      moved_.push_back(m);
    }
  for (const std::uint32_t t : unsettled()) {
    Bounds swept;
    for (const std::uint32_t v : corners(t)) {
      swept.add(place_of(v));
      swept.add(positions_[v]);
    }
    note_swept(swept);
  }
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

// Those that are wanted, in slots that are.
template <class SlotWanted, class Wanted>
RoundedTriangles::Triangles RoundedTriangles::select(const SlotWanted& slot_wanted,
                                                     const Wanted& wanted) const {
  std::vector<Triangles> found(bounds_.size());
  parallel::loop(0, bounds_.size(), [&](std::size_t s) {
    if (!slot_wanted(s)) return;
    const std::uint32_t end = triangles_.first_triangle[s + 1];
    for (std::uint32_t t = triangles_.first_triangle[s]; t < end; ++t)
      if (wanted(t)) found[s].push_back(t);
  });
  Triangles all;
  for (const Triangles& some : found) all.insert(all.end(), some.begin(), some.end());
  return all;
}

RoundedTriangles::Triangles RoundedTriangles::unsettled() const {
  return select(any_slot, [&](std::uint32_t t) {
    const Corners c = corners(t);
    return is_changed_[t] != 0 || moved_at_[c[0]] != none || moved_at_[c[1]] != none ||
           moved_at_[c[2]] != none;
  });
}

RoundedTriangles::Triangles RoundedTriangles::around(const Triangles& triangles) const {
  std::vector<Box> boxes(triangles.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) boxes[i] = box(triangles[i]);
  const BoxTree tree(boxes);
  const auto meets = [&](const Box& own) {
    bool any = false;
    tree.query([&](const Box& b) { return !any && b.overlaps(own); },
               [&](std::uint32_t) { any = true; });
    return any;
  };
  return select([&](std::size_t s) { return meets(bounds_[s]); },
                [&](std::uint32_t t) { return meets(box(t)); });
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

void RoundedTriangles::add_vertex(MeshPart& part, std::uint32_t vertex) const {
  RoundedSurface& r = part.rounded;
  const std::uint32_t moved = moved_at_[vertex];
  part.vertex.push_back(vertex);
  r.origin.push_back(place_of(vertex));
  r.is_exact.push_back(moved == none || moved_[moved].was_exact);
  r.point.push_back(r.geometry.add_point(positions_[vertex]));
}

MeshPart RoundedTriangles::part(Triangles triangles, const Triangles& suspects) const {
  MeshPart part;
  part.triangle = std::move(triangles);
  RoundedSurface& r = part.rounded;
  std::vector<std::uint32_t> number(positions_.size(), none);
  for (std::uint32_t i = 0; i < part.triangle.size(); ++i) {
    const std::uint32_t t = part.triangle[i];
    Corners at = corners(t);
    std::array<PointId, 3> points;
    for (std::size_t k = 0; k < 3; ++k) {
      std::uint32_t& n = number[at[k]];
      if (n == none) {
        n = static_cast<std::uint32_t>(part.vertex.size());
        add_vertex(part, at[k]);
      }
      at[k] = n;
      points[k] = r.point[n];
    }
    r.corners.push_back(at);
    r.source.push_back(triangles_.source[t]);
    r.surface.corners.push_back(points);
    r.surface.plane.push_back(
        r.geometry.add_plane(PlaneDefinition::through(points[0], points[1], points[2])));
    r.surface.face.push_back(i);
    r.surface.settled.push_back(!std::binary_search(suspects.begin(), suspects.end(), t));
  }
  part.corners = r.corners;
  r.alive.assign(part.triangle.size(), 1);
  find_mates(r.surface);
  r.fixed.assign(part.vertex.size(), 0);
  for (std::size_t t = 0; t < r.corners.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      if ((r.surface.mate[t][k] & TriangleSurface::partial) != 0)
        r.fixed[r.corners[t][k]] = r.fixed[r.corners[t][next(k)]] = 1;
  return part;
}

// The places are off by half an ulp of doubles at most.
void RoundedTriangles::note_swept(const Bounds& bounds) {
  constexpr float end = std::numeric_limits<float>::infinity();
  Box box = bounds.box();
  for (int k = 0; k < 3; ++k) {
    box.low[k] = std::nextafterf(box.low[k], -end);
    box.high[k] = std::nextafterf(box.high[k], end);
  }
  swept_.push_back(box);
}

bool RoundedTriangles::shells_stay() const {
  const BoxTree tree(swept_);
  const auto stays = [&](const Box& own) {
    bool any = false;
    tree.query([&](const Box& b) { return !any && b.overlaps(own); },
               [&](std::uint32_t) { any = true; });
    return !any;
  };
  std::vector<std::uint8_t> slot_stays(bounds_.size(), 0);
  parallel::loop(0, bounds_.size(), [&](std::size_t s) {
    slot_stays[s] =
        triangles_.first_triangle[s] < triangles_.first_triangle[s + 1] && stays(bounds_[s]);
  });
  if (one_shell_ && std::find(slot_stays.begin(), slot_stays.end(), 1) != slot_stays.end())
    return true;
  DisjointSets shells(positions_.size());
  for (std::uint32_t t = 0; t < size(); ++t) {
    const Corners c = corners(t);
    shells.unite(c[0], c[1]);
    shells.unite(c[0], c[2]);
  }
  std::vector<std::uint8_t> shell_stays(positions_.size(), 0);
  for (std::uint32_t s = 0; s < bounds_.size(); ++s)
    for (std::uint32_t t = triangles_.first_triangle[s]; t < triangles_.first_triangle[s + 1];
         ++t) {
      std::uint8_t& known = shell_stays[shells.first(corners(t)[0])];
      if (known == 0) known = slot_stays[s] != 0 || stays(box(t));
    }
  for (std::uint32_t v = 0; v < positions_.size(); ++v)
    if (shells.first(v) == v && shell_stays[v] == 0) return false;
  return true;
}

RoundedTriangles::Triangles RoundedTriangles::take_back(const MeshPart& part) {
  const RoundedSurface& r = part.rounded;
  std::vector<Vec3> before;
  for (std::uint32_t i = 0; i < part.vertex.size(); ++i) {
    const std::uint32_t v = part.vertex[i];
    before.push_back(positions_[v]);
    if (r.position(i) == positions_[v]) continue;
    if (moved_at_[v] == none) {
      moved_at_[v] = static_cast<std::uint32_t>(moved_.size());
      moved_.push_back({v, r.origin[i], r.is_exact[i] != 0});
    }
    positions_[v] = r.position(i);
  }
  Triangles changed;
  for (std::size_t i = 0; i < part.triangle.size(); ++i) {
    const std::uint32_t t = part.triangle[i];
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
    note_swept(swept);
    triangles_.source[t] = r.source[i];
    is_changed_[t] = 1;
    bounds_[slot_of(t)].add(box(t));
    changed.push_back(t);
  }
  return changed;
}

void RoundedTriangles::move_into(RoundedMesh& result) {
  result.mesh.face_sizes.assign(size(), 3);
  result.mesh.positions = std::move(positions_);
  result.mesh.indices = std::move(triangles_.indices);
  result.sources = std::move(triangles_.source);
}

}  // namespace sectile
