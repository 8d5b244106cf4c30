// Can a written mesh be the surface of a solid no point of which moved farther than is reported?
// What two surfaces so near each other enclose is bounded by area and move.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include "sectile/rounding.h"
#include "sectile/solid.h"

namespace sectile::test {

struct EnclosedVolume {
  long double value = 0, error = 0;
};

inline EnclosedVolume enclosed_volume(const PolygonMesh& mesh) {
  long double sum = 0, size = 0;
  const auto corner = [&](std::size_t i, int axis) {
    const Vec3 &p = mesh.positions[mesh.indices[i]], &o = mesh.positions[mesh.indices[0]];
    const double at[] = {p.x, p.y, p.z}, from[] = {o.x, o.y, o.z};
    return static_cast<long double>(at[axis]) - static_cast<long double>(from[axis]);
  };
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
    for (int k = 0; k < 3; ++k) {
      const int l = (k + 1) % 3, m = (k + 2) % 3;
      const long double left = corner(i, k) * corner(i + 1, l) * corner(i + 2, m),
                        right = corner(i, k) * corner(i + 1, m) * corner(i + 2, l);
      sum += left - right;
      size += std::abs(left) + std::abs(right);
    }
  return {sum / 6, size * 0x1p-50L};
}

/// What is wrong, in words; empty if nothing is.
inline std::string shape_fault(const Solid& solid, const RoundedMesh& rounded) {
  const long double move = rounded.report.largest_move, area = solid.area();
  const EnclosedVolume mesh = enclosed_volume(rounded.mesh);
  // Where the surface bends, the second power counts, too.
  const long double bound =
      2 * area * move + 100 * std::sqrt(area) * move * move + 100 * move * move * move + mesh.error;
  const long double difference = std::abs(mesh.value - solid.volume());
  if (difference <= bound) return "";
  return "a volume of " + std::to_string(solid.volume()) + " became " +
         std::to_string(static_cast<double>(mesh.value)) + ", where corners moved by " +
         std::to_string(rounded.report.largest_move) + " at most: that explains " +
         std::to_string(static_cast<double>(bound));
}

}  // namespace sectile::test
