// The stretches of a line in the plane of a face on both sides of which the face lies.
#pragma once

#include <vector>

#include "boolean/reduction/reduction.h"

namespace sectile {

/// Points on a line: which comes first?
class AlongLineOfPoints {
 public:
  /// Through two different points.
  AlongLineOfPoints(const Kernel& kernel, PointId p, PointId q) : kernel_(&kernel) {
    while (axis_ < 2 && kernel.compare(p, q, axis_) == Sign::zero) ++axis_;
  }
  /// Positive: p comes before q.
  Sign compare(PointId p, PointId q) const {
    return p == q ? Sign::zero : kernel_->compare(p, q, axis_);
  }

 private:
  const Kernel* kernel_;
  int axis_ = 0;
};

/// A point of the line, and what the face has there: a vertex, or an edge that crosses the line.
struct FaceStretchEnd {
  PointId point;
  Entity entity;
};
/// Between two neighbouring points where the face's boundary meets the line; the first end comes
/// before the second one.
using FaceStretch = std::array<FaceStretchEnd, 2>;

/// Of a loaded face of an operand in whose plane the line is. `across`: another plane through the
/// line. Adds points to the workspace's geometry, where edges cross the line.
std::vector<FaceStretch> face_stretches(Workspace& w, Operand s, FaceId face, PlaneId across,
                                        const AlongLineOfPoints& along);

}  // namespace sectile
