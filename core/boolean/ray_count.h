// Point in face by counting the crossings of a ray, exactly; with the entities that it touches.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "boolean/entity.h"
#include "boolean/patch.h"
#include "geometry/axes.h"
#include "geometry/planar_ray.h"
#include "geometry/probe.h"
#include "search/outline_tree.h"

namespace sectile {

class RayCount {
 public:
  /// `touched`: what holds the entities that the ray's point lies on; emptied first.
  RayCount(const Kernel& kernel, const Patch& patch, PlaneId plane, const Probe& point,
           std::vector<Entity>& touched)
      : patch_(&patch), point_(&point), ray_(kernel, plane, point), touched_(touched) {
    touched_.clear();
  }

  bool odd() const { return ray_.odd(); }
  /// The vertices and edges on which the point lies; several where the loops touch themselves.
  const std::vector<Entity>& touched() const { return touched_; }

  /// All edges of an outline, whose numbers stand for these half-edges; nothing else is counted.
  void add(const OutlineTree& outline, std::span<const HalfEdgeId> half_edges) {
    const Vec3& at = point_->position();
    const double i = component(at, ray_.i()), j = component(at, ray_.j());
    const OutlineTree::Place place{{i, j}, {i, j}};
    const auto start = [&](std::uint32_t corner) {
      return patch_->brep.point_of(patch_->brep.from(half_edges[corner]));
    };
    if (outline.is_nested()) {
      const auto first = outline.first_on_ray(
          place, [&](std::uint32_t edge) { return crosses(half_edges[edge]); });
      if (first == StripTree::no_edge) return;
      if (first) return ray_.cross_first(start(*first));
      ray_.restart();
      touched_.clear();
    }
    outline.cast_ray(
        place, [&](std::uint32_t edge) { add(half_edges[edge]); },
        [&](std::uint32_t from, std::uint32_t to) { ray_.pass(start(from), start(to)); });
  }

  /// Is the ray's point this one of the plane?
  bool touches(PointId p) const {
    return point_->compare(p, ray_.i()) == Sign::zero && point_->compare(p, ray_.j()) == Sign::zero;
  }

  void add(HalfEdgeId h) {
    using Touch = PlanarRay<Probe>::Touch;
    const Brep& brep = patch_->brep;
    switch (ray_.add(brep.point_of(brep.from(h)), brep.point_of(brep.to(h)),
                     [&] { return patch_->side(h); })) {
      case Touch::from:
        return touch(brep.from(h));
      case Touch::to:
        return touch(brep.to(h));
      case Touch::within:
        return touch(Brep::edge_of(h));
      case Touch::nothing:
        break;
    }
  }

 private:
  bool crosses(HalfEdgeId h) {
    const bool before = odd();
    add(h);
    return odd() != before;
  }

  void touch(Entity entity) {
    if (std::find(touched_.begin(), touched_.end(), entity) == touched_.end())
      touched_.push_back(entity);
  }

  const Patch* patch_;
  const Probe* point_;
  PlanarRay<Probe> ray_;
  std::vector<Entity>& touched_;
};

}  // namespace sectile
