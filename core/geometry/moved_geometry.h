// The image of points and planes under an exact affine map. Numbers of points and planes stay.
#pragma once

#include <map>
#include <memory>

#include "geometry/geometry.h"

namespace sectile {

class GeometryMover {
 public:
  explicit GeometryMover(const Frame& frame);

  const Frame& frame() const { return *frame_; }
  /// Must be called for every geometry before the first of them is moved.
  void prepare(const Geometry& geometry);
  /// Normals turn with their planes' points: if the map mirrors, they point to the other side. May
  /// be called by several threads at a time.
  Geometry operator()(const Geometry& from) const;

 private:
  using FramePointer = std::shared_ptr<const Frame>;
  using DirectionPointer = std::shared_ptr<const ExactDirection>;

  DirectionPointer image_of(const ExactDirection& direction) const;
  void move_given(const Vec3& local, const FramePointer& frame, PointId p, Geometry& to) const;
  void move_points(const Geometry& from, Geometry& to) const;
  void move_planes(const Geometry& from, Geometry& to) const;
  void move_plane(const Geometry& from, PlaneDefinition& plane, Geometry& to) const;

  FramePointer frame_;
  DirectionPointer axes_[3];
  // Of frames and directions that were moved before; none for the identity.
  std::map<const Frame*, FramePointer> frames_;
  std::map<const ExactDirection*, DirectionPointer> directions_;
};

}  // namespace sectile
