// Corners of one face around a point, found by direction, against a look at all of them.
#include "boolean/corner_fan.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "append_mesh.h"
#include "unit/boolean/phases.h"

namespace sectile {
namespace {

constexpr int spikes = 12;

// Flat on the ground, around the origin; the later ones are longer and wider.
Solid star(double turn, double wide, double height) {
  PolygonMesh mesh;
  const double step = 2 * std::numbers::pi / spikes;
  for (int i = 0; i < spikes; ++i) {
    const double a = step * (i + turn), b = a + wide * step, size = 1 + 0.25 * i;
    const auto at = [&](double angle, double z) -> Vec3 {
      return {size * std::cos(angle), size * std::sin(angle), z};
    };
    test::append({{{0, 0, 0}, at(a, 0), at(b, 0), at((a + b) / 2, height)},
                  {3, 3, 3, 3},
                  {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3}},
                 mesh);
  }
  return Solid::from_mesh(mesh);
}

class CornersOfAFloor : public ::testing::Test {
 protected:
  CornersOfAFloor()
      : phases_(boolean(block({-8, -8, -1}, {8, 8, 0}), star(0, 0.5, 1), Operation::unite),
                star(0.3, 0.6, 1), Operation::unite) {
    for (const HalfEdgeId h : brep().half_edges())
      if (position(brep().from(h)) == Vec3{0, 0, 0} && is_floor(brep().face_of(h)))
        leaving_.push_back(h);
  }

  // Calls visit(fan) for that of all corners, and for such of some.
  template <class Visit>
  void for_each_fan(const Visit& visit) {
    for (const std::size_t count :
         {std::size_t(1), std::size_t(2), std::size_t(4), leaving_.size()})
      for (std::size_t first = 0; first + count <= leaving_.size(); ++first)
        visit(CornerFan(kernel(), patch(), std::span(leaving_).subspan(first, count)));
  }
  // Calls visit(from, to) for lines between any corners on the ground that do not go through the
  // origin's place.
  template <class Visit>
  void for_each_line_beside(const Visit& visit) {
    std::vector<PointId> points;
    for (const Operand s : both_operands) {
      const Brep& some = phases_.w.patch[s].brep;
      for (const VertexId v : some.vertices())
        if (phases_.w.geometry.position(some.point_of(v)).z == 0)
          points.push_back(some.point_of(v));
    }
    for (const PointId from : points)
      for (const PointId to : points)
        if (kernel().turn(origin(), from, to, 2) != Sign::zero) visit(from, to);
  }
  template <class Visit>
  void for_each_direction(const Visit& visit) {
    for (const Operand s : both_operands)
      for (const FaceId f : phases_.w.patch[s].brep.faces()) {
        const PlaneId across = phases_.w.patch[s].plane(f);
        if (kernel().side(origin(), across) != Sign::zero) continue;
        if (kernel().parallel(plane(), across)) continue;
        visit(Direction{across, Sign::positive});
        visit(Direction{across, Sign::negative});
      }
  }

  const Patch& patch() { return phases_.w.patch[Operand::a]; }
  const Brep& brep() { return patch().brep; }
  const Kernel& kernel() { return phases_.w.tests(); }
  PlaneId plane() { return brep().plane_of(leaving_[0]); }
  PointId origin() { return brep().point_of(brep().from(leaving_[0])); }
  const Vec3& position(VertexId v) { return phases_.w.geometry.position(brep().point_of(v)); }
  bool is_floor(FaceId f) {
    return patch().is_real(f) && kernel().normal(patch().plane(f), 2) == Sign::positive &&
           kernel().main_axis(patch().plane(f)) == 2 &&
           kernel().normal(patch().plane(f), 0) == Sign::zero;
  }
  bool has_number(const CornerFan::Range& range, std::size_t i, std::size_t size) {
    for (std::size_t k = 0; k < range.count; ++k)
      if ((range.first + k) % size == i) return true;
    return false;
  }

  test::Phases phases_;
  std::vector<HalfEdgeId> leaving_;
};

TEST_F(CornersOfAFloor, AreAsManyAsSpikes) {
  EXPECT_EQ(leaving_.size(), std::size_t(spikes));
}

TEST_F(CornersOfAFloor, TowardsLines) {
  std::size_t lines = 0;
  for_each_fan([&](const CornerFan& fan) {
    for_each_line_beside([&](PointId from, PointId to) {
      ++lines;
      const bool left = kernel().turn(origin(), from, to, 2) == Sign::positive;
      const PointId first = left ? from : to, last = left ? to : from;
      const CornerFan::Range range = fan.towards(kernel(), from, to);
      EXPECT_LE(range.count, fan.size());
      for (std::size_t i = 0; i < fan.size(); ++i)
        EXPECT_EQ(has_number(range, i, fan.size()),
                  turn_from(kernel(), first, fan[i].direction) != Sign::negative &&
                      turn_from(kernel(), last, fan[i].direction) != Sign::positive);
    });
  });
  EXPECT_GT(lines, std::size_t(spikes * spikes));
}

TEST_F(CornersOfAFloor, BeforeDirections) {
  std::size_t along = 0;
  for_each_fan([&](const CornerFan& fan) {
    for_each_direction([&](Direction d) {
      const auto is_along = [&](const CornerFan::Bound& b) {
        return turn(kernel(), plane(), d, b.direction) == Sign::zero &&
               same_way(kernel(), plane(), d, b.direction);
      };
      const CornerFan::Range range = fan.along(kernel(), d);
      for (std::size_t i = 0; i < fan.size(); ++i)
        EXPECT_EQ(has_number(range, i, fan.size()), is_along(fan[i]));
      along += range.count;
      // What is next to it clockwise is, counter-clockwise, the last one.
      const CornerFan::Bound& last = fan.last(kernel(), d);
      if (range.count > 0) {
        EXPECT_TRUE(is_along(last));
        return;
      }
      for (std::size_t i = 0; i < fan.size(); ++i)
        EXPECT_FALSE(
            before_counter_clockwise(kernel(), plane(), d, last.direction, fan[i].direction));
    });
  });
  EXPECT_GT(along, std::size_t(spikes));
}

}  // namespace
}  // namespace sectile
