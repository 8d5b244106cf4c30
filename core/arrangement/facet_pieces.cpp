#include "arrangement/facet_pieces.h"

#include <algorithm>

#include "arrangement/facet_tree.h"
#include "boolean/collect.h"
#include "sectile/errors.h"

namespace sectile::arrangement {
namespace {

// The ends of a face's loops, counted from its first corner.
std::vector<std::uint32_t> loop_ends_of(const Polygons& polygons, std::size_t f) {
  std::vector<std::uint32_t> ends;
  const std::uint32_t first = polygons.loop_begin(polygons.first_loop(f));
  for (std::uint32_t l = polygons.first_loop(f); l < polygons.face_end[f]; ++l)
    ends.push_back(polygons.loop_end[l] - first);
  return ends;
}

constexpr std::size_t side_by_side = 256;

}  // namespace

std::vector<std::uint32_t> hollow_facets(const Facets& facets, const Geometry& geometry) {
  struct Found {
    std::vector<std::uint32_t> faces;
    std::vector<Vec3> corners;
  };
  const Polygons& polygons = facets.polygons;
  auto found = collect<Found>(facets.face_count(), side_by_side, [&](std::size_t f, Found& out) {
    constexpr std::uint32_t few = 4;
    if (facets.size(f) <= few) return;
    out.corners.clear();
    for (const PointId p : polygons.face_corners(f)) out.corners.push_back(geometry.position(p));
    if (is_hollow(out.corners, loop_ends_of(polygons, f)))
      out.faces.push_back(static_cast<std::uint32_t>(f));
  });
  return joined<std::vector<std::uint32_t>>(
      found, [](auto& some) -> auto& { return some.faces; });
}

FacePieces facet_pieces(const Facets& facets, std::span<const std::uint32_t> hollow,
                        const Kernel& kernel) {
  const Polygons& polygons = facets.polygons;
  // The loops of a face of a soup may cross.
  const auto add_in_triangles = [&](std::uint32_t f, FacePieces& to) {
    try {
      to.add_triangles(f, kernel, facets.plane[f], polygons.face_corners(f),
                       loop_ends_of(polygons, f));
      return true;
    } catch (const InternalError&) {
      return false;
    }
  };
  const auto add_face = [&](std::size_t face, FacePieces& to) {
    const auto f = static_cast<std::uint32_t>(face);
    if (std::ranges::binary_search(hollow, f) && add_in_triangles(f, to)) return;
    std::vector<Vec3> outer;
    for_each_outer_corner(facets, f,
                          [&](PointId p) { outer.push_back(kernel.geometry().position(p)); });
    to.add(f, outer);
  };
  FacePieces all;
  for (const FacePieces& some : collect<FacePieces>(facets.face_count(), side_by_side, add_face))
    all.append(some);
  return all;
}

}  // namespace sectile::arrangement
