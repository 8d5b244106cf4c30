#include "arrangement/facets.h"

#include <algorithm>
#include <utility>

#include "parallel/parallel.h"
#include "parallel/sort.h"
#include "storage/geometry_loader.h"

namespace sectile::arrangement {

void Facets::link() {
  const std::size_t count = polygons.corners.size();
  face_of.resize(count);
  next.resize(count);
  parallel::loop(parallel::Range<std::size_t>(0, face_count(), 4096), [&](const auto& range) {
    for (std::size_t f = range.begin(); f < range.end(); ++f)
      for (std::uint32_t l = polygons.first_loop(f); l < polygons.face_end[f]; ++l) {
        const std::uint32_t first = polygons.loop_begin(l), last = polygons.loop_end[l] - 1;
        for (std::uint32_t i = first; i <= last; ++i) {
          face_of[i] = static_cast<std::uint32_t>(f);
          next[i] = i < last ? i + 1 : first;
        }
      }
  });
}

void unite_places(const Kernel& kernel, std::vector<PointId> points, std::vector<PointId>& first) {
  const Geometry& g = kernel.geometry();
  for (std::size_t p = first.size(); p < g.positions.size(); ++p) first.push_back(PointId(p));
  const auto before = [&](PointId p, PointId q) {
    const Vec3 &a = g.position(p), &b = g.position(q);
    if (a.x != b.x) return a.x < b.x;
    if (a.y != b.y) return a.y < b.y;
    if (a.z != b.z) return a.z < b.z;
    return p < q;
  };
  // Most are given several times.
  std::vector<std::uint8_t> seen(g.positions.size(), 0);
  points.erase(std::remove_if(points.begin(), points.end(),
                              [&](PointId p) { return std::exchange(seen[p.value()], 1) != 0; }),
               points.end());
  parallel::sort(points.begin(), points.end(), before);
  // Only points whose rounded positions are equal may be at one place.
  std::vector<std::span<const PointId>> groups;
  for (std::size_t from = 0, to; from < points.size(); from = to) {
    for (to = from + 1; to < points.size() && g.position(points[to]) == g.position(points[from]);)
      ++to;
    if (to - from > 1) groups.push_back(std::span(points).subspan(from, to - from));
  }
  parallel::loop(parallel::Range<std::size_t>(0, groups.size(), 16), [&](const auto& range) {
    std::vector<PointId> places;
    for (std::size_t i = range.begin(); i < range.end(); ++i) {
      places.clear();
      for (const PointId p : groups[i]) {
        const auto at = std::find_if(places.begin(), places.end(),
                                     [&](PointId q) { return kernel.same_point(q, p); });
        if (at == places.end())
          places.push_back(p);
        else
          first[p.value()] = *at;
      }
    }
  });
}

namespace {

class Loader {
 public:
  Loader(Facets& facets, Geometry& geometry, const Steering& steering)
      : facets_(facets), geometry_(geometry), steering_(steering) {}

  void add(const SolidData& solid, std::uint32_t operand) {
    GeometryLoader copy(solid.geometry(), geometry_, solid.geometry().positions.size());
    const Brep& brep = solid.brep();
    for (const FaceId f : brep.faces()) {
      if (f.value() % 4096 == 0) steering_.check();
      for (LoopId l = brep.outer_loop[f]; l.valid(); l = brep.next_loop[l]) {
        for_each_in_loop(brep, l, [&](HalfEdgeId h) {
          facets_.polygons.corners.push_back(copy.point(brep.point_of(brep.from(h))));
          const PlaneId extra = brep.extra_plane(Brep::edge_of(h));
          facets_.second_plane.push_back(
              copy.plane(extra.valid() ? extra : brep.plane_of(Brep::twin(h))));
        });
        facets_.polygons.loop_end.push_back(
            static_cast<std::uint32_t>(facets_.polygons.corners.size()));
      }
      facets_.plane.push_back(copy.plane(brep.plane[f]));
      facets_.source.push_back(brep.source[f]);
      facets_.operand.push_back(operand);
      facets_.polygons.end_face(f.value());
    }
  }

 private:
  Facets& facets_;
  Geometry& geometry_;
  const Steering& steering_;
};

}  // namespace

Facets facets_of(std::span<const Solid> solids, Geometry& geometry, const Steering& steering) {
  Facets facets;
  Loader loader(facets, geometry, steering);
  for (std::size_t i = 0; i < solids.size(); ++i)
    if (!solids[i].is_empty()) loader.add(*solids[i].data(), static_cast<std::uint32_t>(i));
  const Kernel kernel(geometry);
  steering.step(0.05);
  std::vector<PointId> first;
  unite_places(kernel, facets.polygons.corners, first);
  for (PointId& p : facets.polygons.corners) p = first[p.value()];
  facets.link();
  return facets;
}

}  // namespace sectile::arrangement
