// What was joined to plane faces on import, as it was read.
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "geometry/geometry.h"

namespace sectile {

/// The triangles of all faces that were joined. Polygons of more corners were triangulated.
struct FacesAsRead {
  struct Triangle {
    std::uint32_t joined;  ///< FaceSource::face of the joined face
    std::uint32_t source;  ///< the face of the input
    std::array<PointId, 3> corners;
  };
  Geometry geometry;
  std::vector<Triangle> triangles;  ///< sorted by joined, then by source

  /// The triangles of a joined face; none if the face was read as it is.
  std::span<const Triangle> of(std::uint32_t joined) const {
    const auto [first, end] =
        std::equal_range(triangles.begin(), triangles.end(), Triangle{joined, 0, {}},
                         [](const Triangle& s, const Triangle& t) { return s.joined < t.joined; });
    return {first, end};
  }
};

}  // namespace sectile
