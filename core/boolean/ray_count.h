// Point in polygon by counting the crossings of a ray, exactly.
#pragma once

#include <algorithm>
#include <vector>

#include "boolean/entity.h"
#include "boolean/patch.h"
#include "geometry/probe.h"

namespace sectile {

// Counts crossings of the ray in direction +i within the projection along the plane's main axis k,
// with coordinates (i, j) and half-open edges.
class RayCount {
 public:
  RayCount(const Kernel& kernel, const Patch& patch, PlaneId plane, const Probe& point)
      : kernel_(&kernel),
        patch_(&patch),
        plane_(plane),
        point_(&point),
        k_(kernel.main_axis(plane_)),
        i_((k_ + 1) % 3),
        j_((k_ + 2) % 3) {}

  int i() const { return i_; }
  int j() const { return j_; }
  bool odd() const { return odd_; }
  /// The vertices and edges on which the point lies; several where the loops touch themselves.
  const std::vector<Entity>& touched() const { return touched_; }

  void add(HalfEdgeId h) {
    const Brep& brep = patch_->brep;
    const PointId u = brep.point_of(brep.from(h)), v = brep.point_of(brep.to(h));
    const Sign ju = point_->compare(u, j_), jv = point_->compare(v, j_);
    if (ju != Sign::zero && ju == jv) return;
    if (ju == Sign::zero && point_->compare(u, i_) == Sign::zero) {
      touch(brep.from(h));
      return;
    }
    if (jv == Sign::zero && point_->compare(v, i_) == Sign::zero) {
      touch(brep.to(h));
      return;
    }
    if (ju == Sign::zero && jv == Sign::zero) {
      if (point_->compare(u, i_) != point_->compare(v, i_)) touch(Brep::edge_of(h));
      return;
    }
    // Half-open: a point level with the line counts as above it.
    const bool up = ju == Sign::negative && jv != Sign::negative;
    const bool down = jv == Sign::negative && ju != Sign::negative;
    if (ju == Sign::zero || jv == Sign::zero) {
      if ((up || down) && point_->compare(ju == Sign::zero ? u : v, i_) == Sign::positive)
        odd_ = !odd_;
      return;
    }
    const PlaneId across = patch_->side(h);
    const Sign side = point_->side(across);
    if (side == Sign::zero) {
      touch(Brep::edge_of(h));
      return;
    }
    // The half-edge runs along sense · (n × normal(across)); its left side has the sign -sense.
    const Sign sense = (up ? Sign::positive : Sign::negative) * kernel_->cross(plane_, across, j_);
    const bool left = side == -sense;
    const bool mirrored = kernel_->normal(plane_, k_) == Sign::negative;
    if ((left != mirrored) == up) odd_ = !odd_;
  }

 private:
  void touch(Entity entity) {
    if (std::find(touched_.begin(), touched_.end(), entity) == touched_.end())
      touched_.push_back(entity);
  }

  const Kernel* kernel_;
  const Patch* patch_;
  PlaneId plane_;
  const Probe* point_;
  int k_, i_, j_;
  bool odd_ = false;
  std::vector<Entity> touched_;
};

}  // namespace sectile
