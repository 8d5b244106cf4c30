// Each exact test against the same formula in rationals, for explicit and for constructed points.
#include "geometry/kernel.h"

#include <gtest/gtest.h>

#include "geometry/probe.h"
#include "rational.h"

namespace sectile::test {
namespace {

using Vector = std::array<Rational, 3>;

Vector vector(const Vec3& p) {
  return {rational(p.x), rational(p.y), rational(p.z)};
}
Vector minus(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Rational dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

struct Plane {
  Vector n;
  Rational d;
};

// A geometry of random points and planes, with the same in rationals beside it.
class Scene {
 public:
  Scene(AnyDouble& any, bool grid) : any_(any), grid_(grid) {
    for (int i = 0; i < 18; ++i) add_point();
    while (planes.size() < 6) add_plane();
    for (int i = 0; i < 8; ++i) add_construction();
    kernel = std::make_unique<Kernel>(geometry);
  }

  Geometry geometry;
  std::vector<Vector> points;
  std::vector<Plane> planes;
  std::unique_ptr<Kernel> kernel;

  std::size_t any_point() { return any_.below(points.size()); }
  std::size_t any_plane() { return any_.below(planes.size()); }

 private:
  double coordinate() { return grid_ ? static_cast<double>(any_.below(7)) - 3 : any_(); }
  void add_point() {
    const Vec3 p{coordinate(), coordinate(), coordinate()};
    geometry.add_point(p);
    points.push_back(vector(p));
  }
  void add_plane() {
    const std::size_t a = any_.below(18), b = any_.below(18), c = any_.below(18);
    const Vector n = cross(minus(points[b], points[a]), minus(points[c], points[a]));
    if (n == Vector{0, 0, 0}) return add_point();
    geometry.add_plane(PlaneDefinition::through(PointId(a), PointId(b), PointId(c)));
    planes.push_back({n, -dot(n, points[a])});
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
      if (abs(v) > Rational(Integer(1) << 1000u)) return;
    geometry.add_point(Construction{PlaneId(a), PlaneId(b), PlaneId(c), {}, {}},
                       Vec3{nearest(p[0]), nearest(p[1]), nearest(p[2])});
    points.push_back(p);
  }

  AnyDouble& any_;
  bool grid_;
};

template <class Check>
void in_many_scenes(const Check& check) {
  AnyDouble any(11);
  for (int i = 0; i < 60; ++i) {
    Scene scene(any, i % 2 == 0);
    for (int j = 0; j < 40; ++j) check(scene);
  }
}

TEST(Kernel, SideOfAPlane) {
  in_many_scenes([](Scene& s) {
    const std::size_t p = s.any_point(), f = s.any_plane();
    ASSERT_EQ(s.kernel->side(PointId(p), PlaneId(f)),
              rational_sign(dot(s.planes[f].n, s.points[p]) + s.planes[f].d));
  });
}

TEST(Kernel, DeterminantOfNormals) {
  in_many_scenes([](Scene& s) {
    const std::size_t a = s.any_plane(), b = s.any_plane(), c = s.any_plane();
    ASSERT_EQ(s.kernel->det(PlaneId(a), PlaneId(b), PlaneId(c)),
              rational_sign(dot(s.planes[a].n, cross(s.planes[b].n, s.planes[c].n))));
  });
}

TEST(Kernel, CrossProductsOfNormals) {
  in_many_scenes([](Scene& s) {
    const std::size_t a = s.any_plane(), b = s.any_plane();
    const Vector n = cross(s.planes[a].n, s.planes[b].n);
    for (int k = 0; k < 3; ++k)
      ASSERT_EQ(s.kernel->cross(PlaneId(a), PlaneId(b), k),
                rational_sign(n[static_cast<std::size_t>(k)]));
    ASSERT_EQ(s.kernel->parallel(PlaneId(a), PlaneId(b)), (n == Vector{0, 0, 0}));
    ASSERT_EQ(s.kernel->normal(PlaneId(a), 1), rational_sign(s.planes[a].n[1]));
  });
}

TEST(Kernel, CoplanarPlanes) {
  in_many_scenes([](Scene& s) {
    const std::size_t a = s.any_plane(), b = s.any_plane();
    const Vector n = cross(s.planes[a].n, s.planes[b].n);
    bool same = n == Vector{0, 0, 0};
    for (std::size_t k = 0; k < 3; ++k)
      same = same && s.planes[a].n[k] * s.planes[b].d == s.planes[b].n[k] * s.planes[a].d;
    ASSERT_EQ(s.kernel->coplanar(PlaneId(a), PlaneId(b)), same);
  });
}

TEST(Kernel, OrderAndCoincidenceOfPoints) {
  in_many_scenes([](Scene& s) {
    const std::size_t p = s.any_point(), q = s.any_point();
    for (std::size_t k = 0; k < 3; ++k)
      ASSERT_EQ(s.kernel->compare(PointId(p), PointId(q), static_cast<int>(k)),
                rational_sign(s.points[q][k] - s.points[p][k]));
    ASSERT_EQ(s.kernel->same_point(PointId(p), PointId(q)), s.points[p] == s.points[q]);
  });
}

TEST(Kernel, TurnSeenAlongAnAxis) {
  in_many_scenes([](Scene& s) {
    const std::size_t p = s.any_point(), q = s.any_point(), r = s.any_point();
    const Vector n = cross(minus(s.points[q], s.points[p]), minus(s.points[r], s.points[p]));
    for (std::size_t k = 0; k < 3; ++k)
      ASSERT_EQ(s.kernel->turn(PointId(p), PointId(q), PointId(r), static_cast<int>(k)),
                rational_sign(n[k]));
  });
}

TEST(Probe, CrossingsOfLinesWithPlanes) {
  in_many_scenes([](Scene& s) {
    const std::size_t u = s.any_point(), v = s.any_point(), f = s.any_plane(), g = s.any_plane();
    if (u >= 18 || v >= 18) return;
    const auto value = [&](std::size_t plane, std::size_t p) -> Rational {
      return dot(s.planes[plane].n, s.points[p]) + s.planes[plane].d;
    };
    const Rational at_u = value(f, u), at_v = value(f, v);
    if (!(at_u * at_v < 0)) return;
    const Probe probe(*s.kernel, PointId(u), PointId(v),
                      Construction{PlaneId(), PlaneId(), PlaneId(f), PointId(u), PointId(v)});
    ASSERT_EQ(probe.side(PlaneId(g)),
              rational_sign((value(g, u) * at_v - value(g, v) * at_u) / (at_v - at_u)));
  });
}

}  // namespace
}  // namespace sectile::test
