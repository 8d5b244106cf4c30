// Oriented boxes for the nodes of a box tree over faces: where faces are long, thin and slanted,
// axis-parallel boxes say little.
#pragma once

#include <vector>

#include "geometry/geometry.h"
#include "search/box_tree.h"
#include "search/oriented_box.h"
#include "topology/brep.h"

namespace sectile {

class OrientedTree {
 public:
  OrientedTree(const BoxTree& tree, const Brep& brep, const Geometry& geometry);
  const OrientedBox& operator[](BoxTree::Node n) const { return levels_[n.level][n.index]; }

 private:
  std::vector<std::vector<OrientedBox>> levels_;
};

}  // namespace sectile
