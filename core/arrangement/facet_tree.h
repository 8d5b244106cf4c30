// A tree over the boxes of faces; those around one corner stay together in it.
#pragma once

#include "arrangement/facets.h"
#include "search/crossing_fans.h"
#include "search/hub_fans.h"

namespace sectile::arrangement {

/// Calls visit(PointId) for the corners of a face's outer loop.
template <class Visit>
void for_each_outer_corner(const Facets& facets, std::uint32_t face, const Visit& visit) {
  for (const PointId p : facets.polygons.loop(facets.polygons.first_loop(face))) visit(p);
}

class FacetTree : public BoxTree {
 public:
  FacetTree(const Facets& facets, const Kernel& kernel);
  /// With fans around crossings of edges, too.
  FacetTree(const Facets& facets, const Kernel& kernel, const CrossingFans& crossings);
  /// With a fan for each line along which very many edges run, whatever their ends are.
  static FacetTree along_crowded_lines(const Facets& facets, const Kernel& kernel,
                                       const CrossingFans& crossings);

  /// Of the faces: the groups of the tree.
  const HubFans& fans() const { return fans_; }

 private:
  FacetTree(const Facets& facets, const Geometry& geometry, HubFans fans);

  HubFans fans_;
};

}  // namespace sectile::arrangement
