// A solid's triangles with rounded corners.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/kernel.h"
#include "rounding/rounding_grid.h"
#include "selftest/self_test.h"
#include "selftest/triangle_surface.h"
#include "storage/solid_data.h"

namespace sectile {

/// Vertices are places of the solid's corners, numbered through. Each triangle has a plane of its
/// own through its rounded corners.
struct RoundedSurface {
  using Corners = std::array<std::uint32_t, 3>;

  RoundedSurface() = default;
  enum class Lines : std::uint8_t {
    divided,  ///< edges have the corners of others that lie on them
    apart     ///< edges on one line are separated, where they can be and would be much divided
  };
  /// May throw Cancelled.
  RoundedSurface(const SolidData& data, const RoundingGrid& grid, Lines lines,
                 const SelfTestControl& control);

  std::vector<Vec3> origin;            ///< per vertex: the place, rounded to doubles
  std::vector<std::uint8_t> is_exact;  ///< per vertex: `origin` is the place
  std::vector<PointId> point;          ///< per vertex: where it is now
  std::vector<Corners> corners;        ///< per triangle: vertices
  std::vector<FaceSource> source;      ///< per triangle
  std::vector<std::uint8_t> alive;     ///< per triangle
  /// Per vertex: has neighbours that are not here, and stays as it is. Empty: none has.
  std::vector<std::uint8_t> fixed;
  Geometry geometry;
  TriangleSurface surface;

  const Vec3& position(std::uint32_t vertex) const { return geometry.position(point[vertex]); }
  /// How many vertices of edges on common lines were moved apart?
  std::size_t moved_apart() const { return moved_apart_; }
  /// Is it a vertex of such an edge, at a place that was found for it?
  bool is_apart(std::uint32_t vertex) const {
    return vertex < is_apart_.size() && is_apart_[vertex];
  }
  /// Has rounding moved any vertex?
  bool anything_moved() const { return moved_; }

 private:
  bool moved_ = false;
  std::size_t moved_apart_ = 0;
  std::vector<bool> is_apart_;  // per vertex
};

}  // namespace sectile
