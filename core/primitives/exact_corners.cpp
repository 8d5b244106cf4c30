#include <cmath>

#include "geometry/formulas.h"
#include "import/face_triangles.h"
#include "sectile/exact_transform.h"
#include "storage/solid_data.h"

namespace sectile {
namespace {

PointOf<Dyadic> exact_point(const Geometry& geometry, PointId p) {
  if (!geometry.is_constructed(p)) return given_point<Dyadic>(geometry, p);
  return constructed_point<Dyadic>(geometry, geometry.construction(p), [&](PlaneId plane) {
    return plane_of<Dyadic>(geometry, plane);
  });
}

/// near is the quotient, rounded: what it lacks is (x - near·w) / w.
ExactCorner corner_of(const PointOf<Dyadic>& point, const Vec3& near) {
  ExactCorner made{near, {0, 0, 0}, {true, true, true}};
  for (int k = 0; k < 3; ++k) {
    const Dyadic lacking = point.x[k] - Dyadic(component(near, k)) * point.w;
    if (lacking.sign() == Sign::zero) continue;
    const double rest = nearest_quotient(lacking, point.w);
    component(made.rest, k) = rest;
    made.is_exact[static_cast<std::size_t>(k)] = lacking == Dyadic(rest) * point.w;
  }
  return made;
}

}  // namespace

ExactMesh exact_mesh(const Solid& solid) {
  ExactMesh made;
  if (solid.is_empty()) return made;
  const Brep& brep = solid.data()->brep();
  const Geometry& geometry = solid.data()->geometry();
  constexpr std::uint32_t none = 0xFFFFFFFFu;
  std::vector<std::uint32_t> number(geometry.positions.size(), none);
  const auto add_corner = [&](PointId p) {
    std::uint32_t& n = number[p.value()];
    if (n == none) {
      n = static_cast<std::uint32_t>(made.corners.size());
      const Vec3& near = geometry.position(p);
      made.mesh.positions.push_back(near);
      made.corners.push_back(geometry.is_explicit(p) ? ExactCorner{near, {}, {true, true, true}}
                                                     : corner_of(exact_point(geometry, p), near));
    }
    made.mesh.indices.push_back(n);
  };
  const FaceTriangles faces(brep, geometry, {brep.faces().begin(), brep.faces().end()});
  faces.for_each([&](FaceId, PointId a, PointId b, PointId c) {
    for (const PointId p : {a, b, c}) add_corner(p);
    made.mesh.face_sizes.push_back(3);
  });
  return made;
}

}  // namespace sectile
