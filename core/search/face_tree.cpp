#include "search/face_tree.h"

#include "parallel/parallel.h"
#include "search/face_corners.h"
#include "search/needles.h"

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
    parallel::loop(parallel::Range<std::size_t>(0, boxes.size(), 2048),
                   [&](const auto& range) { fill(range.begin(), range.end()); });
  }
  return boxes;
}

// Do the boxes of a tree's leaves cover all of it many times over, by their surfaces?
bool covers_itself(const BoxTree& tree) {
  constexpr double many_times = 4;
  const auto surface = [](const Box& b) {
    const double x = double(b.high[0]) - double(b.low[0]), y = double(b.high[1]) - double(b.low[1]),
                 z = double(b.high[2]) - double(b.low[2]);
    return x * y + y * z + z * x;
  };
  if (tree.empty()) return false;
  double sum = 0;
  for (std::uint32_t i = 0; i < tree.node_count(0); ++i) sum += surface(tree.box({0, i}));
  return sum > many_times * surface(tree.bounds());
}

}  // namespace

FaceTree::FaceTree(const Brep& brep, const Geometry& geometry, Hubs hubs, bool along_curve)
    : BoxTree(face_boxes(brep, geometry), hubs.of_face(), along_curve), hubs_(std::move(hubs)) {}

const OrientedTree* FaceTree::oriented(const Brep& brep, const Geometry& geometry) const {
  oriented_once_.run([&] {
    const auto for_each_corner = [&](std::size_t f, const auto& add) {
      for_each_in_loop(brep, brep.outer_loop[FaceId(f)],
                       [&](HalfEdgeId h) { add(geometry.position(brep.point_of(brep.from(h)))); });
    };
    if (has_slanted_needles(brep.face_count(), for_each_corner) || covers_itself(*this))
      oriented_ = std::make_unique<OrientedTree>(*this, for_each_corner);
  });
  return oriented_.get();
}

std::span<const FourFaces> FaceTree::fours(const Brep& brep, const Geometry& geometry) const {
  fours_once_.run([&] {
    if (empty()) return;
    fours_.resize(node_count(0));
    for (std::uint32_t leaf = 0; leaf < fours_.size(); ++leaf) {
      const std::span<const std::uint32_t> faces = items({0, leaf});
      for (unsigned i = 0; i < faces.size(); ++i)
        with_outer_corners(brep, geometry, FaceId(faces[i]),
                           [&](std::span<const Vec3> corners) { fours_[leaf].set(i, corners); });
    }
  });
  return fours_;
}

}  // namespace sectile
