// Volume and area in numbers of any length. Implicit points are taken as quotients of so many bits
// that the result is certain; twice as many if it is not.
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "geometry/formulas.h"
#include "geometry/kernel.h"
#include "import/measure.h"
#include "parallel/parallel.h"
#include "sectile/errors.h"

namespace sectile {
namespace {

using Corner = std::array<Dyadic, 3>;

Dyadic size_of(const Dyadic& value) {
  return value.sign() == Sign::negative ? -value : value;
}

// The points' coordinates, off by 2^-bits of their size at most.
class Corners {
 public:
  Corners(const Geometry& geometry, const Kernel& kernel, int bits)
      : geometry_(geometry), constructed_(geometry.constructions.size()) {
    parallel::loop(0, constructed_.size(), [&](std::size_t i) {
      const ExactPoint p = kernel.exact(geometry.constructions[i]);
      for (std::size_t k = 0; k < 3; ++k) constructed_[i][k] = quotient(p.x[k], p.w, bits);
    });
  }

  Corner operator()(PointId p) const {
    if (geometry_.is_constructed(p)) return constructed_[geometry_.construct[p]];
    const ExactPoint at = given_point<Dyadic>(geometry_, p);
    return {at.x[0], at.x[1], at.x[2]};
  }

 private:
  const Geometry& geometry_;
  std::vector<Corner> constructed_;
};

// The largest coordinate on each axis.
class Extent {
 public:
  void add(const Corner& p) {
    for (std::size_t k = 0; k < 3; ++k)
      if (const Dyadic size = size_of(p[k]); size_[k] < size) size_[k] = size;
  }
  const Dyadic& operator[](std::size_t axis) const { return size_[axis]; }

 private:
  Dyadic size_[3];
};

// numerator / denominator for all numerators that are off by the error at most, if they are rounded
// to one double or to two neighbours.
std::optional<double> certain(const Dyadic& numerator, const Dyadic& error, double denominator) {
  const Dyadic d(denominator);
  const double low = nearest_quotient(numerator - error, d),
               high = nearest_quotient(numerator + error, d);
  if (low != high && std::nextafter(low, std::numeric_limits<double>::infinity()) != high)
    return std::nullopt;
  return nearest_quotient(numerator, d);
}

// With ever more bits until attempt(bits) knows.
template <class Attempt>
double with_enough_bits(const Attempt& attempt) {
  for (int bits = 128;; bits *= 2)
    if (const std::optional<double> known = attempt(bits)) return *known;
}

}  // namespace

// A term is a product of a turn below 8 X Y and heights below 3 Z, for the largest coordinates X,
// Y, Z; of the coordinates in it each is off by 2^-bits of them, which makes 4 · 2^-bits of 24 X Y
// Z.
double exact_volume(const SolidData& solid) {
  const Brep& brep = solid.brep();
  const Kernel kernel(solid.geometry());
  return with_enough_bits([&](int bits) {
    const Corners corners(solid.geometry(), kernel, bits);
    Extent extent;
    for (const PointId p : brep.point) extent.add(corners(p));
    const Dyadic six_volumes =
        sum_over_faces<Dyadic>(brep.face_count(), [&](std::size_t from, std::size_t to) {
          Dyadic sum;
          for (std::size_t f = from; f < to; ++f)
            for_each_fan(brep, FaceId(f), [&](PointId a, PointId b, PointId c) {
              const Corner p = corners(a), q = corners(b), r = corners(c);
              sum +=
                  minor(q[0] - p[0], q[1] - p[1], r[0] - p[0], r[1] - p[1]) * (p[2] + q[2] + r[2]);
            });
          return sum;
        });
    Dyadic error;
    if (!solid.geometry().constructions.empty())
      error = (Dyadic(96.0 * static_cast<double>(brep.half_edge_count())) * extent[0] * extent[1] *
               extent[2])
                  .scaled(-bits);
    return certain(six_volumes, error, 6);
  });
}

namespace {

// No number of bits would tell the area of a face all of whose corners are on one line.
void throw_if_on_one_line(const Brep& brep, FaceId f, const Kernel& kernel) {
  bool on_line = true;
  for_each_fan(brep, f, [&](PointId a, PointId b, PointId c) {
    for (int axis = 0; on_line && axis < 3; ++axis)
      on_line = kernel.turn(a, b, c, axis) == Sign::zero;
  });
  if (on_line) throw InternalError("a face has no area");
}

// Twice a face's area, off by 2^-60 of it at most, if its corners are known well enough.
std::optional<Dyadic> two_areas(const Brep& brep, FaceId f, const Corners& corners, bool exact,
                                int bits) {
  Extent extent;
  Dyadic n[3];
  double terms = 0;
  for_each_fan(brep, f, [&](PointId a, PointId b, PointId c) {
    const Corner p = corners(a), q = corners(b), r = corners(c);
    for (const Corner& corner : {p, q, r}) extent.add(corner);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
      n[k] += minor(q[i] - p[i], q[j] - p[j], r[i] - p[i], r[j] - p[j]);
    }
    terms += 1;
  });
  const Dyadic square = dot(n, n);
  if (exact) {
    if (square.sign() == Sign::zero) throw InternalError("a face has no area");
    return square_root(square);
  }
  // Each of the terms is a turn, as above.
  Dyadic error;
  for (std::size_t k = 0; k < 3; ++k) error += extent[(k + 1) % 3] * extent[(k + 2) % 3];
  error = (error * Dyadic(32 * terms)).scaled(-bits);
  if (!((error * error).scaled(2 * 62) < square)) return std::nullopt;
  return square_root(square);
}

// Twice the area of some faces, if their corners are known well enough.
std::optional<Dyadic> two_areas(const SomeFaces& part, int bits) {
  const Kernel kernel(part.geometry);
  const Corners corners(part.geometry, kernel, bits);
  const bool exact = part.geometry.constructions.empty();
  std::vector<std::uint8_t> open(part.faces.size(), 0);
  Dyadic sum = sum_over_faces<Dyadic>(part.faces.size(), [&](std::size_t from, std::size_t to) {
    Dyadic sum_of_range;
    for (std::size_t i = from; i < to; ++i) {
      const auto area = two_areas(part.brep, part.faces[i], corners, exact, bits);
      if (area) {
        sum_of_range += *area;
      } else {
        throw_if_on_one_line(part.brep, part.faces[i], kernel);
        open[i] = 1;
      }
    }
    return sum_of_range;
  });
  if (std::ranges::find(open, 1) != open.end()) return std::nullopt;
  return sum;
}

}  // namespace

double exact_area(const SolidData& solid) {
  const auto faces = solid.brep().faces();
  const SomeFaces all[] = {{solid.brep(), solid.geometry(), {faces.begin(), faces.end()}}};
  return exact_area(all);
}

double exact_area(std::span<const SomeFaces> parts) {
  return with_enough_bits([&](int bits) -> std::optional<double> {
    Dyadic sum;
    for (const SomeFaces& part : parts) {
      const auto area = two_areas(part, bits);
      if (!area) return std::nullopt;
      sum += *area;
    }
    return certain(sum, sum.scaled(-59), 2);
  });
}

}  // namespace sectile
