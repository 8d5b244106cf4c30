#include "search/oriented_tree.h"

namespace sectile {

OrientedTree::OrientedTree(const BoxTree& tree, const Brep& brep, const Geometry& geometry)
    : levels_(tree.level_count()) {
  std::vector<Vec3> points;
  for (std::uint32_t level = 0; level < tree.level_count(); ++level)
    for (std::uint32_t i = 0; i < tree.node_count(level); ++i) {
      points.clear();
      for (const std::uint32_t f : tree.items({level, i}))
        for_each_in_loop(brep, brep.outer_loop[FaceId(f)], [&](HalfEdgeId h) {
          points.push_back(geometry.position(brep.point_of(brep.from(h))));
        });
      levels_[level].push_back(OrientedBox(points));
    }
}

}  // namespace sectile
