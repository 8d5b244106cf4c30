#include "storage/block_measure.h"

#include <array>
#include <cmath>

#include "geometry/formulas.h"
#include "numbers/rounding.h"
#include "topology/fans.h"
#include "topology/triangle.h"

namespace sectile {
namespace {

using rounding::underflow;
using rounding::unit;

using CornerBounds = std::array<Bounded, 3>;

// The coordinates of a point as far as pairs of doubles know them.
CornerBounds corner(const Geometry& geometry, PointId p) {
  if (!geometry.is_constructed(p)) {
    PointOf<Bounded> given = given_point<Bounded>(geometry, p);
    return {given.x[0], given.x[1], given.x[2]};
  }
  const auto plane = [&](PlaneId s) { return plane_of<Bounded>(geometry, s); };
  const PointOf<Bounded> made =
      constructed_point<Bounded>(geometry, geometry.construction(p), plane);
  return {quotient(made.x[0], made.w), quotient(made.x[1], made.w), quotient(made.x[2], made.w)};
}

// Of all points, each computed once.
class Corners {
 public:
  explicit Corners(const Geometry& geometry) : geometry_(geometry) {
    if (geometry.constructions.empty() && geometry.moved.empty()) return;
    corners_.resize(geometry.positions.size());
    for (std::size_t i = 0; i < corners_.size(); ++i)
      if (const PointId p(i); !geometry.is_explicit(p)) corners_[i] = corner(geometry, p);
  }

  bool all_explicit(PointId a, PointId b, PointId c) const {
    return corners_.empty() ||
           (geometry_.is_explicit(a) && geometry_.is_explicit(b) && geometry_.is_explicit(c));
  }
  const Vec3& position(PointId p) const { return geometry_.position(p); }

  CornerBounds operator()(PointId p) const {
    if (!geometry_.is_explicit(p)) return corners_[p.value()];
    const Vec3& at = position(p);
    return {Bounded(at.x), Bounded(at.y), Bounded(at.z)};
  }

 private:
  const Geometry& geometry_;
  std::vector<CornerBounds> corners_;  // empty if all points are explicit
};

// a - b - difference, for difference = a - b rounded.
double error_of(double a, double b, double difference) {
  const double part = difference - a;
  return (a - (difference - part)) - (b + part);
}

// A number in two halves without a bound; `size` is that of the products in it.
struct Halves {
  double value, rest, size;
};

// ((b - a) × (c - a)) on the axis that follows i and j. With u for the unit roundoff the rest is
// below 4 u size, and the true number less than 24 u² size beside the sum of both halves, if no
// product underflows.
Halves turn(const Vec3& a, const Vec3& b, const Vec3& c, int i, int j) {
  const double ai = component(a, i), aj = component(a, j), bi = component(b, i),
               bj = component(b, j), ci = component(c, i), cj = component(c, j);
  const double ui = bi - ai, uj = bj - aj, vi = ci - ai, vj = cj - aj;
  const double p = ui * vj, q = uj * vi, value = p - q;
  const double p_rest =
      std::fma(ui, vj, -p) + (ui * error_of(cj, aj, vj) + error_of(bi, ai, ui) * vj);
  const double q_rest =
      std::fma(uj, vi, -q) + (uj * error_of(ci, ai, vi) + error_of(bj, aj, uj) * vi);
  return {value, error_of(p, q, value) + (p_rest - q_rest), std::abs(p) + std::abs(q)};
}

// A sum of n terms whose rests are at most 10 u of their sizes. The rest of the sum grows to
// (n + 10) u of all sizes, and is rounded n times.
class Sum {
 public:
  void add(const Halves& term) {
    const double next = value_ + term.value;
    rest_ += error_of(value_, -term.value, next) + term.rest;
    value_ = next;
    size_ += term.size;
    ++terms_;
  }
  double terms() const { return static_cast<double>(terms_); }
  /// The terms themselves are off by at most so many u² of their sizes.
  Bounded value(double error_of_terms) const {
    const double n = terms() + 16;
    return Bounded::within(value_, 2 * (n * n + error_of_terms) * unit * unit * size_) +
           Bounded(rest_);
  }

 private:
  double value_ = 0, rest_ = 0, size_ = 0;
  std::size_t terms_ = 0;
};

// Six times the volume below triangles with explicit corners: for each the turn of its projection
// times the sum of its three heights. The rest of the heights is below 5 u of their sizes, and that
// of the product below 10 u; with all roundings that makes less than 128 u². Their shadow is the
// sum of the turns.
class VolumeBelow {
 public:
  explicit VolumeBelow(double level) : level_(level) {}

  void add(const Vec3& a, const Vec3& b, const Vec3& c) {
    const Halves t = turn(a, b, c, 0, 1);
    const double ha = a.z - level_, hb = b.z - level_, hc = c.z - level_;
    const double two = ha + hb, height = two + hc;
    const double rest =
        (error_of(ha, -hb, two) + error_of(two, -hc, height)) +
        (error_of(a.z, level_, ha) + error_of(b.z, level_, hb) + error_of(c.z, level_, hc));
    const double term = t.value * height;
    const double heights = std::abs(ha) + std::abs(hb) + std::abs(hc);
    sum_.add({term, std::fma(t.value, height, -term) + (t.value * rest + t.rest * height),
              t.size * heights});
    heights_ += heights;
    shadow_.add(t);
  }
  // Eight products of a turn may underflow, and four of a term.
  Bounded value() const {
    return sum_.value(128) + Bounded::within(0, 16 * underflow * (heights_ + sum_.terms()));
  }
  Bounded shadow() const {
    return shadow_.value(32) + Bounded::within(0, 16 * underflow * sum_.terms());
  }

 private:
  Sum sum_, shadow_;
  double level_, heights_ = 0;
};

BlockVolume volume_below(const Brep& brep, const Geometry& geometry) {
  const Corners corners(geometry);
  const double level = geometry.position(brep.point_of(VertexId(0))).z;
  VolumeBelow plain(level);
  Bounded below, shadow;
  for (const FaceId f : brep.faces())
    for_each_fan(brep, f, [&](PointId a, PointId b, PointId c) {
      if (corners.all_explicit(a, b, c))
        return plain.add(geometry.position(a), geometry.position(b), geometry.position(c));
      const CornerBounds p = corners(a), q = corners(b), r = corners(c);
      const Bounded turn = minor(q[0] - p[0], q[1] - p[1], r[0] - p[0], r[1] - p[1]);
      below = below +
              turn * ((p[2] - Bounded(level)) + (q[2] - Bounded(level)) + (r[2] - Bounded(level)));
      shadow = shadow + turn;
    });
  return {plain.value() + below, plain.shadow() + shadow, level};
}

// Twice the areas of triangles with explicit corners, the lengths of their normals n. With the root
// r of the first half of n², the length is r + (n² - r²) / 2r and a rest that is below
// 49 u² size² / r + u² r. The second halves of n, left out in its square, make 24 u² size² / r, the
// errors of n 42 u² size, and the roundings of the second half of n² less than 96 u² size + 24 u²
// r; since r is below 2 size, all is below 512 u² size² / r.
class Triangles {
 public:
  // False if the triangle is too thin, too small or too large for this.
  bool add(const Vec3& a, const Vec3& b, const Vec3& c) {
    double square = 0, rest = 0, largest = 0;
    for (int k = 0; k < 3; ++k) {
      const Halves n = turn(a, b, c, next_axis(k), next_next_axis(k));
      const double product = n.value * n.value, next = square + product;
      rest += error_of(square, -product, next) +
              (std::fma(n.value, n.value, -product) + 2 * n.value * n.rest);
      square = next;
      largest = std::max(largest, n.size);
    }
    if (!(square > 0x1p-800 && largest < 0x1p400 && square > largest * largest * 0x1p-40))
      return false;
    const double root = std::sqrt(square), half = 0.5 / root;
    sum_.add({root, (std::fma(-root, root, square) + rest) * half, root + largest});
    errors_ += largest * largest * half;
    return true;
  }
  Bounded value() const { return sum_.value(0) + Bounded::within(0, 2048 * unit * unit * errors_); }

 private:
  Sum sum_;
  double errors_ = 0;
};

// Twice the area of any face.
template <class CornerOf>
Bounded area_of_face(const Brep& brep, FaceId f, const CornerOf& corners) {
  Bounded n[3];
  for_each_fan(brep, f, [&](PointId a, PointId b, PointId c) {
    const CornerBounds p = corners(a), q = corners(b), r = corners(c);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
      n[k] = n[k] + minor(q[i] - p[i], q[j] - p[j], r[i] - p[i], r[j] - p[j]);
    }
  });
  return square_root(dot(n, n));
}

Bounded two_areas(const Brep& brep, const Geometry& geometry) {
  const Corners corners(geometry);
  Triangles plain;
  Bounded others;
  for (const FaceId f : brep.faces()) {
    bool added = false;
    if (is_triangle(brep, f))
      for_each_fan(brep, f, [&](PointId a, PointId b, PointId c) {
        added = corners.all_explicit(a, b, c) &&
                plain.add(geometry.position(a), geometry.position(b), geometry.position(c));
      });
    if (!added) others = others + area_of_face(brep, f, corners);
  }
  return plain.value() + others;
}

// The same bits in half the time where the processor multiplies and adds in one step: else each
// std::fma is a call.
#if defined(__x86_64__) && defined(__GNUC__)
[[gnu::target("fma"), gnu::flatten]] BlockVolume fused_volume_below(const Brep& brep,
                                                                    const Geometry& geometry) {
  return volume_below(brep, geometry);
}
[[gnu::target("fma"), gnu::flatten]] Bounded fused_two_areas(const Brep& brep,
                                                             const Geometry& geometry) {
  return two_areas(brep, geometry);
}
bool is_fused() {
  return __builtin_cpu_supports("fma") != 0;
}
#else
constexpr auto fused_volume_below = volume_below;
constexpr auto fused_two_areas = two_areas;
bool is_fused() {
  return false;
}
#endif

}  // namespace

BlockVolume volume_of_faces(const Brep& brep, const Geometry& geometry) {
  return is_fused() ? fused_volume_below(brep, geometry) : volume_below(brep, geometry);
}

Bounded two_areas_of_faces(const Brep& brep, const Geometry& geometry) {
  return is_fused() ? fused_two_areas(brep, geometry) : two_areas(brep, geometry);
}

Bounded two_areas_of_faces(const Brep& brep, const Geometry& geometry,
                           std::span<const FaceId> faces) {
  Bounded sum;
  for (const FaceId f : faces)
    sum = sum + area_of_face(brep, f, [&](PointId p) { return corner(geometry, p); });
  return sum;
}

}  // namespace sectile
