#include "boolean/components/point_in_solid.h"

#include <algorithm>

#include "geometry/x_ray.h"
#include "sectile/errors.h"

namespace sectile {
namespace {

// One ray in direction +x.
class RayTest {
 public:
  RayTest(const Kernel& kernel, const Brep& brep, PointId point)
      : kernel_(kernel), brep_(brep), point_(point) {}

  // One if it leaves the solid through a face, less than none if it enters.
  int times_left(FaceId face) const {
    XRayParity parity;
    for_each_in_face(brep_, face, [&](HalfEdgeId h) {
      const PointId u = brep_.point_of(brep_.from(h)), v = brep_.point_of(brep_.to(h));
      parity.add(kernel_.compare(point_, u, 1) == Sign::positive,
                 kernel_.compare(point_, v, 1) == Sign::positive,
                 [&] { return kernel_.turn(u, v, point_, 0); });
    });
    if (!parity.odd()) return 0;
    const PlaneId plane = brep_.plane[face];
    const Sign side = kernel_.side(point_, plane);
    if (side == Sign::zero) throw InternalError("a ray starts on the boundary");
    if (side != -kernel_.normal(plane, 0)) return 0;
    return side == Sign::negative ? 1 : -1;
  }

 private:
  const Kernel& kernel_;
  const Brep& brep_;
  PointId point_;
};

}  // namespace

PointInSolid::PointInSolid(Workspace& w, Operand operand) : w_(w), operand_(operand) {
  if (!w.patch[operand].unbounded) faces_.emplace(*w.patch[operand].solid);
}

bool PointInSolid::operator()(PointId point) {
  return *follow_ray(point, false);
}

std::optional<bool> PointInSolid::if_clear(PointId point) {
  return follow_ray(point, true);
}

std::optional<bool> PointInSolid::follow_ray(PointId point, bool only_if_clear) {
  if (!faces_) return w_.tests().side(point, w_.patch[operand_].plane(FaceId(0))) == Sign::negative;
  Group group;
  faces_->start(w_.geometry.position(point));
  while (true) {
    if (!group.empty && (faces_->at_end() || faces_->begin() > group.to)) {
      if (only_if_clear && !group.unclear.empty()) return {};
      if (const int times = times_left(group, point); times != 0) return times > 0;
      group = {};
    }
    if (faces_->at_end()) return false;
    if (const auto met = faces_->next()) group.add(*met);
  }
}

void PointInSolid::Group::add(const FacesOnRay::Met& met) {
  to = empty ? met.to : std::max(to, met.to);
  empty = false;
  if (met.normal == Sign::zero)
    unclear.push_back(met.face);
  else
    left += met.normal == Sign::positive ? 1 : -1;
}

int PointInSolid::times_left(const Group& group, PointId point) {
  if (group.unclear.empty()) return group.left;
  std::vector<FaceId> faces = group.unclear;
  std::ranges::sort(faces);
  const Patch unclear = load_patch(*w_.patch[operand_].solid, faces, w_.geometry);
  w_.kernel->refresh();
  const RayTest ray(w_.tests(), unclear.brep, point);
  int left = group.left;
  // More may be loaded: those that are met elsewhere do not count here.
  for (const FaceId f : faces) left += ray.times_left(loaded_face(unclear, f));
  return left;
}

}  // namespace sectile
