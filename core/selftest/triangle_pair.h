// Do two triangles of a surface meet as those of a solid do?
#pragma once

#include <array>
#include <optional>

#include "geometry/kernel.h"
#include "selftest/self_test.h"
#include "selftest/triangle_surface.h"

namespace sectile {

/// They may touch in points and edges. They do not where their interiors have a point in common, or
/// where around a line, on which they have an edge, the material does not alternate with the
/// outside.
class TrianglePairs {
 public:
  TrianglePairs(const TriangleSurface& surface, const Kernel& kernel)
      : surface_(surface), kernel_(kernel) {}

  /// Nothing if all is well.
  std::optional<SelfContact> test(std::uint32_t s, std::uint32_t t) const;

 private:
  using Signs = std::array<Sign, 3>;

  /// Do doubles tell that all corners but those on the plane are on one side of it?
  bool clearly_on_one_side(std::uint32_t t, const std::array<bool, 3>& on_it, PlaneId plane) const;
  bool is_on_plane(PointId point, PlaneId plane) const;
  std::optional<SelfContact> test_edge(std::uint32_t s, std::uint32_t t,
                                       const std::array<int, 3>& shared) const;
  std::optional<SelfContact> test_plane(std::uint32_t s, std::uint32_t t) const;
  std::optional<SelfContact> test_chords(std::uint32_t s, const Signs& sides_s, std::uint32_t t,
                                         const Signs& sides_t) const;
  bool separates(std::uint32_t s, std::uint32_t t, int axis) const;
  bool alternates(std::uint32_t s, int edge_s, std::uint32_t t, int edge_t, int axis) const;
  bool forward(std::uint32_t t, int edge, int axis) const;
  SelfContact contact(std::uint32_t s, std::uint32_t t, SelfContact::Kind kind,
                      const Vec3& where) const;
  Vec3 middle(std::uint32_t t) const;

  const TriangleSurface& surface_;
  const Kernel& kernel_;
};

}  // namespace sectile
