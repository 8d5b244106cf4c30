// Splitting by a plane (paper, section 3): the Boolean against a half-space. Above is the
// intersection, Below the difference; both come from one cut, because Table I has the same rows for
// them.
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "boolean/boolean.h"
#include "import/soup.h"
#include "numbers/rounding.h"
#include "sectile/boolean.h"
#include "sectile/errors.h"
#include "storage/face_query.h"

namespace sectile {
namespace {

constexpr Operation above = Operation::intersect, below = Operation::subtract;

void check(const HalfSpace& h) {
  for (const double value : {h.a, h.b, h.c, h.d})
    if (!std::isfinite(value))
      throw std::invalid_argument("the plane has a coefficient that is not finite");
  if (h.a == 0 && h.b == 0 && h.c == 0)
    throw std::invalid_argument("the plane's normal (a, b, c) is zero");
}

// Can the plane meet the box? Rounding only makes it say yes too often.
class MeetsPlane {
 public:
  explicit MeetsPlane(const HalfSpace& h) : h_(h) {}
  bool operator()(const Box& b) const {
    double low = h_.d, high = h_.d, size = std::abs(h_.d);
    const double n[3] = {h_.a, h_.b, h_.c};
    for (int k = 0; k < 3; ++k) {
      const double p = n[k] * b.low[k], q = n[k] * b.high[k];
      low += std::min(p, q);
      high += std::max(p, q);
      size += std::max(std::abs(p), std::abs(q));
    }
    // The boxes are those of rounded positions: off by half an ulp, or half the least double.
    const double length = std::abs(n[0]) + std::abs(n[1]) + std::abs(n[2]);
    const double margin = 16 * rounding::unit * size + rounding::underflow * (16 + length);
    return !(low > margin) && !(high < -margin);
  }

 private:
  HalfSpace h_;
};

void load(Workspace& w, const SolidData& solid, const HalfSpace& h, std::uint32_t origin,
          FacePairs& pairs) {
  const MeetsPlane meets(h);
  const std::vector<FaceId> faces = faces_where(solid, meets);
  w.stay_alone_with_few(faces.size());
  std::vector<FarLoops> far_loops;
  if (!w.options.observer) far_loops = find_far_loops(solid, faces, meets);
  w.patch[Operand::a] = load_patch(solid, faces, w.geometry, 0, std::move(far_loops));
  // The normal points out of the half-space.
  const PlaneId plane = w.geometry.add_plane(PlaneCoefficients{-h.a, -h.b, -h.c, -h.d});
  w.patch[Operand::b] = half_space_patch(plane, {origin, 0});
  w.kernel = std::make_unique<Kernel>(w.geometry);
  complete_patches(w.patch, w.geometry, *w.kernel);
  for (const FaceId f : faces) pairs.push_back({loaded_face(w.patch[Operand::a], f), FaceId(0)});
}

// Caps come from the plane. Blocks of triangles that came in together have none, and their
// structure is not made for this.
void add_caps(const Slot& slot, std::uint32_t plane_origin, Section& section) {
  if (slot.empty() || slot.block->compact_triangles()) return;
  const Brep& brep = slot.block->brep();
  for (const FaceId f : brep.faces()) {
    if (brep.source[f].solid != plane_origin) continue;
    for (LoopId l = brep.outer_loop[f]; l.valid(); l = brep.next_loop[l]) {
      std::vector<Vec3>& loop = section.loops.emplace_back();
      for_each_in_loop(slot, l, [&](HalfEdgeId h) {
        loop.push_back(slot.block->geometry().position(slot.start_of(h)));
      });
    }
  }
}

}  // namespace

std::pair<Solid, Solid> split(const Solid& solid, const HalfSpace& half_space) {
  return split(solid, half_space, BooleanOptions{});
}

std::pair<Solid, Solid> split(const Solid& solid, const HalfSpace& half_space,
                              const BooleanOptions& options) {
  check(half_space);
  if (solid.is_empty()) {
    if (options.progress) options.progress(1);
    return {};
  }
  Workspace w(options);
  FacePairs pairs;
  load(w, operand(solid, options), half_space, new_origin(), pairs);
  const Operation wanted[] = {above, below};
  const CutBoundaries boundaries = cut(w, pairs, {wanted});
  return {assemble(w, boundaries, above, 0), assemble(w, boundaries, below, 1)};
}

Section section(const Solid& solid, const HalfSpace& half_space) {
  return section(solid, half_space, BooleanOptions{});
}

Section section(const Solid& solid, const HalfSpace& half_space, const BooleanOptions& options) {
  check(half_space);
  Section result;
  if (solid.is_empty()) return result;
  const BooleanOptions unobserved = without_observer(options);
  Workspace w(unobserved);
  FacePairs pairs;
  const std::uint32_t origin = new_origin();
  load(w, *solid.data(), half_space, origin, pairs);
  const Operation wanted[] = {below};
  // The caps of the part below have the normal of the plane.
  const Solid part = assemble(w, cut(w, pairs, {wanted}), below, 0);
  if (part.is_empty()) return result;
  for (const Slot& slot : part.data()->slots()) add_caps(slot, origin, result);
  return result;
}

}  // namespace sectile
