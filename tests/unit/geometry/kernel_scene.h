// A geometry of random points and planes of all kinds, with the same in rationals beside it.
#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <vector>

#include "geometry/kernel.h"
#include "unit/rational.h"

namespace sectile::test {

using Vector = std::array<Rational, 3>;

inline Vector vector(const Vec3& p) {
  return {rational(p.x), rational(p.y), rational(p.z)};
}
inline Vector minus(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Rational dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

struct Plane {
  Vector n;
  Rational d;
};

/// Small integers times powers of two from one end of the doubles to the other.
inline double extreme(AnyDouble& any) {
  constexpr int exponents[] = {-1074, -1073, -1022, -540, -300, 0, 300, 540, 1020};
  const double size =
      std::ldexp(static_cast<double>(any.below(7)) - 3, exponents[any.below(std::size(exponents))]);
  return any.below(8) == 0 ? size * (1 + 0x1p-52) : size;
}

class Scene {
 public:
  static constexpr std::size_t given_points = 18;  ///< explicit ones and moved ones

  Scene(AnyDouble& any, std::function<double()> coordinate)
      : any_(any), coordinate_(std::move(coordinate)) {
    for (std::size_t i = 0; i < given_points; ++i) add_point();
    while (planes.size() < 5) add_plane();
    while (planes.size() < 7) add_plane_along_axis();
    while (planes.size() < 9) add_coefficients();
    while (planes.size() < 11) add_plane_along_direction();
    for (int i = 0; i < 12; ++i) add_construction();
    kernel = std::make_unique<Kernel>(geometry);
  }

  Geometry geometry;
  std::vector<Vector> points;
  std::vector<Plane> planes;
  std::unique_ptr<Kernel> kernel;

  std::size_t any_point() { return any_.below(points.size()); }
  std::size_t any_plane() { return any_.below(planes.size()); }

 private:
  std::size_t given_point() { return any_.below(given_points); }
  void add_point() {
    if (any_.below(3) == 0 && add_moved_point()) return;
    const Vec3 p{coordinate_(), coordinate_(), coordinate_()};
    geometry.add_point(p);
    points.push_back(vector(p));
  }
  bool add_moved_point() {
    std::array<double, 12> m;
    for (double& entry : m) entry = coordinate_();
    const Vec3 local{coordinate_(), coordinate_(), coordinate_()};
    const Vector at = vector(local);
    Vector image;
    for (std::size_t k = 0; k < 3; ++k) {
      image[k] = rational(m[4 * k]) * at[0] + rational(m[4 * k + 1]) * at[1] +
                 rational(m[4 * k + 2]) * at[2] + rational(m[4 * k + 3]);
      if (abs(image[k]) > Rational(Integer(1) << 1023u)) return false;
    }
    geometry.frames.place(std::make_shared<const Frame>(m));
    geometry.add_point(MovedPoint{local, static_cast<std::uint32_t>(geometry.frames.size() - 1)},
                       Vec3{nearest(image[0]), nearest(image[1]), nearest(image[2])});
    points.push_back(image);
    return true;
  }
  void add_plane() {
    const std::size_t a = given_point(), b = given_point(), c = given_point();
    const Vector n = cross(minus(points[b], points[a]), minus(points[c], points[a]));
    if (n == Vector{0, 0, 0}) return;
    geometry.add_plane(PlaneDefinition::through(PointId(a), PointId(b), PointId(c)));
    planes.push_back({n, -dot(n, points[a])});
  }
  void add_plane_along_axis() {
    const std::size_t a = given_point(), b = given_point(), axis = any_.below(3);
    Vector e{0, 0, 0};
    e[axis] = 1;
    const Vector n = cross(minus(points[b], points[a]), e);
    if (n == Vector{0, 0, 0}) return;
    geometry.add_plane(PlaneDefinition::along_axis(PointId(a), PointId(b), static_cast<int>(axis)));
    planes.push_back({n, -dot(n, points[a])});
  }
  void add_plane_along_direction() {
    const std::size_t a = given_point(), b = given_point();
    const Vec3 along{coordinate_(), coordinate_(), coordinate_()};
    const Vector n = cross(minus(points[b], points[a]), vector(along));
    if (n == Vector{0, 0, 0}) return;
    auto direction = std::make_shared<ExactDirection>();
    for (int k = 0; k < 3; ++k) direction->d[k] = ExactNumber(Dyadic(component(along, k)));
    geometry.directions.place(std::move(direction));
    geometry.add_plane(PlaneDefinition::along_direction(
        PointId(a), PointId(b), static_cast<std::uint32_t>(geometry.directions.size() - 1)));
    planes.push_back({n, -dot(n, points[a])});
  }
  void add_coefficients() {
    const PlaneCoefficients k{coordinate_(), coordinate_(), coordinate_(), coordinate_()};
    if (k.a == 0 && k.b == 0 && k.c == 0) return;
    geometry.add_plane(k);
    planes.push_back({{rational(k.a), rational(k.b), rational(k.c)}, rational(k.d)});
  }
  void add_construction() {
    const std::size_t a = any_plane(), b = any_plane(), c = any_plane();
    const Vector bc = cross(planes[b].n, planes[c].n);
    const Rational w = dot(planes[a].n, bc);
    if (w == 0) return;
    const Vector ca = cross(planes[c].n, planes[a].n), ab = cross(planes[a].n, planes[b].n);
    Vector p;
    for (std::size_t k = 0; k < 3; ++k)
      p[k] = -(planes[a].d * bc[k] + planes[b].d * ca[k] + planes[c].d * ab[k]) / w;
    for (const Rational& v : p)
      if (abs(v) > Rational(Integer(1) << 1023u)) return;
    geometry.add_point(Construction{PlaneId(a), PlaneId(b), PlaneId(c), {}, {}},
                       Vec3{nearest(p[0]), nearest(p[1]), nearest(p[2])});
    points.push_back(p);
  }

  AnyDouble& any_;
  std::function<double()> coordinate_;
};

}  // namespace sectile::test
