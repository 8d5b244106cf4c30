#include "import/triangles/enclosed_volume.h"

#include <functional>

#include "import/volume_sum.h"
#include "parallel/parallel.h"

namespace sectile {

bool encloses_volume(const TriangleMesh& mesh) {
  const Vec3 origin = mesh.position(0);
  const VolumeSum sum = parallel::reduce(
      tbb::blocked_range<std::size_t>(0, mesh.triangle_count(), 4096), VolumeSum(),
      [&](const auto& range, VolumeSum part) {
        for (std::size_t f = range.begin(); f < range.end(); ++f) {
          const auto first = static_cast<std::uint32_t>(3 * f);
          part.add(origin, mesh.position(first), mesh.position(first + 1),
                   mesh.position(first + 2));
        }
        return part;
      },
      std::plus<>());
  return sum.value() > sum.error();
}

}  // namespace sectile
