// Pairs of things that may meet where boxes of no kind say much: very many that are long and thin,
// and reach between each other in many directions. Space is divided by planes, as a binary space
// partition does it, until the things in each cell have few others beside them there.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "search/box_tree.h"

namespace sectile {

class SpacePartition {
 public:
  /// All points that are so near to a line segment, from its one end to the other.
  struct Rod {
    Vec3 from, to;
    std::array<double, 2> radius{};

    double radius_at(double share) const { return radius[0] + share * (radius[1] - radius[0]); }

    Rod() = default;
    /// Around the convex hull of some points, at least one, but for rounding.
    explicit Rod(std::span<const Vec3> points);
  };

  static constexpr std::uint32_t no_label = BoxTree::no_group;

  /// Where the things are what is seen from the origin, planes through it say most.
  enum class Planes { any, through_origin };

  /// The things are in their rods, but for half an ulp in each coordinate, and for what rounds a
  /// rod. Two of one label (per thing) are no pair.
  SpacePartition(std::vector<Rod> rods, std::vector<std::uint32_t> labels,
                 Planes planes = Planes::any);
  /// Where things are triangles, their corners tell more of those that are as wide as long.
  using Triangle = std::array<Vec3, 3>;
  SpacePartition(std::vector<Rod> rods, std::vector<std::uint32_t> labels,
                 std::vector<Triangle> triangles);

  /// Part of a thing, from and to where on its rod.
  struct Piece {
    std::uint32_t thing;
    double from, to;
  };
  /// What reaches into a part of space.
  struct Cell {
    std::vector<Piece> pieces;  // by labels
    std::size_t pairs = 0;      // of two labels
    std::uint32_t seed = 1;     // of the choice of planes
  };

  /// All of space, divided into so many parts that can be looked at side by side, or a few less.
  std::vector<Cell> cells(std::size_t least) const;
  /// Calls visit(thing, other thing) for all pairs that meet in a cell and for few others; some
  /// are visited several times.
  template <class Visit>
  void for_each_pair(const Cell& cell, const Visit& visit) const {
    if (const std::vector<Cell> parts = divided(cell); !parts.empty()) {
      for (const Cell& part : parts) for_each_pair(part, visit);
      return;
    }
    const BoxTree tree = tree_of(cell);
    for (const BoxTree::SelfPart& part : tree.self_parts(1))
      tree.self_overlaps(part, [&](std::uint32_t i, std::uint32_t j) {
        visit(cell.pieces[i].thing, cell.pieces[j].thing);
      });
  }

 private:
  struct Plane {
    Vec3 normal;  // about a unit vector
    double at = 0;
    Plane turned() const { return {{-normal.x, -normal.y, -normal.z}, -at}; }
  };
  class PairCount;
  class PlaneChoice;

  Cell whole() const;
  /// Nothing if no planes make the pairs fewer, or they are few.
  std::vector<Cell> divided(const Cell& cell) const;
  bool is_worth_dividing(const Cell& cell) const;
  static bool are_fewer(std::span<const Cell> parts, const Cell& whole);
  std::vector<Cell> halves(const Cell& cell) const;
  Cell below(const Plane& plane, const Cell& cell) const;
  std::optional<Piece> below(const Plane& plane, const Piece& piece) const;
  BoxTree tree_of(const Cell& cell) const;
  Box box_of(const Piece& piece) const;
  Vec3 at(const Piece& piece, double share) const;
  /// Is all of a thing certainly above a plane?
  bool is_above(const Plane& plane, std::uint32_t thing) const;

  std::vector<Rod> rods_;
  std::vector<std::uint32_t> labels_;
  Planes planes_;
  std::vector<Triangle> triangles_;  // or none
  bool is_certain_ = true;
};

}  // namespace sectile
