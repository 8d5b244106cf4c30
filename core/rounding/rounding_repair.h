// Makes a rounded surface legal where rounding made it meet itself.
#pragma once

#include <atomic>
#include <cstdint>
#include <vector>

#include "rounding/local_changes.h"
#include "rounding/rounded_surface.h"
#include "rounding/rounding_grid.h"

namespace sectile {

/// Finds the triangles that are not to be tested: those without area, and those that are not there.
void ignore_flat(RoundedSurface& rounded, const Kernel& kernel);

/// Triangles of which something is wrong, ascending. Ignores those without area, too.
std::vector<std::uint32_t> faulty_triangles(RoundedSurface& rounded, const Kernel& kernel,
                                            const SelfTestControl& control);

class RoundingRepair {
 public:
  /// Triangles without area are ignored already.
  RoundingRepair(RoundedSurface& rounded, Kernel& kernel, const RoundingGrid& grid,
                 const Rounding& options)
      : rounded_(rounded), changes_(rounded, kernel), grid_(grid), options_(options) {
    gone_to_.resize(rounded.point.size());
    for (std::uint32_t v = 0; v < gone_to_.size(); ++v) gone_to_[v] = v;
  }

  /// Changes what is near these triangles until nothing is wrong with them. Returns those for which
  /// no change nearby helps, or none that is found with reasonable effort.
  std::vector<std::uint32_t> run(std::vector<std::uint32_t> faulty);

  /// The vertex to which a vertex was joined, at last.
  std::uint32_t gone_to(std::uint32_t vertex) const {
    if (vertex >= gone_to_.size()) return vertex;  // came later
    while (gone_to_[vertex] != vertex) vertex = gone_to_[vertex];
    return vertex;
  }
  /// That of each.
  std::vector<std::uint32_t> gone_to() const {
    std::vector<std::uint32_t> to(gone_to_.size());
    for (std::uint32_t v = 0; v < to.size(); ++v) to[v] = gone_to(v);
    return to;
  }
  std::size_t merged() const { return merged_; }
  std::size_t flipped() const { return flipped_; }
  /// How far the surface moved where an edge became the other diagonal, and where.
  double widest_flip() const { return widest_flip_; }
  const Vec3& widest_flip_at() const { return widest_flip_at_; }

 private:
  struct Move {
    double distance;
    std::uint32_t vertex;
    Vec3 to;
  };

  std::vector<Move> moves(const std::vector<std::uint32_t>& vertices, double reach) const;
  void unite_places(const std::vector<std::uint32_t>& faulty);
  bool improve(std::uint32_t triangle, double reach);
  bool try_flips(std::uint32_t triangle, double reach);
  bool try_merges(const std::vector<std::uint32_t>& vertices, double reach);
  bool try_moves(const std::vector<std::uint32_t>& vertices, double reach);
  bool accept();
  bool is_hopeless() const { return changes_.tested_pairs() > most_tested_; }
  std::vector<std::uint32_t> vertices_near(std::uint32_t triangle) const;
  double distance(std::uint32_t vertex, const Vec3& to) const;
  bool may_go(std::uint32_t vertex, const Vec3& to) const;

  RoundedSurface& rounded_;
  LocalChanges changes_;
  const RoundingGrid& grid_;
  const Rounding& options_;
  std::vector<std::uint32_t> gone_to_;
  std::size_t merged_ = 0, flipped_ = 0;
  std::uint64_t most_tested_ = 0;  // pairs of triangles
  double widest_flip_ = 0;
  Vec3 widest_flip_at_;
};

}  // namespace sectile
