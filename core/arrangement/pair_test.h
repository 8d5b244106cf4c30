// How two faces meet, if they meet in more than common corners and edges: exactly for faces of few
// corners, and as far as planes tell for others.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "arrangement/pairs.h"
#include "numbers/threshold.h"

namespace sectile::arrangement {

class PairTest {
 public:
  PairTest(const Facets& facets, const std::vector<std::uint8_t>& convex, const Kernel& kernel)
      : facets_(facets), convex_(convex), kernel_(kernel) {}

  /// Nothing if the faces meet in common corners and edges only, or not at all.
  std::optional<Meeting> operator()(std::uint32_t f, std::uint32_t g) const {
    if (facets_.size(f) == 3 && facets_.size(g) == 3 && are_neighbours_apart(f, g)) return {};
    const bool small = facets_.size(f) <= many && facets_.size(g) <= many;
    if (!small) return large(f, g);
    Corners in_f, in_g;
    find_common(f, g, in_f, in_g);
    bool coplanar = true;
    for (const auto& [face, other, common] : {std::tuple(f, g, &in_f), std::tuple(g, f, &in_g)}) {
      const Sides sides = sides_of(face, other, *common);
      if (sides.positive + sides.negative == 0) continue;
      coplanar = false;
      if (sides.positive != 0 && sides.negative != 0) continue;
      if (sides.zero == 0 && only_common(face, *common, other)) return {};
    }
    if (coplanar) return in_one_plane(f, g, in_f, in_g);
    return Meeting::crossing;
  }

 private:
  // Faces with more corners are not looked through for each partner.
  static constexpr std::uint32_t many = threshold(16, 1);

  // Triangles with one or two common corners, which are all that they have in common: seen along
  // an axis, or so far from each other's plane that doubles tell. Most pairs are of this kind.
  bool are_neighbours_apart(std::uint32_t f, std::uint32_t g) const {
    const std::uint32_t first_f = facets_.begin(f), first_g = facets_.begin(g);
    PointId a[3], b[3];
    for (std::uint32_t i = 0; i < 3; ++i) {
      a[i] = facets_.from(first_f + i);
      b[i] = facets_.from(first_g + i);
    }
    int count = 0;
    std::uint32_t i = 0, j = 0;  // the last common corner
    std::uint32_t sum_i = 0, sum_j = 0;
    for (std::uint32_t k = 0; k < 3; ++k)
      for (std::uint32_t l = 0; l < 3; ++l)
        if (a[k] == b[l]) {
          ++count;
          sum_i += i = k;
          sum_j += j = l;
        }
    if (count == 2) return is_across(f, a, 3 - sum_i, b[3 - sum_j]);
    if (count != 1) return false;
    const std::uint32_t i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
    return on_one_side(b[j1], b[j2], facets_.plane[f]) ||
           on_one_side(a[i1], a[i2], facets_.plane[g]) ||
           are_cones_apart(f, a[i], a[i1], a[i2], b[j1], b[j2]);
  }

  // Beyond the edge opposite to corner `apex` of f, seen along an axis?
  bool is_across(std::uint32_t f, const PointId (&a)[3], std::uint32_t apex, PointId p) const {
    const int axis = kernel_.main_axis(facets_.plane[f]);
    return kernel_.turn(a[(apex + 1) % 3], a[(apex + 2) % 3], p, axis) !=
           kernel_.normal(facets_.plane[f], axis);
  }

  bool on_one_side(PointId p, PointId q, PlaneId plane) const {
    const Estimate at_p = kernel_.estimate(p, plane), at_q = kernel_.estimate(q, plane);
    return at_p.decided() && at_q.decided() && at_p.sign() == at_q.sign();
  }

  // Is all of the cone at a corner between c and d strictly beyond a side of f's cone between a and
  // b there, seen along an axis?
  bool are_cones_apart(std::uint32_t f, PointId corner, PointId a, PointId b, PointId c,
                       PointId d) const {
    const int axis = kernel_.main_axis(facets_.plane[f]);
    const Sign outer = -kernel_.normal(facets_.plane[f], axis);
    return (kernel_.turn(corner, a, c, axis) == outer &&
            kernel_.turn(corner, a, d, axis) == outer) ||
           (kernel_.turn(b, corner, c, axis) == outer && kernel_.turn(b, corner, d, axis) == outer);
  }

  struct Corners {
    std::array<bool, many> common{};
    std::uint32_t count = 0;
  };
  struct Sides {
    int positive = 0, negative = 0, zero = 0;  ///< of the corners that are not common ones
  };

  void find_common(std::uint32_t f, std::uint32_t g, Corners& in_f, Corners& in_g) const {
    const std::uint32_t first_f = facets_.begin(f), first_g = facets_.begin(g);
    const std::uint32_t size_f = facets_.size(f), size_g = facets_.size(g);
    for (std::uint32_t i = 0; i < size_f; ++i)
      for (std::uint32_t j = 0; j < size_g; ++j)
        if (facets_.from(first_f + i) == facets_.from(first_g + j))
          in_f.common[i] = in_g.common[j] = true;
    for (std::uint32_t i = 0; i < size_f; ++i) in_f.count += in_f.common[i];
    for (std::uint32_t j = 0; j < size_g; ++j) in_g.count += in_g.common[j];
  }

  Sides sides_of(std::uint32_t face, std::uint32_t other, const Corners& common) const {
    Sides sides;
    const PlaneId plane = facets_.plane[other];
    for (std::uint32_t i = 0, c = facets_.begin(face); c < facets_.end(face); ++i, ++c) {
      if (common.common[i]) continue;
      const Sign s = kernel_.side(facets_.from(c), plane);
      ++(s == Sign::zero ? sides.zero : s == Sign::positive ? sides.positive : sides.negative);
    }
    return sides;
  }

  // All other corners lie strictly on one side: the face has common corners on the other's plane,
  // and what edges it has between them.
  bool only_common(std::uint32_t face, const Corners& common, std::uint32_t other) const {
    if (common.count < 2) return true;
    if (common.count == 2 && facets_.size(face) == 3 && facets_.size(other) == 3) return true;
    for (std::uint32_t i = 0, c = facets_.begin(face); c < facets_.end(face); ++i, ++c) {
      if (!common.common[i]) continue;
      if (!common.common[facets_.next[c] - facets_.begin(face)]) continue;
      if (!has_edge(other, facets_.from(c), facets_.to(c))) return false;
    }
    return true;
  }
  bool has_edge(std::uint32_t face, PointId p, PointId q) const {
    for (std::uint32_t c = facets_.begin(face); c < facets_.end(face); ++c) {
      const PointId u = facets_.from(c), v = facets_.to(c);
      if ((u == p && v == q) || (u == q && v == p)) return true;
    }
    return false;
  }

  std::optional<Meeting> in_one_plane(std::uint32_t f, std::uint32_t g, const Corners& in_f,
                                      const Corners& in_g) const {
    if (!convex_[f] || !convex_[g]) return Meeting::overlapping;
    bool on_line = false;
    if (!separates(f, g, on_line) && !separates(g, f, on_line)) return Meeting::overlapping;
    // Do both have nothing but common corners on the line?
    if (!on_line && in_f.count <= 2 && in_g.count <= 2) return {};
    return Meeting::touching;
  }

  /// Does the line of an edge of f have all of g on its outer side? `on_line`: are corners of one
  /// on the line that are not the ends of the edge?
  bool separates(std::uint32_t f, std::uint32_t g, bool& on_line) const {
    const int axis = kernel_.main_axis(facets_.plane[f]);
    const Sign inner = kernel_.normal(facets_.plane[f], axis);
    for (std::uint32_t c = facets_.begin(f); c < facets_.end(f); ++c) {
      const PointId u = facets_.from(c), v = facets_.to(c);
      bool outside = true;
      std::uint32_t others = 0;
      for (std::uint32_t d = facets_.begin(g); d < facets_.end(g) && outside; ++d) {
        const PointId w = facets_.from(d);
        if (w == u || w == v) continue;
        const Sign s = kernel_.turn(u, v, w, axis) * inner;
        if (s == Sign::positive) outside = false;
        if (s == Sign::zero) ++others;
      }
      if (!outside) continue;
      // With corners of 180°, a corner of f may be the one that lies within an edge of g.
      on_line = others > 0 || facets_.size(f) > 3;
      return true;
    }
    return false;
  }

  std::optional<Meeting> large(std::uint32_t f, std::uint32_t g) const {
    if (kernel_.coplanar(facets_.plane[f], facets_.plane[g])) return Meeting::overlapping;
    for (const auto& [face, other] : {std::pair(f, g), std::pair(g, f)}) {
      if (facets_.size(face) > many) continue;
      const Sides sides = sides_of(face, other, Corners());
      if (sides.zero == 0 && (sides.positive == 0 || sides.negative == 0)) return {};
    }
    return Meeting::crossing;
  }

  const Facets& facets_;
  const std::vector<std::uint8_t>& convex_;
  const Kernel& kernel_;
};

}  // namespace sectile::arrangement
