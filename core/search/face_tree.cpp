#include "search/face_tree.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace sectile {

Box face_box(const Brep& brep, const Geometry& geometry, FaceId face) {
  Bounds bounds;
  // The outer loop bounds the face.
  const LoopId outer = brep.outer_loop[face.value()];
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
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, boxes.size(), 2048),
                      [&](const auto& range) { fill(range.begin(), range.end()); });
  }
  return boxes;
}

}  // namespace

FaceTree::FaceTree(const Brep& brep, const Geometry& geometry, Hubs hubs)
    : BoxTree(face_boxes(brep, geometry), hubs.of_face()), hubs_(std::move(hubs)) {}

}  // namespace sectile
