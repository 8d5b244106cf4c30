#include "import/nesting.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "geometry/face_predicates.h"
#include "geometry/triangulation.h"
#include "sectile/errors.h"

namespace sectile {
namespace {

// A line along the x axis through a point within a face. The points are those of a parabola in a
// triangle: a line of the projection along x contains at most two of them, so there is always one
// that lies beside all edges.
class LineThroughFace {
 public:
  LineThroughFace(const SolidData& data, const Kernel& kernel, FaceId face)
      : data_(data), kernel_(kernel), face_(face), triangle_(first_triangle()) {}

  int run() {
    for (int halvings = 1;; ++halvings)
      for (int odd = 1; odd < 1 << halvings; odd += 2) {
        choose_point(odd, 1 << halvings);
        if (const auto material = count()) return *material;
      }
  }

 private:
  std::array<PointId, 3> first_triangle() const {
    std::vector<PointId> corners;
    std::vector<std::uint32_t> loop_ends;
    const Brep& brep = data_.brep();
    for (LoopId l = brep.outer_loop[face_.value()]; l.valid(); l = brep.next_loop[l.value()]) {
      for_each_in_loop(brep, l,
                       [&](HalfEdgeId h) { corners.push_back(brep.point_of(brep.from(h))); });
      loop_ends.push_back(static_cast<std::uint32_t>(corners.size()));
    }
    const PlaneId plane = brep.plane[face_.value()];
    const int axis = kernel_.main_axis(plane);
    const FacePredicates exact(kernel_, axis, kernel_.normal(plane, axis) == Sign::negative,
                               corners);
    std::vector<std::array<std::uint32_t, 3>> triangles;
    triangulate(exact, std::span<const std::uint32_t>(loop_ends), triangles);
    const auto& t = triangles.front();
    return {corners[t[0]], corners[t[1]], corners[t[2]]};
  }

  // The parabola's point at the parameter k / n, with the weight n².
  void choose_point(int k, int n) {
    const double weights[3] = {double(n - k) * (n - k), 2.0 * k * (n - k), double(k) * k};
    const ExactPoint* const corners[] = {&kernel_.exact(triangle_[0]), &kernel_.exact(triangle_[1]),
                                         &kernel_.exact(triangle_[2])};
    point_ = {{Dyadic(), Dyadic(), Dyadic()},
              Dyadic(double(n) * n) * corners[0]->w * corners[1]->w * corners[2]->w};
    for (std::size_t i = 0; i < 3; ++i) {
      const Dyadic share = Dyadic(weights[i]) * corners[(i + 1) % 3]->w * corners[(i + 2) % 3]->w;
      for (int axis = 0; axis < 3; ++axis) point_.x[axis] += share * corners[i]->x[axis];
    }
    if (point_.w.sign() == Sign::positive) return;
    for (Dyadic& x : point_.x) x = -x;
    point_.w = -point_.w;
  }

  // Nothing if the line meets an edge.
  std::optional<int> count() const {
    constexpr double far = std::numeric_limits<double>::infinity();
    const double y = nearest_quotient(point_.x[1], point_.w),
                 z = nearest_quotient(point_.x[2], point_.w);
    const double low_y = std::nextafter(y, -far), high_y = std::nextafter(y, far),
                 low_z = std::nextafter(z, -far), high_z = std::nextafter(z, far);
    std::vector<FaceId> faces;
    data_.tree().query(
        [&](const Box& b) {
          return b.low[1] <= high_y && low_y <= b.high[1] && b.low[2] <= high_z &&
                 low_z <= b.high[2];
        },
        [&](std::uint32_t f) { faces.push_back(FaceId(f)); });
    int beyond = 0;
    for (const FaceId f : faces) {
      if (f == face_) continue;
      const std::optional<bool> met = meets(f);
      if (!met) return {};
      if (!*met) continue;
      const PlaneId plane = data_.brep().plane[f.value()];
      const Sign normal = kernel_.normal(plane, 0), side = side_of(plane);
      if (side == Sign::zero) {
        if (kernel_.parallel(plane, data_.brep().plane[face_.value()])) refuse(f);
        return {};
      }
      if (side != normal) beyond += normal == Sign::positive ? 1 : -1;
    }
    const bool faces_on = kernel_.normal(data_.brep().plane[face_.value()], 0) == Sign::positive;
    return faces_on ? beyond : beyond - 1;
  }

  // The sign of the line's distance from a point along the y axis.
  Sign above(const ExactPoint& p) const {
    return (point_.x[1] * p.w - p.x[1] * point_.w).sign() * p.w.sign();
  }

  Sign side_of(PlaneId plane) const { return value_at(kernel_.exact(plane), point_).sign(); }

  // Does the line go through the face? Nothing if it meets an edge of it.
  std::optional<bool> meets(FaceId f) const {
    bool odd = false, on_edge = false;
    for_each_in_face(data_.brep(), f, [&](HalfEdgeId h) {
      const PointId u = data_.brep().point_of(data_.brep().from(h)),
                    v = data_.brep().point_of(data_.brep().to(h));
      const ExactPoint &from = kernel_.exact(u), &to = kernel_.exact(v);
      const Sign side_u = above(from), side_v = above(to);
      if (side_u == Sign::zero || side_v == Sign::zero) on_edge = true;
      if (side_u == side_v || on_edge) return;
      const Sign turn = turn_of(from, to, point_, 0).sign() * from.w.sign() * to.w.sign();
      if (turn == Sign::zero) on_edge = true;
      if ((turn == Sign::positive) == (side_u == Sign::negative)) odd = !odd;
    });
    if (on_edge) return {};
    return odd;
  }

  [[noreturn]] void refuse(FaceId other) const {
    const std::uint32_t f = data_.brep().source[face_.value()].face,
                        g = data_.brep().source[other.value()].face;
    throw InvalidSolid(InvalidSolid::Reason::self_intersecting,
                       "faces " + std::to_string(f) + " and " + std::to_string(g) +
                           " lie on each other; remove them where they do, or make two solids and "
                           "unite them",
                       f);
  }

  const SolidData& data_;
  const Kernel& kernel_;
  FaceId face_;
  std::array<PointId, 3> triangle_;
  ExactPoint point_;
};

}  // namespace

int material_outside(const SolidData& data, const Kernel& kernel, FaceId face) {
  return LineThroughFace(data, kernel, face).run();
}

}  // namespace sectile
