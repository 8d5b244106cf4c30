#include "rounding/numbers_in_cone.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "geometry/axes.h"
#include "search/approximate.h"

namespace sectile {
namespace {

using namespace approximate;

// A basis of the lattice of all differences of numbers, and how long they are: in units of what is
// inside of the cone all around a place in it.
class Lattice {
 public:
  Lattice(const ThinCone& cone, double far, const std::array<double, 3>& steps)
      : cone_(cone), far_(far) {
    for (std::size_t k = 0; k < 3; ++k) {
      Vector& v = basis_[k];
      v.times = {0, 0, 0};
      v.times[k] = 1;
      v.seen = seen({k == 0 ? steps[0] : 0, k == 1 ? steps[1] : 0, k == 2 ? steps[2] : 0});
      v.square = product(v, v);
    }
    reduce();
  }

  // Those around a place: multiples of the steps.
  std::vector<std::array<double, 3>> around(const Vec3& place) const {
    const std::array<double, 3> at = in_basis(seen(place));
    std::vector<std::array<double, 3>> found;
    for (const double i : {0, -1, 1})
      for (const double j : {0, -1, 1})
        for (const double k : {0, -1, 1}) {
          const std::array<double, 3> of{std::nearbyint(at[0]) + i, std::nearbyint(at[1]) + j,
                                         std::nearbyint(at[2]) + k};
          std::array<double, 3>& times = found.emplace_back();
          for (std::size_t x = 0; x < 3; ++x)
            times[x] = of[0] * basis_[0].times[x] + of[1] * basis_[1].times[x] +
                       of[2] * basis_[2].times[x];
        }
    return found;
  }

 private:
  struct Vector {
    std::array<double, 3> times;  // the steps
    std::vector<double> seen;     // as parts of the ways to the planes, and of that to the tip
    double square;                // of the length
  };

  std::vector<double> seen(const Vec3& way) const {
    std::vector<double> parts;
    for (const Vec3& n : cone_.inward) parts.push_back(dot(n, way) / (far_ * dot(n, cone_.amid)));
    for (const double part : {way.x, way.y, way.z}) parts.push_back(part / far_);
    return parts;
  }
  static double product(const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
  }
  static double product(const Vector& a, const Vector& b) { return product(a.seen, b.seen); }

  static Vector sum(const Vector& a, double times, const Vector& b) {
    Vector s = a;
    for (std::size_t x = 0; x < 3; ++x) s.times[x] += times * b.times[x];
    for (std::size_t i = 0; i < s.seen.size(); ++i) s.seen[i] += times * b.seen[i];
    s.square = product(s, s);
    return s;
  }
  // Rounding is no gain.
  static bool replace_if_shorter(Vector& v, Vector by) {
    if (!(by.square < 0.999 * v.square)) return false;
    v = std::move(by);
    return true;
  }

  // As short as they can be, by Minkowski's conditions for three: so they are far from being in
  // one plane.
  void reduce() {
    while (shorten_by_another() || shorten_by_both_others()) {
    }
  }
  bool shorten_by_another() {
    bool is_shorter = false;
    for (Vector& a : basis_)
      for (const Vector& b : basis_)
        if (&a != &b)
          is_shorter |= replace_if_shorter(a, sum(a, -std::nearbyint(product(a, b) / b.square), b));
    return is_shorter;
  }
  bool shorten_by_both_others() {
    std::sort(basis_.begin(), basis_.end(),
              [](const Vector& a, const Vector& b) { return a.square < b.square; });
    bool is_shorter = false;
    for (const double i : {-1, 1})
      for (const double j : {-1, 1})
        is_shorter |=
            replace_if_shorter(basis_[2], sum(sum(basis_[2], i, basis_[0]), j, basis_[1]));
    return is_shorter;
  }

  // The multiples of the basis that are nearest to a place, by Cramer's rule.
  std::array<double, 3> in_basis(const std::vector<double>& place) const {
    std::array<Vec3, 3> of;
    for (std::size_t k = 0; k < 3; ++k)
      of[k] = {product(basis_[0], basis_[k]), product(basis_[1], basis_[k]),
               product(basis_[2], basis_[k])};
    const Vec3 to{product(basis_[0].seen, place), product(basis_[1].seen, place),
                  product(basis_[2].seen, place)};
    const double all = dot(of[0], cross(of[1], of[2]));
    return {dot(to, cross(of[1], of[2])) / all, dot(of[0], cross(to, of[2])) / all,
            dot(of[0], cross(of[1], to)) / all};
  }

  const ThinCone& cone_;
  const double far_;
  std::array<Vector, 3> basis_;
};

bool is_inside(const ThinCone& cone, const Vec3& way) {
  return std::all_of(cone.inward.begin(), cone.inward.end(),
                     [&](const Vec3& n) { return dot(n, way) > 0; });
}

}  // namespace

std::vector<Vec3> numbers_in_cone(const RoundingGrid& grid, const ThinCone& cone, double far,
                                  double least_step) {
  if (!is_inside(cone, cone.amid)) return {};
  std::array<double, 3> steps;
  Vec3 begin;
  for (int k = 0; k < 3; ++k) {
    const double tip = component(cone.tip, k);
    double& step = steps[static_cast<std::size_t>(k)];
    step = std::max(grid.step({std::abs(tip) + 2 * far, 0, 0}), least_step);
    component(begin, k) = nearest_multiple(tip, step);
  }
  const Vec3 from = cone.to_point + (cone.tip - begin);
  std::vector<std::pair<double, Vec3>> found;
  for (const auto& times : Lattice(cone, far, steps).around(from + far * cone.amid)) {
    const Vec3 way{times[0] * steps[0], times[1] * steps[1], times[2] * steps[2]};
    const double away = max_norm(way - from);
    if (away <= 4 * far && is_inside(cone, way - from))
      found.emplace_back(away, grid.nearest(begin + way));
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Vec3> places;
  for (const auto& [away, place] : found) places.push_back(place);
  return places;
}

}  // namespace sectile
