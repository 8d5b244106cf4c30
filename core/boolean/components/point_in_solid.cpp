#include "boolean/components/point_in_solid.h"

#include "geometry/x_ray.h"
#include "search/missed_face.h"
#include "sectile/errors.h"
#include "storage/face_query.h"

namespace sectile {
namespace {

// One ray in direction +x.
class RayTest {
 public:
  RayTest(const Kernel& kernel, const Brep& brep, PointId point)
      : kernel_(kernel), brep_(brep), point_(point) {}

  bool crosses(FaceId face) const {
    XRayParity parity;
    for_each_in_face(brep_, face, [&](HalfEdgeId h) {
      const PointId u = brep_.point_of(brep_.from(h)), v = brep_.point_of(brep_.to(h));
      parity.add(kernel_.compare(point_, u, 1) == Sign::positive,
                 kernel_.compare(point_, v, 1) == Sign::positive,
                 [&] { return kernel_.turn(u, v, point_, 0); });
    });
    if (!parity.odd()) return false;
    const PlaneId plane = brep_.plane[face];
    const Sign side = kernel_.side(point_, plane);
    if (side == Sign::zero) throw InternalError("a ray starts on the boundary");
    return side == -kernel_.normal(plane, 0);
  }

 private:
  const Kernel& kernel_;
  const Brep& brep_;
  PointId point_;
};

// So many are looked at in no more time than their oriented boxes take.
constexpr std::size_t few_blocks = 8;

}  // namespace

bool is_inside(Workspace& w, Operand operand, PointId point) {
  const Patch& patch = w.patch[operand];
  if (patch.unbounded) return w.tests().side(point, patch.plane(FaceId(0))) == Sign::negative;
  const SolidData& solid = *patch.solid;
  const Vec3 p = w.geometry.position(point);
  const auto meets = [&](const Box& b) {
    return b.high[0] >= p.x && b.low[1] <= p.y && p.y <= b.high[1] && b.low[2] <= p.z &&
           p.z <= b.high[2];
  };
  if (solid.slot_tree().empty() || !solid.slot_tree().bounds().contains(p)) return false;
  // Boxes of what is long and slanted overlap very many rays.
  std::size_t blocks = 0;
  const OrientedBox ray_box(box_around(p, {solid.slot_tree().bounds().high[0], p.y, p.z}));
  const auto is_apart = [&](const Block& block) {
    return ++blocks > few_blocks && apart(block.oriented_bounds(), ray_box);
  };
  std::vector<FaceId> faces = faces_where(solid, meets, is_apart);
  std::erase_if(faces, [&](FaceId f) {
    const std::uint32_t slot = solid.slot_of(f);
    const Block& block = *solid.slot(slot).block;
    return is_missed(block.brep(), block.geometry(), solid.local(slot, f), p);
  });
  if (faces.empty()) return false;
  const Patch hit = load_patch(*patch.solid, faces, w.geometry);
  w.kernel->refresh();
  const RayTest ray(w.tests(), hit.brep, point);
  bool inside = false;
  for (std::size_t f = 0; f < hit.loaded_faces; ++f)
    if (ray.crosses(FaceId(f))) inside = !inside;
  return inside;
}

}  // namespace sectile
