// Triangles around a bent line: a chain of edges, each of which very many triangles have, as those
// of walls have along a slanted line whose corners were rounded.
//
//      \ |  /          Seen from a point of the chain, what is on the chain before it leaves in one
//     --\| /--         direction and what is after it in the opposite one, and so walls of both
//     ---|/---         parts are arcs that meet only if the walls go the same way. So of pairs of
//     --/|\---         triangles at two edges of the chain few are left, when it is halved again
//      / | \           and again; those at one edge are told apart around its line.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "geometry/kernel.h"
#include "search/edges_by_line.h"
#include "selftest/triangle_surface.h"

namespace sectile {

class ChainFans {
 public:
  static constexpr std::uint32_t none = 0xFFFFFFFFu;
  using Visit = std::function<void(std::uint32_t, std::uint32_t)>;

  /// Around chains of some edges, which very many triangles have, of some of the triangles. Chains
  /// that are straight, or nearly so, are left out.
  ChainFans(const TriangleSurface& surface, const Kernel& kernel,
            std::span<const std::uint32_t> triangles, std::span<const PointPair> edges);

  bool empty() const { return fans_.empty(); }
  std::size_t count() const { return fans_.size(); }
  /// Per triangle: its fan, or none. Empty if there is no fan.
  const std::vector<std::uint32_t>& of_triangle() const { return of_triangle_; }

  /// Parts of the work, which can be done side by side.
  std::size_t part_count() const { return parts_.size(); }
  /// Over all parts, calls visit(s, t) once or more often for each two triangles of one fan that do
  /// not certainly meet as they may, and some others.
  void for_each_pair(std::size_t part, const Visit& visit) const;

 private:
  // With an edge of the chain, and a corner beside it.
  struct Wing {
    std::uint32_t triangle, edge;
    PointId apex;
  };
  // With one corner on the chain.
  struct Spike {
    std::uint32_t triangle, at;
  };
  struct Fan {
    std::vector<std::uint32_t> chain;  // points
    std::vector<Wing> wings;           // by edges
    std::vector<Spike> spikes;         // by corners
    std::vector<Wing> by_apex;         // the same wings
    std::vector<std::uint32_t> others;
  };
  struct Part {
    enum class Kind : std::uint8_t { middle, edge, apex, others } kind;
    std::uint32_t fan;
    // Of a middle: between which corners of the chain it is looked around, and from which one; of
    // an apex, from and to which wing.
    std::int64_t low, high, at;
  };
  class View;

  static std::span<const Wing> wings_at(const Fan& fan, std::int64_t first_edge, std::int64_t end);
  bool is_bent(std::span<const std::uint32_t> chain) const;
  void gather(std::span<const std::uint32_t> triangles);
  void add(std::uint32_t triangle, std::uint32_t fan, std::span<const std::uint32_t> places);
  void add_parts(std::uint32_t fan);
  void halve(std::uint32_t fan, std::int64_t low, std::int64_t high);
  void look_from(const Part& part, const Visit& visit) const;
  void look_along(const Part& part, const Visit& visit) const;
  void look_from_apex(const Part& part, const Visit& visit) const;
  void look_at_others(const Part& part, const Visit& visit) const;

  const TriangleSurface& surface_;
  const Kernel& kernel_;
  std::vector<Fan> fans_;
  std::vector<std::uint32_t> of_triangle_;
  std::vector<Part> parts_;
};

}  // namespace sectile
