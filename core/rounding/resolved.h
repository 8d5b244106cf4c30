// What triangles bound that cross and overlap each other.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "arrangement/steering.h"
#include "storage/solid_data.h"

namespace sectile {

/// Closed and oriented, as chains: triangles without area and edges that only lie on each other are
/// allowed.
struct TriangleSoup {
  std::vector<Vec3> positions;
  std::vector<std::array<std::uint32_t, 3>> corners;
  std::vector<FaceSource> source;  ///< per triangle
};

/// The points around which the triangles go at least once, exactly; parts that are inside out as a
/// whole are turned. Faces keep their sources. None: the triangles bound nothing.
std::shared_ptr<const SolidData> resolved(const TriangleSoup& soup,
                                          const arrangement::Steering& steering);

}  // namespace sectile
