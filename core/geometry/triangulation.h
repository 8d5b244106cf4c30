// Triangles of plane faces with holes, and the orientation of their loops.
//
// Coordinates are never seen. The corners of a face are numbered through, loop after loop, and
// everything is decided by two exact tests on corner numbers that the caller provides:
//   compare(i, j)   positive if corner j comes after corner i in the order of the first and then
//                   the second coordinate of the plane; zero if they are at the same place;
//   turn(i, j, k)   positive if the path i, j, k turns left.
#pragma once

#include <array>
#include <concepts>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/ear_clipping.h"
#include "geometry/edge_flips.h"
#include "geometry/region_sweep.h"
#include "numbers/sign.h"

namespace sectile {

template <class T>
concept CornerPredicates = requires(const T& exact, std::uint32_t corner) {
  { exact.compare(corner, corner) } -> std::same_as<Sign>;
  { exact.turn(corner, corner, corner) } -> std::same_as<Sign>;
};

/// Predicates that tell which turns are clear at once, from rounded places: clear_turn(i, j, k) is
/// zero if that takes more.
template <class T>
concept ClearPredicates = requires(const T& exact, std::uint32_t corner) {
  { exact.clear_turn(corner, corner, corner) } -> std::same_as<Sign>;
};

template <ClearPredicates Predicates>
struct ClearTurns {
  const Predicates& exact;
  Sign turn(std::uint32_t i, std::uint32_t j, std::uint32_t k) const {
    return exact.clear_turn(i, j, k);
  }
};

/// Cuts ears off a loop of few corners: if that is enough, ears that are clear, and no slivers at
/// corners of nearly 180°, whose turns take most of the time and which any rounding turns over.
template <CornerPredicates Predicates>
bool cut_ears(const Predicates& exact, std::uint32_t corners,
              std::vector<std::array<std::uint32_t, 3>>& triangles) {
  if constexpr (ClearPredicates<Predicates>) {
    const ClearTurns<Predicates> clear{exact};
    if (EarClipping(clear, corners).run(triangles)) return true;
  }
  return EarClipping(exact, corners).run(triangles);
}

/// Appends triangles that cover a region exactly once: of positive area, counter-clockwise, as
/// three corner numbers. Loop k has the corners loop_ends[k - 1] to loop_ends[k] - 1; the region
/// lies to the left of every edge. Loops may touch themselves and each other in places and on
/// edges, contain slits and corners of 180°.
///
/// Every edge of a loop is the edge of exactly one triangle, except that an edge which a corner
/// touches from the region's side is divided there, and that edges which run on each other with no
/// region between them have no triangles between them. Where loops touch in a place, several
/// corners stand for it, and the triangles of one sector use the corner that its first edge leaves.
///
/// Takes O(n log n). Loops that bound no region are a defect of the caller; where the sweep notices
/// it, InternalError is thrown.
template <CornerPredicates Predicates>
void triangulate(const Predicates& exact, std::span<const std::uint32_t> loop_ends,
                 std::vector<std::array<std::uint32_t, 3>>& triangles) {
  if (loop_ends.size() == 1 && loop_ends[0] <= EarClipping<Predicates>::most_corners) {
    if (loop_ends[0] == 3) {
      triangles.push_back({0, 1, 2});
      return;
    }
    if (loop_ends[0] > 3 && cut_ears(exact, loop_ends[0], triangles)) return;
  }
  RegionSweep(exact, loop_ends, triangles).run();
}

/// The same with triangles of better shape, where the region has many corners or some triangle is a
/// sliver: those through half of the region would have boxes that overlap everything, and any
/// rounding turns over the one that is cut off at a corner of nearly 180°. Predicates have seen()
/// as well, see EdgeFlips.
template <CornerPredicates Predicates>
void triangulate_in_shape(const Predicates& exact, std::span<const std::uint32_t> loop_ends,
                          std::vector<std::array<std::uint32_t, 3>>& triangles) {
  const std::size_t first = triangles.size();
  triangulate(exact, loop_ends, triangles);
  if (triangles.size() - first > EarClipping<Predicates>::most_corners ||
      any_sliver(exact, std::span(triangles).subspan(first)))
    EdgeFlips(exact, loop_ends, triangles, first).run();
}

/// The orientation of the loop of the corners first to end - 1: positive if it is
/// counter-clockwise, negative if it is clockwise or consists of slits only (as an inner loop).
/// The loop may touch itself, but not cross itself.
template <CornerPredicates Predicates>
Sign orientation(const Predicates& exact, std::uint32_t first, std::uint32_t end) {
  // Counts by how many half turns the edges turn left on the way round. Only where the order of
  // the corners is reversed is there a doubt; at the tip of a slit the path turns right.
  const auto next = [&](std::uint32_t corner) { return corner + 1 == end ? first : corner + 1; };
  int half_turns = 0;
  Sign first_direction = Sign::zero, direction = Sign::zero;
  std::uint32_t first_tail = first, tail = first;
  const auto follow = [&](std::uint32_t corner, Sign edge) {
    if (edge != direction) {
      half_turns += exact.turn(tail, corner, next(corner)) == Sign::positive ? 1 : -1;
    }
    direction = edge;
    tail = corner;
  };
  for (std::uint32_t corner = first; corner < end; ++corner) {
    const Sign edge = exact.compare(corner, next(corner));
    if (edge == Sign::zero) continue;
    if (direction == Sign::zero) {
      first_direction = direction = edge;
      first_tail = tail = corner;
    } else {
      follow(corner, edge);
    }
  }
  if (direction != Sign::zero) follow(first_tail, first_direction);
  return sign_of(half_turns);
}

}  // namespace sectile
