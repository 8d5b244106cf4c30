// A closed surface as triangles that know their neighbours: what the self-test looks at.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "numbers/id.h"

namespace sectile {

/// Edge k of a triangle runs from its corner k to the next one. All triangles of one face are in
/// one plane.
struct TriangleSurface {
  std::vector<std::array<PointId, 3>> corners;  ///< counter-clockwise, seen from outside
  std::vector<PlaneId> plane;
  std::vector<std::uint32_t> face;  ///< ascending
  /// Per face: its triangles may overlap, and are tested against each other. Empty: none may.
  std::vector<std::uint8_t> doubtful;
  /// Per edge: the triangle whose edge runs the other way between the same corners. If the edge is
  /// divided on one side only: `partial`, and any triangle of the face there.
  std::vector<std::array<std::uint32_t, 3>> mate;

  static constexpr std::uint32_t partial = 0x80000000u;
  std::uint32_t neighbour(std::uint32_t t, int k) const {
    return mate[t][static_cast<std::size_t>(k)] & ~partial;
  }
  /// Per triangle: known to meet other settled ones as it may. Empty: none is.
  std::vector<std::uint8_t> settled;
  /// Per triangle: not there, or without area; not tested. Empty: none is.
  std::vector<std::uint8_t> ignored;
  /// Per triangle: may it lie in one plane with a neighbour? Empty: each may.
  std::vector<std::uint8_t> flat;
  /// Are the triangles in an order in which those near each other have numbers near each other?
  bool along_curve = false;

  /// Is there nothing to be tested about two triangles?
  bool untested(std::uint32_t s, std::uint32_t t) const {
    if (face[s] == face[t] && (doubtful.empty() || doubtful[face[s]] == 0)) return true;
    if (!settled.empty() && settled[s] != 0 && settled[t] != 0) return true;
    return !ignored.empty() && (ignored[s] != 0 || ignored[t] != 0);
  }
  std::size_t size() const { return corners.size(); }
};

}  // namespace sectile
