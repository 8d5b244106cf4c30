#include "arrangement/facet_tree.h"

#include <numeric>

#include "parallel/parallel.h"

namespace sectile::arrangement {
namespace {

enum class Lines { between_hubs, crowded };

HubFans fans_of(const Facets& facets, const Kernel& kernel, Lines lines,
                const CrossingFans& crossings) {
  std::vector<std::uint32_t> all(facets.face_count());
  std::iota(all.begin(), all.end(), 0u);
  const auto for_each_corner = [&](std::uint32_t f, const auto& visit) {
    for_each_outer_corner(facets, f, visit);
  };
  HubFans fans(all, all.size(), kernel.geometry().positions.size(), for_each_corner);
  if (lines == Lines::between_hubs)
    fans.join_along_spines(all, kernel, for_each_corner);
  else
    fans.join_along_crowded_lines(all, kernel, for_each_corner);
  fans.join_around_crossings(all, crossings);
  return fans;
}

std::vector<Box> boxes_of(const Facets& facets, const Geometry& geometry) {
  std::vector<Box> boxes(facets.face_count());
  parallel::loop(parallel::Range<std::size_t>(0, boxes.size(), 2048), [&](const auto& range) {
    for (std::size_t f = range.begin(); f < range.end(); ++f) {
      Bounds bounds;
      for_each_outer_corner(facets, static_cast<std::uint32_t>(f),
                            [&](PointId p) { bounds.add(geometry.position(p)); });
      boxes[f] = bounds.box();
    }
  });
  return boxes;
}

}  // namespace

FacetTree::FacetTree(const Facets& facets, const Kernel& kernel)
    : FacetTree(facets, kernel, CrossingFans()) {}

FacetTree::FacetTree(const Facets& facets, const Kernel& kernel, const CrossingFans& crossings)
    : FacetTree(facets, kernel.geometry(),
                fans_of(facets, kernel, Lines::between_hubs, crossings)) {}

FacetTree FacetTree::along_crowded_lines(const Facets& facets, const Kernel& kernel,
                                         const CrossingFans& crossings) {
  return {facets, kernel.geometry(), fans_of(facets, kernel, Lines::crowded, crossings)};
}

FacetTree::FacetTree(const Facets& facets, const Geometry& geometry, HubFans fans)
    : BoxTree(boxes_of(facets, geometry), fans.of_polygon()), fans_(std::move(fans)) {}

}  // namespace sectile::arrangement
