#include "import/shells.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "import/nesting.h"
#include "import/volume_sum.h"
#include "numbers/disjoint_sets.h"
#include "numbers/dyadic.h"
#include "search/box.h"
#include "sectile/errors.h"

namespace sectile {

// Edge by edge, as they lie in memory: to walk from face to face would wait for it at each step.
Shells find_shells(const Brep& brep) {
  DisjointSets sets(brep.face_count());
  for (const EdgeId e : brep.edges())
    sets.unite(brep.face_of(Brep::half_edge(e)).value(),
               brep.face_of(Brep::half_edge(e, 1)).value());
  auto [of_face, count] = std::move(sets).numbered();
  return {std::move(of_face), count};
}

namespace {

// What is known of a shell's volume.
struct Enclosed {
  Bounds bounds;
  VolumeSum sum;
  std::uint32_t face = 0;  // one of the shell's faces
  Sign sign = Sign::zero;
};

class ShellVolumes {
 public:
  ShellVolumes(const Brep& brep, const Geometry& geometry, const Shells& shells)
      : brep_(brep), geometry_(geometry), shells_(shells), volumes_(shells.count) {}

  std::vector<Enclosed> run() {
    for (std::size_t f = brep_.face_count(); f-- > 0;) {
      Enclosed& v = of_face(f);
      v.face = static_cast<std::uint32_t>(f);
      for_each_in_face(brep_, FaceId(f), [&](HalfEdgeId h) { v.bounds.add(position(h)); });
    }
    for (std::size_t f = 0; f < brep_.face_count(); ++f) add_terms(FaceId(f), of_face(f));
    find_signs();
    return std::move(volumes_);
  }

 private:
  Enclosed& of_face(std::size_t f) { return volumes_[shells_.of_face[f]]; }
  const Vec3& position(HalfEdgeId h) const {
    return geometry_.position(brep_.point_of(brep_.from(h)));
  }

  // All loops as fans; the fans of inner loops take away.
  template <class Visit>
  void for_each_fan(FaceId f, const Visit& visit) const {
    for (LoopId l = brep_.outer_loop[f]; l.valid(); l = brep_.next_loop[l]) {
      const HalfEdgeId first = brep_.loop_half_edge[l];
      for (HalfEdgeId h = brep_.next_of(first); brep_.next_of(h) != first; h = brep_.next_of(h))
        visit(position(first), position(h), position(brep_.next_of(h)));
    }
  }

  void add_terms(FaceId f, Enclosed& v) const {
    for_each_fan(
        f, [&](const Vec3& a, const Vec3& b, const Vec3& c) { v.sum.add(v.bounds.low, a, b, c); });
  }

  void find_signs() {
    std::vector<std::uint8_t> open(volumes_.size(), 0);
    for (std::size_t i = 0; i < volumes_.size(); ++i) {
      Enclosed& v = volumes_[i];
      if (std::abs(v.sum.value()) > v.sum.error())
        v.sign = sign_of(v.sum.value());
      else
        open[i] = 1;
    }
    if (std::find(open.begin(), open.end(), 1) != open.end()) find_exact_signs(open);
  }

  void find_exact_signs(const std::vector<std::uint8_t>& open) {
    std::vector<Dyadic> sums(volumes_.size());
    for (std::size_t f = 0; f < brep_.face_count(); ++f) {
      const std::uint32_t shell = shells_.of_face[f];
      if (!open[shell]) continue;
      for_each_fan(FaceId(f), [&](const Vec3& a, const Vec3& b, const Vec3& c) {
        const Dyadic bx(b.x), by(b.y), bz(b.z), cx(c.x), cy(c.y), cz(c.z);
        sums[shell] += Dyadic(a.x) * (by * cz - bz * cy) + Dyadic(a.y) * (bz * cx - bx * cz) +
                       Dyadic(a.z) * (bx * cy - by * cx);
      });
    }
    for (std::size_t i = 0; i < sums.size(); ++i)
      if (open[i]) volumes_[i].sign = sums[i].sign();
  }

  const Brep& brep_;
  const Geometry& geometry_;
  const Shells& shells_;
  std::vector<Enclosed> volumes_;
};

void refuse_inside_out(std::uint32_t face) {
  throw InvalidSolid(InvalidSolid::Reason::inside_out,
                     "the shell with face " + std::to_string(face) +
                         " is inside out where it lies; turn all its faces around",
                     face);
}

}  // namespace

std::vector<Sign> signs_of_volumes(const Brep& brep, const Geometry& geometry,
                                   const Shells& shells) {
  std::vector<Sign> signs;
  for (const Enclosed& v : ShellVolumes(brep, geometry, shells).run()) signs.push_back(v.sign);
  return signs;
}

void check_orientation(const SolidData& data, const Kernel& kernel) {
  const Shells shells = find_shells(data.brep());
  const std::vector<Enclosed> volumes = ShellVolumes(data.brep(), data.geometry(), shells).run();
  for (const Enclosed& v : volumes) {
    const std::uint32_t face = data.brep().source[FaceId(v.face)].face;
    if (v.sign == Sign::zero)
      throw InvalidSolid(
          InvalidSolid::Reason::self_intersecting,
          "the shell with face " + std::to_string(face) + " encloses no volume; remove it", face);
    if (v.sign == Sign::negative && shells.count == 1) refuse_inside_out(face);
  }
  if (shells.count == 1) return;
  const std::vector<ShellSurroundings> around = shell_surroundings(data, kernel, shells);
  for (std::uint32_t s = 0; s < shells.count; ++s) {
    const std::uint32_t face = data.brep().source[FaceId(volumes[s].face)].face;
    if (around[s].material < 0) refuse_inside_out(face);
    if (around[s].material > 0)
      throw InvalidSolid(
          InvalidSolid::Reason::self_intersecting,
          "the shell with face " + std::to_string(face) +
              " lies in the material of another one, or they cross; make two solids of them and "
              "unite them",
          face);
  }
}

}  // namespace sectile
