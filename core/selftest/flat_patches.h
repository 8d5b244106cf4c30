// Large plane pieces of a surface, and what stands on them.
//
//            .        Many triangles in one plane are slivers, as a rule, whose boxes overlap those
//           /|\       of all that stands on them, by the million: the sides of a cone on its base,
//          / | \      the walls of holes through a plate. One look at the piece's plane settles all
//     ----/--|--\---- pairs of such a triangle and the piece.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/kernel.h"
#include "search/box.h"
#include "selftest/triangle_surface.h"

namespace sectile {

/// Triangles of one plane that hang together and do not overlap.
struct FlatPatch {
  std::vector<std::uint32_t> triangles;  ///< ascending
  PlaneId plane;
};

class FlatPatches {
 public:
  static constexpr std::uint32_t none = 0xFFFFFFFFu;

  FlatPatches(const TriangleSurface& surface, const Kernel& kernel);

  std::size_t count() const { return patches_.size(); }
  const FlatPatch& operator[](std::size_t patch) const { return patches_[patch]; }
  /// Per triangle: its patch, or none. Empty if there is no patch.
  const std::vector<std::uint32_t>& of_triangle() const { return of_triangle_; }
  /// All triangles that are in no patch and not ignored.
  std::vector<std::uint32_t> rest() const;

  /// True: a triangle of no patch, or of another one, meets the plane of this one at most in a
  /// point, or in an edge beyond which the patch begins. Nothing is to be tested about them, then.
  bool stands_on(std::uint32_t t, std::size_t patch) const;
  /// Are doubles sure that the plane of a patch leaves a box on one side?
  bool is_beside(const Box& box, std::size_t patch) const;

 private:
  void number();

  const TriangleSurface& surface_;
  const Kernel& kernel_;
  std::vector<FlatPatch> patches_;
  std::vector<std::uint32_t> of_triangle_;
  std::vector<std::uint32_t> at_point_;  // per point: a patch of which it is a corner
};

}  // namespace sectile
