// The few shapes that the samples are made of, with all corners written down by the caller.
#pragma once

#include <vector>

#include "sectile/mesh.h"

namespace sectile::samples {

struct Corner {
  double u = 0, v = 0;
};

PolygonMesh block(const Vec3& low, const Vec3& high);
/// A profile (x, z), counter-clockwise with z up, from y = from to y = to.
PolygonMesh along_y(const std::vector<Corner>& profile, double from, double to);
/// The same with both ends cut into pieces, each a list of corners of the profile.
PolygonMesh along_y(const std::vector<Corner>& profile,
                    const std::vector<std::vector<std::uint32_t>>& pieces, double from, double to);
/// A profile (y, z), counter-clockwise with z up, from x = from to x = to.
PolygonMesh along_x(const std::vector<Corner>& profile, double from, double to);
/// The base counter-clockwise as seen from outside.
PolygonMesh cone(const Vec3& apex, const std::vector<Vec3>& base);

}  // namespace sectile::samples
