#include "storage/block.h"

#include "parallel/once_alone.h"

namespace sectile {
namespace {

Pieces find_pieces(const Block& block) {
  constexpr std::uint32_t none = 0xFFFFFFFFu;
  const Brep& brep = block.brep;
  Pieces pieces;
  pieces.of_face.assign(brep.face_count(), none);
  std::vector<FaceId> front;
  const auto reach = [&](FaceId f) {
    if (pieces.of_face[f.value()] != none) return;
    pieces.of_face[f.value()] = pieces.count;
    front.push_back(f);
  };
  for (std::size_t f = 0; f < brep.face_count(); ++f) {
    if (pieces.of_face[f] != none) continue;
    reach(FaceId(f));
    while (!front.empty()) {
      const FaceId face = front.back();
      front.pop_back();
      for_each_in_face(brep, face, [&](HalfEdgeId h) {
        if (!block.is_border(h)) reach(brep.face_of(Brep::twin(h)));
      });
    }
    ++pieces.count;
  }
  return pieces;
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

}  // namespace sectile
