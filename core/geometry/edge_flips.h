// Better-shaped triangles: edges between two triangles are flipped as long as the angles that they
// face make more than a straight one (C. L. Lawson, Software for C1 surface interpolation, 1977).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "numbers/rounding.h"
#include "numbers/sign.h"

namespace sectile {

/// Is one of several triangles far thinner than long, as far as doubles tell? One alone is what it
/// is. Only the shape depends on it. exact.seen(corner) gives about where a corner is.
template <class Predicates>
bool any_sliver(const Predicates& exact, std::span<const std::array<std::uint32_t, 3>> triangles) {
  if (triangles.size() < 2) return false;
  constexpr double thinness = 0x1p-20;
  return std::any_of(triangles.begin(), triangles.end(), [&](const auto& t) {
    const auto a = exact.seen(t[0]), b = exact.seen(t[1]), c = exact.seen(t[2]);
    const double ux = b[0] - a[0], uy = b[1] - a[1], vx = c[0] - a[0], vy = c[1] - a[1];
    const double wx = vx - ux, wy = vy - uy;
    const double longest = std::max({ux * ux + uy * uy, vx * vx + vy * vy, wx * wx + wy * wy});
    return std::abs(ux * vy - uy * vx) < thinness * longest;
  });
}

/// Doubles decide which edges would better be flipped, and only the shape depends on them; exact
/// turns decide which ones can be. No edge of the region's boundary is flipped, and each triangle
/// stays in the sector of its corner that it is in.
template <class Predicates>
class EdgeFlips {
 public:
  using Triangle = std::array<std::uint32_t, 3>;

  /// Counter-clockwise triangles of a region, those from `first` on: see triangulate().
  /// exact.seen(corner) gives about where a corner is, in the order of the turns.
  EdgeFlips(const Predicates& exact, std::span<const std::uint32_t> loop_ends,
            std::vector<Triangle>& triangles, std::size_t first)
      : exact_(exact),
        triangles_(triangles),
        first_(first),
        mates_(3 * (triangles.size() - first)) {
    for (const std::uint32_t end : loop_ends)
      for (const auto begin = static_cast<std::uint32_t>(at_.size()); at_.size() < end;) {
        const auto c = static_cast<std::uint32_t>(at_.size());
        at_.push_back(exact.seen(c));
        after_.push_back(c + 1 < end ? c + 1 : begin);
      }
    find_mates();
  }

  void run() {
    std::vector<std::uint32_t> open(mates_.size());
    for (std::uint32_t i = 0; i < open.size(); ++i)
      open[i] = static_cast<std::uint32_t>(open.size()) - 1 - i;
    // As a rule there are one or two for each side. In the worst case there are n²: then shapes are
    // left as good as time linear in n makes them.
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

  // Sides that leave a corner or lead to it are its own if it is the lower one.
  void find_mates() {
    std::vector<std::uint32_t> end(at_.size() + 1, 0);
    const auto low = [&](std::uint32_t side) { return std::min(corner(side), corner(next(side))); };
    const auto high = [&](std::uint32_t side) {
      return std::max(corner(side), corner(next(side)));
    };
    for (std::uint32_t s = 0; s < mates_.size(); ++s) ++end[low(s) + 1];
    for (std::size_t c = 1; c < end.size(); ++c) end[c] += end[c - 1];
    std::vector<std::pair<std::uint32_t, std::uint32_t>> sides(mates_.size());  // higher corner
    for (std::uint32_t s = 0; s < mates_.size(); ++s) {
      sides[end[low(s)]++] = {high(s), s};
      mates_[s] = none;
    }
    for (std::size_t c = 0, from = 0; c + 1 < end.size(); from = end[c++])
      match(std::span(sides).subspan(from, end[c] - from));
  }
  // A slit has borders on both sides.
  bool is_border(std::uint32_t side) const { return after_[corner(side)] == corner(next(side)); }

  void match(std::span<std::pair<std::uint32_t, std::uint32_t>> sides) {
    std::sort(sides.begin(), sides.end());
    for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
      const auto [to, s] = sides[i];
      const auto [also_to, t] = sides[i + 1];
      if (to != also_to || corner(s) == corner(t) || is_border(s) || is_border(t)) continue;
      mates_[s] = t;
      mates_[t] = s;
      ++i;
    }
  }

  // Does each of the two triangles certainly have the other's apex within its circle, so that the
  // two angles at an edge make more than a straight one, and can the edge be flipped? What is
  // summed up over all triangles, the volume under them on a paraboloid, falls with each flip: so
  // none comes again.
  bool is_better_flipped(std::uint32_t side) const {
    const std::uint32_t mate = mates_[side];
    const std::uint32_t a = corner(side), b = corner(mate), p = corner(prev(side)),
                        q = corner(prev(mate));
    const Angle here(at_[a], at_[p], at_[b]), there(at_[b], at_[q], at_[a]);
    const double sine = here.sine * there.cosine + here.cosine * there.sine;
    const double weight =
        here.sine_weight * there.cosine_weight + here.cosine_weight * there.sine_weight;
    // In each term: two differences, a product and a sum in both factors, their product and the
    // sum, ten roundings of half an ulp, with room; and what underflow takes of numbers up to
    // 2^400. What is larger, or not finite, stays as it is.
    constexpr double most = 0x1p400;
    if (!(here.weight() < most && there.weight() < most)) return false;
    if (!(sine < -(16 * rounding::unit * weight + 0x1p-600))) return false;
    return exact_.turn(p, a, q) == Sign::positive && exact_.turn(q, b, p) == Sign::positive;
  }

  // Sine and cosine times the lengths of both sides, and what their terms sum up to without signs.
  struct Angle {
    double sine, cosine, sine_weight, cosine_weight;
    double weight() const { return sine_weight + cosine_weight; }

    Angle(const Place& from, const Place& at, const Place& to) {
      const double ux = from[0] - at[0], uy = from[1] - at[1], vx = to[0] - at[0],
                   vy = to[1] - at[1];
      sine = ux * vy - uy * vx;
      cosine = ux * vx + uy * vy;
      sine_weight = std::abs(ux * vy) + std::abs(uy * vx);
      cosine_weight = std::abs(ux * vx) + std::abs(uy * vy);
    }
  };

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
  std::vector<Place> at_;             // per corner
  std::vector<std::uint32_t> after_;  // per corner: the next one of its loop
  std::vector<std::uint32_t> mates_;  // per side: the same one of the neighbour
};

}  // namespace sectile
