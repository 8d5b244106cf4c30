#include "rounding/resolved.h"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "arrangement/solids.h"

namespace sectile {
namespace {

using arrangement::Cells;
using arrangement::Counting;
using arrangement::Facets;
using arrangement::SubFaces;

// One point for each place.
std::vector<PointId> add_places(const std::vector<Vec3>& positions, Geometry& geometry) {
  std::vector<std::uint32_t> order(positions.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto key = [&](std::uint32_t v) {
    const Vec3& p = positions[v];
    return std::tuple(p.x, p.y, p.z, v);
  };
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
  std::vector<PointId> point(positions.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Vec3& p = positions[order[i]];
    point[order[i]] = i > 0 && p == positions[order[i - 1]]
                          ? point[order[i - 1]]
                          : geometry.add_point({p.x + 0.0, p.y + 0.0, p.z + 0.0});
  }
  return point;
}

bool is_flat(const Kernel& kernel, PlaneId plane) {
  for (int axis = 0; axis < 3; ++axis)
    if (kernel.normal(plane, axis) != Sign::zero) return false;
  return true;
}

Facets facets_of(const TriangleSoup& soup, Geometry& geometry, Kernel& kernel) {
  const std::vector<PointId> point = add_places(soup.positions, geometry);
  const auto corner = [&](std::size_t t, std::size_t k) { return point[soup.corners[t][k]]; };
  for (std::size_t t = 0; t < soup.corners.size(); ++t)
    geometry.add_plane(PlaneDefinition::through(corner(t, 0), corner(t, 1), corner(t, 2)));
  kernel.refresh();
  Facets facets;
  for (std::uint32_t t = 0; t < soup.corners.size(); ++t) {
    if (is_flat(kernel, PlaneId(t))) continue;
    facets.polygons.add_triangle(corner(t, 0), corner(t, 1), corner(t, 2), t);
    facets.plane.push_back(PlaneId(t));
    facets.source.push_back(soup.source[t]);
  }
  facets.operand.assign(facets.plane.size(), 0);
  facets.link();
  return facets;
}

}  // namespace

std::shared_ptr<const SolidData> resolved(const TriangleSoup& soup,
                                          const arrangement::Steering& steering) {
  Geometry geometry;
  Kernel kernel(geometry);
  const Facets facets = facets_of(soup, geometry, kernel);
  if (facets.face_count() == 0) return std::make_shared<SolidData>();
  const arrangement::FacetTree tree(facets, kernel);
  const SubFaces faces = arrangement::arrange(
      facets, tree, Counting::oriented, arrangement::Crowds::divided, geometry, kernel, steering);
  const Cells cells = arrangement::find_cells(faces, facets, tree, Counting::oriented,
                                              arrangement::InsideOut::turn, kernel, steering);
  arrangement::CellsOfSolids material{{}, 1};
  for (const arrangement::Winding& winding : cells.winding)
    material.solid.push_back(!winding.empty() && winding[0].second >= 1 ? 0 : arrangement::none);
  return arrangement::solid_of(faces, cells, facets, geometry, kernel, material,
                               arrangement::Merging::all, steering);
}

}  // namespace sectile
