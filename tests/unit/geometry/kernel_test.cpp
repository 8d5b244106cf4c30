// Each exact test against the same formula in rationals, for explicit and for constructed points.
#include "geometry/kernel.h"

#include <gtest/gtest.h>

#include "cases.h"
#include "geometry/axes.h"
#include "geometry/probe.h"
#include "kernel_scene.h"
#include "sectile/errors.h"

namespace sectile::test {
namespace {

template <class Check>
void in_scenes_of(AnyDouble& any, const std::function<double()>& coordinate, const Check& check) {
  for (int i = 0; i < cases(6); ++i) {
    Scene scene(any, coordinate);
    for (int j = 0; j < cases(30); ++j) check(scene);
  }
}

template <class Check>
void in_many_scenes(const Check& check) {
  AnyDouble any(11);
  in_scenes_of(
      any, [&] { return static_cast<double>(any.below(7)) - 3; }, check);
  in_scenes_of(
      any, [&] { return any(); }, check);
  in_scenes_of(
      any, [&] { return extreme(any); }, check);
  // One exponent for all coordinates of an axis, so that points of other planes fall near zero.
  in_scenes_of(
      any,
      [&, axis = 0]() mutable {
        constexpr int exponents[] = {-1074, 0, 540};
        axis = next_axis(axis);
        return std::ldexp(static_cast<double>(any.below(11)) - 5, exponents[axis]);
      },
      check);
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
    const auto [axis, sign] = s.kernel->main_cross(PlaneId(a), PlaneId(b));
    ASSERT_EQ(axis < 0, (n == Vector{0, 0, 0}));
    if (axis >= 0) {
      ASSERT_NE(sign, Sign::zero);
      ASSERT_EQ(sign, rational_sign(n[static_cast<std::size_t>(axis)]));
    }
    ASSERT_EQ(s.kernel->normal(PlaneId(a), 1), rational_sign(s.planes[a].n[1]));
  });
}

// Each way round, at several heights.
TEST(Kernel, PlanesAlongAxes) {
  struct Flat {
    int axis, sense;
    double at;
  };
  const double heights[] = {0, 1, -0.7, 0.1, -0x1p-300, 0x1p300};
  Geometry g;
  std::vector<Flat> flats;
  for (int axis = 0; axis < 3; ++axis)
    for (const int sense : {1, -1})
      for (const double at : heights) {
        Vec3 a, b, c;
        component(a, axis) = component(b, axis) = component(c, axis) = at;
        component(b, next_axis(axis)) = 0.3;
        component(c, next_next_axis(axis)) = sense * 0.2;
        const PointId p = g.add_point(a), q = g.add_point(b), r = g.add_point(c);
        g.add_plane(PlaneDefinition::through(p, q, r));
        flats.push_back({axis, sense, at});
      }
  const Kernel kernel(g);
  for (const PlaneId s : g.planes.ids())
    for (const PlaneId t : g.planes.ids()) {
      const Flat &u = flats[s.value()], &v = flats[t.value()];
      const auto [axis, sign] = kernel.main_cross(s, t);
      EXPECT_EQ(axis, u.axis == v.axis ? -1 : 3 - u.axis - v.axis);
      const int turn = u.axis == v.axis ? 0 : next_axis(u.axis) == v.axis ? 1 : -1;
      EXPECT_EQ(sign, sign_of(u.sense * v.sense * turn));
    }
  for (const PlaneId s : g.planes.ids())
    for (const PointId p : g.positions.ids()) {
      const Flat& u = flats[s.value()];
      const double at = component(g.position(p), u.axis);
      EXPECT_EQ(kernel.side(p, s), sign_of(u.sense * ((at > u.at) - (at < u.at))));
    }
}

// The corners of prisms that stand one on the other, and of some that do so nearly.
TEST(Kernel, PlanesOfPrismsThatStandOnEachOther) {
  AnyDouble any(5);
  int on_plane = 0;
  for (int i = 0; i < cases(300); ++i) {
    const int axis = static_cast<int>(any.below(3));
    const auto random = [&] { return std::ldexp(double(any.below(1u << 31)), -30); };
    const Vec3 p{random(), random(), random()}, q{random(), random(), random()};
    Vec3 above = any.below(2) == 0 ? p : q;
    component(above, axis) = random();
    Geometry g;
    const PlaneId plane =
        g.add_plane(PlaneDefinition::through(g.add_point(p), g.add_point(q), g.add_point(above)));
    std::vector<PointId> points;
    for (Vec3 at : {p, q}) {
      component(at, axis) = random();
      points.push_back(g.add_point(at));
      double& moved = component(at, next_axis(axis));
      moved = std::nextafter(moved, 2.0);
      points.push_back(g.add_point(at));
    }
    const Kernel kernel(g);
    const Vector n = cross(minus(vector(q), vector(p)), minus(vector(above), vector(p)));
    for (const PointId r : points) {
      const Sign side = rational_sign(dot(n, minus(vector(g.position(r)), vector(p))));
      ASSERT_EQ(kernel.side(r, plane), side);
      on_plane += side == Sign::zero ? 1 : 0;
    }
  }
  EXPECT_GE(on_plane, 2 * cases(300));
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

// A state that cannot be: it must not be computed with.
TEST(Kernel, PlanesWithoutACommonPointAreAnInternalError) {
  Geometry g;
  std::vector<PlaneId> planes;
  for (const double height : {0.0, 1.0}) {
    const PointId p = g.add_point({0, 0, height}), q = g.add_point({1, 0, height}),
                  r = g.add_point({0, 1, height});
    planes.push_back(g.add_plane(PlaneDefinition::through(p, q, r)));
    if (height > 0) planes.push_back(g.add_plane(PlaneDefinition::along_axis(p, q, 2)));
  }
  const Kernel kernel(g);
  EXPECT_THROW(kernel.construct({planes[0], planes[1], planes[2], {}, {}}), InternalError);
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

// Whatever is asked about the others, too.
TEST(Kernel, OfSomePlanesDecidesTheSame) {
  in_many_scenes([](Scene& s) {
    const std::array<PlaneId, 2> some{PlaneId(s.any_plane()), PlaneId(s.any_plane())};
    const Kernel kernel(s.geometry, some);
    const std::size_t p = s.any_point(), q = s.any_point(), r = s.any_point();
    const PlaneId a(s.any_plane()), b(s.any_plane()), c(s.any_plane());
    ASSERT_EQ(kernel.side(PointId(p), a), s.kernel->side(PointId(p), a));
    ASSERT_EQ(kernel.det(a, b, c), s.kernel->det(a, b, c));
    ASSERT_EQ(kernel.coplanar(a, b), s.kernel->coplanar(a, b));
    ASSERT_EQ(kernel.cross_axis(a, b) < 0, s.kernel->cross_axis(a, b) < 0);
    ASSERT_NE(kernel.normal(a, kernel.main_axis(a)), Sign::zero);
    for (int k = 0; k < 3; ++k) {
      ASSERT_EQ(kernel.normal(a, k), s.kernel->normal(a, k));
      ASSERT_EQ(kernel.compare(PointId(p), PointId(q), k),
                s.kernel->compare(PointId(p), PointId(q), k));
      ASSERT_EQ(kernel.turn(PointId(p), PointId(q), PointId(r), k),
                s.kernel->turn(PointId(p), PointId(q), PointId(r), k));
    }
  });
}

struct Crossing {
  PlaneId plane;
  PointId u, v;  // on different sides of it
  Probe probe;
  Vector at;
};

// Of random lines with planes.
template <class Check>
void with_crossings(const Check& check) {
  in_many_scenes([&](Scene& s) {
    const std::size_t u = s.any_point(), v = s.any_point(), f = s.any_plane();
    if (u >= Scene::given_points || v >= Scene::given_points) return;
    const auto value = [&](std::size_t p) -> Rational {
      return dot(s.planes[f].n, s.points[p]) + s.planes[f].d;
    };
    const Rational at_u = value(u), at_v = value(v);
    if (!(at_u * at_v < 0)) return;
    Vector at;
    for (std::size_t k = 0; k < 3; ++k)
      at[k] = (s.points[u][k] * at_v - s.points[v][k] * at_u) / (at_v - at_u);
    const Construction how{PlaneId(), PlaneId(), PlaneId(f), PointId(u), PointId(v)};
    check(s, Crossing{how.c, how.line_from, how.line_to,
                      Probe(*s.kernel, how.line_from, how.line_to, how), at});
  });
}

TEST(Probe, SidesOfCrossings) {
  with_crossings([](Scene& s, const Crossing& c) {
    const std::size_t g = s.any_plane();
    ASSERT_EQ(c.probe.side(PlaneId(g)), rational_sign(dot(s.planes[g].n, c.at) + s.planes[g].d));
  });
}

TEST(Probe, OrderOfCrossingsAndPoints) {
  with_crossings([](Scene& s, const Crossing& c) {
    const std::size_t q = s.any_point();
    for (std::size_t k = 0; k < 3; ++k)
      ASSERT_EQ(c.probe.compare(PointId(q), static_cast<int>(k)),
                rational_sign(s.points[q][k] - c.at[k]));
  });
}

// Among the points through which the plane is laid.
TEST(Probe, TurnsInThePlaneThatIsCrossed) {
  int turns = 0;
  with_crossings([&](Scene& s, const Crossing& c) {
    const PlaneDefinition& how = s.geometry.definition(c.plane);
    if (how.kind() != PlaneDefinition::Kind::three_points) return;
    const std::uint32_t corners[] = {how.a, how.b, how.c};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t p = corners[i], q = corners[(i + 1) % 3];
      const auto turn = c.probe.turn(c.plane, PointId(p), PointId(q));
      if (!turn) continue;
      ++turns;
      const Vector way = cross(minus(s.points[q], s.points[p]), minus(c.at, s.points[p]));
      ASSERT_EQ(*turn, rational_sign(dot(way, s.planes[c.plane.value()].n)));
    }
  });
  EXPECT_GT(turns, cases(30));
}

// The other plane is the same, but not by its number.
TEST(Probe, DoesNotTurnWhereEdgesCross) {
  Geometry g;
  const PointId a = g.add_point({0.1, 0, 0.3}), b = g.add_point({0.7, 0, 0.3}),
                c = g.add_point({0.1, 0.9, 0.3});
  const PointId u = g.add_point({0.4, 0, -0.7}), v = g.add_point({0.4, 0, 0.9}),
                w = g.add_point({0.4, 0x1p-60, 0.9});
  const PlaneId up = g.add_plane(PlaneDefinition::through(a, b, c)),
                down = g.add_plane(PlaneDefinition::through(a, c, b));
  const Kernel kernel(g);
  for (const PlaneId plane : {up, down}) {
    const Sign left = plane == up ? Sign::positive : Sign::negative;
    const Probe on(kernel, u, v, {{}, {}, plane, u, v}),
        beside(kernel, w, u, {{}, {}, plane, w, u});
    EXPECT_EQ(on.turn(plane, a, b), Sign::zero);
    EXPECT_EQ(on.turn(plane, b, a), Sign::zero);
    EXPECT_EQ(on.turn(plane, b, c), left);
    EXPECT_EQ(beside.turn(plane, a, b), left);
    EXPECT_EQ(beside.turn(plane, b, a), -left);
    EXPECT_EQ(on.turn(plane == up ? down : up, a, b), std::nullopt);
  }
}

// On a plane across an axis, of a line across another one: two coordinates are known.
TEST(Probe, LevelsOfCrossings) {
  const double height = 0.7, next = std::nextafter(height, 1.0), along = -0.3;
  for (int axis = 0; axis < 3; ++axis)
    for (const bool turned : {false, true}) {
      const int i = next_axis(axis), j = next_next_axis(axis);
      const auto point = [&](double on_axis, double on_i, double on_j) {
        Vec3 p;
        component(p, axis) = on_axis;
        component(p, i) = on_i;
        component(p, j) = on_j;
        return p;
      };
      Geometry g;
      const auto plane_at = [&](double at) {
        const PointId a = g.add_point(point(at, 0, 0)), b = g.add_point(point(at, 1, 0)),
                      c = g.add_point(point(at, 0, 1));
        return g.add_plane(turned ? PlaneDefinition::through(a, c, b)
                                  : PlaneDefinition::through(a, b, c));
      };
      const PlaneId here = plane_at(height), again = plane_at(height), above = plane_at(next);
      const PointId u = g.add_point(point(0, along, 0.1)), v = g.add_point(point(1, along, 0.9)),
                    level = g.add_point(point(height, along, 5)),
                    beyond = g.add_point(point(next, std::nextafter(along, 1.0), 5));
      const Kernel kernel(g);
      const Construction how{{}, {}, here, u, v};
      EXPECT_EQ(kernel.level(how, axis), height);
      EXPECT_EQ(kernel.level(how, i), along);
      EXPECT_EQ(kernel.level(how, j), std::nullopt);
      const Probe probe(kernel, u, v, how);
      for (const int k : {axis, i}) {
        EXPECT_EQ(probe.compare(level, k), Sign::zero);
        EXPECT_EQ(probe.compare(beyond, k), Sign::positive);
      }
      EXPECT_EQ(probe.side(again), Sign::zero);
      EXPECT_EQ(probe.side(above), turned ? Sign::positive : Sign::negative);
    }
}

// Doubles tell the truth, or nothing.
TEST(Probe, ClearTurns) {
  int clear = 0, all = 0;
  const auto expect_true = [&](Scene& s, const Probe& probe, const Vector& at) {
    const std::size_t p = s.any_point(), q = s.any_point();
    const Vector n = cross(minus(s.points[q], s.points[p]), minus(at, s.points[p]));
    for (std::size_t k = 0; k < 3; ++k) {
      ++all;
      const Sign turn = probe.clear_turn(PointId(p), PointId(q), static_cast<int>(k));
      if (turn == Sign::zero) continue;
      ++clear;
      ASSERT_EQ(turn, rational_sign(n[k]));
    }
  };
  with_crossings([&](Scene& s, const Crossing& c) {
    expect_true(s, c.probe, c.at);
    // The line that crosses: there is no turn.
    for (int k = 0; k < 3; ++k) ASSERT_EQ(c.probe.clear_turn(c.u, c.v, k), Sign::zero);
  });
  in_many_scenes([&](Scene& s) {
    const std::size_t r = s.any_point();
    expect_true(s, Probe(*s.kernel, PointId(r)), s.points[r]);
  });
  EXPECT_GT(clear, all / 4);
}

}  // namespace
}  // namespace sectile::test
