#include "storage/block.h"

#include "numbers/disjoint_sets.h"
#include "parallel/once_alone.h"

namespace sectile {
namespace {

Pieces find_pieces(const Block& block) {
  const Brep& brep = block.brep;
  DisjointSets sets(brep.face_count());
  for (std::size_t e = block.border_count; e < brep.edge_count(); ++e)
    sets.unite(brep.face_of(Brep::half_edge(EdgeId(e), 0)).value(),
               brep.face_of(Brep::half_edge(EdgeId(e), 1)).value());
  auto [of_face, count] = std::move(sets).numbered();
  return {std::move(of_face), count};
}

}  // namespace

const FaceTree& Block::tree() const {
  // A block that has neighbours was cut from a larger structure, along a curve.
  once_alone(tree_once_,
             [this] { tree_ = std::make_unique<FaceTree>(brep, geometry, border_count > 0); });
  return *tree_;
}

const Pieces& Block::pieces() const {
  once_alone(pieces_once_, [this] { pieces_ = find_pieces(*this); });
  return pieces_;
}

const Box& Block::bounds() const {
  once_alone(bounds_once_, [this] {
    Bounds bounds;
    for (const PointId p : brep.point) bounds.add(geometry.position(p));
    bounds_ = bounds.box();
  });
  return bounds_;
}

const OrientedBox& Block::oriented_bounds() const {
  once_alone(oriented_once_, [this] {
    std::vector<Vec3> points;
    points.reserve(brep.vertex_count());
    for (const PointId p : brep.point) points.push_back(geometry.position(p));
    oriented_bounds_ = std::make_unique<OrientedBox>(points);
  });
  return *oriented_bounds_;
}

const BlockVolume& Block::volume() const {
  once_alone(volume_once_, [this] { volume_ = volume_of_faces(brep, geometry); });
  return volume_;
}

const Bounded& Block::two_areas() const {
  once_alone(area_once_, [this] { two_areas_ = two_areas_of_faces(brep, geometry); });
  return two_areas_;
}

}  // namespace sectile
