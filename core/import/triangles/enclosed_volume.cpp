#include "import/triangles/enclosed_volume.h"

namespace sectile {

bool encloses_volume(const TriangleMesh& mesh) {
  VolumeSum sum;
  for (const TriangleChunk& chunk : mesh.chunks) sum = sum + chunk.volume;
  return sum.value() > sum.error();
}

}  // namespace sectile
