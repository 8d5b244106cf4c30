#include "storage/block.h"

#include <cmath>

#include "parallel/once_alone.h"
#include "topology/touching_vertices.h"

namespace sectile {
namespace {

// Around the images of all points in a box, and of those that are off by half an ulp of it. Sums of
// four products are off by much less than the share that is added; where they are not finite, the
// image may be anywhere.
Box image_of(const Box& box, const Frame& frame) {
  Bounds bounds;
  double low[3], high[3];
  for (int row = 0; row < 3; ++row) {
    double middle = frame.entry(row, 3).near().high(), half = 0, size = std::abs(middle);
    for (int k = 0; k < 3; ++k) {
      const double from = static_cast<double>(box.low[k]), to = static_cast<double>(box.high[k]);
      const double entry = frame.entry(row, k).near().high();
      middle += entry * (0.5 * (from + to));
      half += std::abs(entry) * (0.5 * (to - from));
      size += std::abs(entry) * (std::abs(from) + std::abs(to));
    }
    const double reach = half + 0x1p-40 * size + 0x1p-1000;
    low[row] = middle - reach;
    high[row] = middle + reach;
    if (!std::isfinite(low[row]) || !std::isfinite(high[row])) return Box::everything();
  }
  bounds.add({low[0], low[1], low[2]});
  bounds.add({high[0], high[1], high[2]});
  return bounds.box();
}

}  // namespace

Block::Block() : structure_(std::make_shared<Structure>()) {}

Block::Block(CompactTriangles triangles)
    : border_count(static_cast<std::uint32_t>(triangles.border.size())),
      structure_(std::make_shared<Structure>()),
      is_late_(true),
      triangles_(std::make_shared<const CompactTriangles>(std::move(triangles))) {
  structure_->is_late = true;
  structure_->triangles = triangles_;
  structure_->faces = static_cast<std::uint32_t>(triangles_->triangles.size());
  structure_->half_edges = triangles_->half_edge_count;
  structure_->vertices = static_cast<std::uint32_t>(triangles_->positions.size());
  set_touching_vertices({});
  bounds_once_.run([this] {
    Bounds bounds;
    for (const Vec3& p : triangles_->positions) bounds.add(p);
    bounds_ = bounds.box();
  });
  structure_->pieces_once.run([this] { structure_->pieces = Pieces(*triangles_); });
}

Block::Block(std::shared_ptr<const Block> original, std::shared_ptr<const GeometryMover> mover)
    : border_count(original->border_count),
      structure_(original->structure_),
      is_late_(true),
      is_image_(true),
      original_(std::move(original)),
      mover_(std::move(mover)) {
  set_touching_vertices(original_->touching_vertices());
  bounds_once_.run([this] { bounds_ = image_of(original_->bounds(), mover_->frame()); });
}

void Block::Structure::make() {
  once.run([this] { brep = make_brep(*triangles); });
}

void Block::make_geometry() const {
  geometry_once_.run([this] {
    geometry_ = original_ ? (*mover_)(original_->geometry()) : sectile::make_geometry(*triangles_);
    triangles_.reset();
    original_.reset();
    mover_.reset();
  });
}

std::size_t Block::face_count() const {
  return structure_->is_late ? structure_->faces : structure_->brep.face_count();
}

std::size_t Block::half_edge_count() const {
  return structure_->is_late ? structure_->half_edges : structure_->brep.half_edge_count();
}

std::size_t Block::loop_count() const {
  return structure_->is_late ? structure_->faces : structure_->brep.loop_count();
}

std::size_t Block::vertex_count() const {
  return structure_->is_late ? structure_->vertices : structure_->brep.vertex_count();
}

const FaceTree& Block::tree() const {
  // A block that has neighbours was cut from a larger structure, along a curve.
  once_alone(tree_once_,
             [this] { tree_ = std::make_unique<FaceTree>(brep(), geometry(), border_count > 0); });
  return *tree_;
}

const Pieces& Block::pieces() const {
  once_alone(structure_->pieces_once,
             [this] { structure_->pieces = Pieces(brep(), border_count); });
  return structure_->pieces;
}

// A block that has neighbours was told so when it was made.
const std::vector<VertexId>& Block::touching_vertices() const {
  once_alone(touching_once_, [this] {
    if (border_count == 0) touching_vertices_ = sectile::touching_vertices(brep());
  });
  return touching_vertices_;
}

void Block::set_touching_vertices(std::vector<VertexId> vertices) {
  touching_once_.run([&] { touching_vertices_ = std::move(vertices); });
}

void Block::set_bounds(const Box& bounds) {
  bounds_once_.run([&] { bounds_ = bounds; });
}

const Box& Block::bounds() const {
  once_alone(bounds_once_, [this] {
    Bounds bounds;
    for (const PointId p : brep().point) bounds.add(geometry().position(p));
    bounds_ = bounds.box();
  });
  return bounds_;
}

const OrientedBox& Block::oriented_bounds() const {
  once_alone(oriented_once_, [this] {
    std::vector<Vec3> points;
    points.reserve(brep().vertex_count());
    for (const PointId p : brep().point) points.push_back(geometry().position(p));
    oriented_bounds_ = std::make_unique<OrientedBox>(points);
  });
  return *oriented_bounds_;
}

const BlockVolume& Block::volume() const {
  once_alone(volume_once_, [this] { volume_ = volume_of_faces(brep(), geometry()); });
  return volume_;
}

const Bounded& Block::two_areas() const {
  once_alone(area_once_, [this] { two_areas_ = two_areas_of_faces(brep(), geometry()); });
  return two_areas_;
}

}  // namespace sectile
