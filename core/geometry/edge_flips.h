// Better-shaped triangles: edges between two triangles are flipped as long as the angles that they
// face make more than a straight one (C. L. Lawson, Software for C1 surface interpolation, 1977).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "numbers/sign.h"

namespace sectile {

/// Doubles decide which edges would better be flipped, and only the shape depends on them; exact
/// turns decide which ones can be. No edge of the region's boundary is flipped, and each triangle
/// stays in the sector of its corner that it is in.
template <class Predicates>
class EdgeFlips {
 public:
  using Triangle = std::array<std::uint32_t, 3>;

  /// Counter-clockwise triangles that do not overlap; exact.seen(corner) gives about where a corner
  /// is, in the order of the turns.
  EdgeFlips(const Predicates& exact, std::vector<Triangle>& triangles, std::size_t first)
      : exact_(exact),
        triangles_(triangles),
        first_(first),
        mates_(3 * (triangles.size() - first)) {
    find_mates();
  }

  void run() {
    std::vector<std::uint32_t> open(mates_.size());
    for (std::uint32_t i = 0; i < open.size(); ++i)
      open[i] = static_cast<std::uint32_t>(open.size()) - 1 - i;
    // As a rule there are few for each triangle; with more, shapes are good enough.
    std::size_t left = 16 * mates_.size();
    while (!open.empty() && left > 0) {
      const std::uint32_t side = open.back();
      open.pop_back();
      if (mates_[side] == none || !is_better_flipped(side)) continue;
      --left;
      flip(side, open);
    }
  }

 private:
  static constexpr std::uint32_t none = 0xFFFFFFFFu;
  using Place = std::array<double, 2>;

  // Side 3 t + k leads from corner k of triangle t to the next one.
  static std::uint32_t next(std::uint32_t side) { return side % 3 == 2 ? side - 2 : side + 1; }
  static std::uint32_t prev(std::uint32_t side) { return side % 3 == 0 ? side + 2 : side - 1; }
  std::uint32_t& corner(std::uint32_t side) { return triangles_[first_ + side / 3][side % 3]; }
  std::uint32_t corner(std::uint32_t side) const { return triangles_[first_ + side / 3][side % 3]; }

  void find_mates() {
    struct Side {
      std::uint32_t low, high, number;
      bool operator<(const Side& o) const {
        return low != o.low ? low < o.low : high != o.high ? high < o.high : number < o.number;
      }
    };
    std::vector<Side> sides(mates_.size());
    for (std::uint32_t s = 0; s < sides.size(); ++s) {
      const std::uint32_t from = corner(s), to = corner(next(s));
      sides[s] = {std::min(from, to), std::max(from, to), s};
      mates_[s] = none;
    }
    std::sort(sides.begin(), sides.end());
    for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
      const Side &a = sides[i], &b = sides[i + 1];
      if (a.low != b.low || a.high != b.high || corner(a.number) == corner(b.number)) continue;
      mates_[a.number] = b.number;
      mates_[b.number] = a.number;
      ++i;
    }
  }

  // Of the two angles at an edge: does their sum clearly exceed a straight one, and can the edge be
  // flipped?
  bool is_better_flipped(std::uint32_t side) const {
    const std::uint32_t mate = mates_[side];
    const std::uint32_t a = corner(side), b = corner(mate), p = corner(prev(side)),
                        q = corner(prev(mate));
    const Place at_a = exact_.seen(a), at_b = exact_.seen(b), at_p = exact_.seen(p),
                at_q = exact_.seen(q);
    const Angle here = angle(at_a, at_p, at_b), there = angle(at_b, at_q, at_a);
    const double sine = here.sine * there.cosine + here.cosine * there.sine;
    if (!(sine < -1e-9 * here.size * there.size)) return false;
    return exact_.turn(p, a, q) == Sign::positive && exact_.turn(q, b, p) == Sign::positive;
  }

  struct Angle {
    double sine, cosine, size;  // all of them times the lengths of the two sides
  };
  static Angle angle(const Place& from, const Place& at, const Place& to) {
    const double ux = from[0] - at[0], uy = from[1] - at[1], vx = to[0] - at[0], vy = to[1] - at[1];
    const double sine = ux * vy - uy * vx, cosine = ux * vx + uy * vy;
    return {sine, cosine, std::abs(sine) + std::abs(cosine)};
  }

  // Triangles (a, b, p) and (b, a, q) become (p, a, q) and (q, b, p).
  void flip(std::uint32_t side, std::vector<std::uint32_t>& open) {
    const std::uint32_t mate = mates_[side];
    const std::uint32_t a = corner(side), b = corner(mate), p = corner(prev(side)),
                        q = corner(prev(mate));
    const std::uint32_t beyond_bp = mates_[next(side)], beyond_pa = mates_[prev(side)],
                        beyond_aq = mates_[next(mate)], beyond_qb = mates_[prev(mate)];
    const std::uint32_t s = side - side % 3, t = mate - mate % 3;
    triangles_[first_ + s / 3] = {p, a, q};
    triangles_[first_ + t / 3] = {q, b, p};
    connect(s, beyond_pa);
    connect(s + 1, beyond_aq);
    connect(s + 2, t + 2);
    connect(t, beyond_qb);
    connect(t + 1, beyond_bp);
    open.insert(open.end(), {s, s + 1, t, t + 1});
  }
  void connect(std::uint32_t side, std::uint32_t mate) {
    mates_[side] = mate;
    if (mate != none) mates_[mate] = side;
  }

  const Predicates& exact_;
  std::vector<Triangle>& triangles_;
  std::size_t first_;
  std::vector<std::uint32_t> mates_;  // per side: the same one of the neighbour
};

}  // namespace sectile
