#include "search/face_pieces.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "geometry/face_predicates.h"
#include "geometry/triangulation.h"
#include "search/approximate.h"
#include "search/bundle_order.h"

namespace sectile {

using namespace approximate;

bool is_hollow(std::span<const Vec3> corners, std::span<const std::uint32_t> loop_ends) {
  constexpr std::size_t few = 4;
  if (corners.size() <= few) return false;
  Bounds bounds;
  Vec3 two_areas;
  std::size_t first = 0;
  for (const std::uint32_t end : loop_ends) {
    Vec3 last = corners[first];
    for (std::size_t i = first; i < end; ++i) {
      bounds.add(corners[i]);
      const Vec3 at = corners[i] - corners[first];
      two_areas = two_areas + cross(last, at);
      last = at;
    }
    first = end;
  }
  const Vec3 size = bounds.high - bounds.low;
  const double x = std::abs(two_areas.x), y = std::abs(two_areas.y), z = std::abs(two_areas.z);
  if (z >= x && z >= y) return z < size.x * size.y;
  return x >= y ? x < size.y * size.z : y < size.z * size.x;
}

void FacePieces::add(std::uint32_t face, std::span<const Vec3> corners) {
  face_.push_back(face);
  corners_.insert(corners_.end(), corners.begin(), corners.end());
  end_.push_back(static_cast<std::uint32_t>(corners_.size()));
}

void FacePieces::add_triangles(std::uint32_t face, const Kernel& kernel, PlaneId plane,
                               std::span<const PointId> corners,
                               std::span<const std::uint32_t> loop_ends) {
  const int axis = kernel.main_axis(plane);
  const FacePredicates exact(kernel, axis, kernel.normal(plane, axis) == Sign::negative, corners);
  std::vector<std::array<std::uint32_t, 3>> triangles;
  triangulate_in_shape(exact, loop_ends, triangles);
  for (const auto& [i, j, k] : triangles) {
    const auto at = [&](std::uint32_t c) { return kernel.geometry().position(corners[c]); };
    const Vec3 places[] = {at(i), at(j), at(k)};
    add(face, places);
  }
}

void FacePieces::append(const FacePieces& others) {
  const auto first = static_cast<std::uint32_t>(corners_.size());
  face_.insert(face_.end(), others.face_.begin(), others.face_.end());
  corners_.insert(corners_.end(), others.corners_.begin(), others.corners_.end());
  for (const std::uint32_t end : others.end_) end_.push_back(first + end);
}

namespace {

std::vector<Box> boxes_of(const FacePieces& pieces) {
  std::vector<Box> boxes;
  boxes.reserve(pieces.count());
  for (std::size_t i = 0; i < pieces.count(); ++i) {
    Bounds bounds;
    for (const Vec3& p : pieces.corners(i)) bounds.add(p);
    boxes.push_back(bounds.box());
  }
  return boxes;
}

std::vector<std::uint32_t> labels_of(const FacePieces& pieces,
                                     std::span<const std::uint32_t> label) {
  std::vector<std::uint32_t> labels;
  if (label.empty()) return labels;
  labels.reserve(pieces.count());
  for (std::size_t i = 0; i < pieces.count(); ++i) labels.push_back(label[pieces.face(i)]);
  return labels;
}

// Those of one label after each other.
std::vector<std::uint32_t> order_in_bundles(const FacePieces& pieces,
                                            std::span<const std::uint32_t> label) {
  std::vector<OrientedBox> boxes;
  boxes.reserve(pieces.count());
  for (std::size_t i = 0; i < pieces.count(); ++i) boxes.emplace_back(pieces.corners(i));
  std::vector<std::uint32_t> order = order_in_bundles(boxes);
  if (!label.empty())
    std::ranges::stable_sort(order, {}, [&](std::uint32_t i) { return label[pieces.face(i)]; });
  return order;
}

template <class T>
std::vector<T> in_order(const std::vector<T>& things, std::span<const std::uint32_t> order) {
  std::vector<T> sorted;
  sorted.reserve(things.size());
  if (!things.empty())
    for (const std::uint32_t i : order) sorted.push_back(things[i]);
  return sorted;
}

}  // namespace

PieceSearch::PieceSearch(const FacePieces& pieces, std::span<const std::uint32_t> label) {
  const std::vector<Box> boxes = boxes_of(pieces);
  const std::vector<std::uint32_t> labels = labels_of(pieces, label);
  std::vector<std::uint32_t> order(pieces.count());
  std::iota(order.begin(), order.end(), 0u);
  if (are_mostly_empty(boxes)) {
    order = order_in_bundles(pieces, label);
    tree_ = BoxTree(in_order(boxes, order), in_order(labels, order), true);
    oriented_.emplace(tree_, [&](std::uint32_t i, const auto& add) {
      for (const Vec3& p : pieces.corners(order[i])) add(p);
    });
  } else {
    tree_ = BoxTree(boxes, labels);
  }
  face_.reserve(pieces.count());
  hulls_.reserve(pieces.count());
  for (const std::uint32_t i : order) {
    face_.push_back(pieces.face(i));
    hulls_.emplace_back(pieces.corners(i));
  }
}

}  // namespace sectile
