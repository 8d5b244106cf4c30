#include "search/face_tree.h"

#include "parallel/parallel.h"
#include "search/approximate.h"

namespace sectile {

Box face_box(const Brep& brep, const Geometry& geometry, FaceId face) {
  Bounds bounds;
  // The outer loop bounds the face.
  const LoopId outer = brep.outer_loop[face];
  for_each_in_loop(brep, outer, [&](HalfEdgeId h) {
    bounds.add(geometry.position(brep.point_of(brep.from(h))));
  });
  return bounds.box();
}

namespace {

std::vector<Box> face_boxes(const Brep& brep, const Geometry& geometry) {
  std::vector<Box> boxes(brep.face_count());
  const auto fill = [&](std::size_t from, std::size_t to) {
    for (std::size_t f = from; f < to; ++f) boxes[f] = face_box(brep, geometry, FaceId(f));
  };
  if (boxes.size() < 4096) {
    fill(0, boxes.size());
  } else {
    parallel::loop(tbb::blocked_range<std::size_t>(0, boxes.size(), 2048),
                   [&](const auto& range) { fill(range.begin(), range.end()); });
  }
  return boxes;
}

}  // namespace

FaceTree::FaceTree(const Brep& brep, const Geometry& geometry, Hubs hubs, bool along_curve)
    : BoxTree(face_boxes(brep, geometry), hubs.of_face(), along_curve), hubs_(std::move(hubs)) {}

namespace {

// Triangles of good shape reach 8 where they lie slanted, needles their ratio of length to width.
constexpr double slanted_needle = 16;

// Is half the surface of a face's box much more than twice the area of the face?
bool is_slanted_needle(const Brep& brep, const Geometry& geometry, FaceId face) {
  using namespace approximate;
  Vec3 first, last;
  Bounds bounds;
  double area = 0;
  int corner = 0;
  for_each_in_loop(brep, brep.outer_loop[face], [&](HalfEdgeId h) {
    const Vec3& p = geometry.position(brep.point_of(brep.from(h)));
    bounds.add(p);
    if (corner == 0) first = p;
    if (corner > 1) {
      const Vec3 normal = cross(last - first, p - first);
      area += std::sqrt(dot(normal, normal));
    }
    last = p;
    ++corner;
  });
  const Vec3 size = bounds.high - bounds.low;
  return size.x * size.y + size.y * size.z + size.z * size.x > slanted_needle * area;
}

}  // namespace

const OrientedTree* FaceTree::oriented(const Brep& brep, const Geometry& geometry) const {
  oriented_once_.run([&] {
    std::size_t needles = 0;
    for (std::size_t f = 0; f < brep.face_count(); ++f)
      if (is_slanted_needle(brep, geometry, FaceId(f))) ++needles;
    if (4 * needles > brep.face_count())
      oriented_ = std::make_unique<OrientedTree>(*this, brep, geometry);
  });
  return oriented_.get();
}

}  // namespace sectile
