#include "rounding/enclosed_volume.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "parallel/parallel.h"

namespace sectile {
namespace {

struct Sums {
  double sum = 0, size = 0, reach = 1;

  void add(const double (&p)[3][3]) {
    for (int k = 0; k < 3; ++k) {
      const int i = (k + 1) % 3, j = (k + 2) % 3;
      const double left = p[0][k] * p[1][i] * p[2][j], right = p[0][k] * p[1][j] * p[2][i];
      sum += left - right;
      size += std::abs(left) + std::abs(right);
    }
  }
};

}  // namespace

bool clearly_encloses_volume(std::span<const Vec3> positions,
                             std::span<const std::uint32_t> indices) {
  if (indices.empty()) return false;
  const Vec3 o = positions[indices.front()];
  const std::size_t count = indices.size() / 3;
  constexpr std::size_t step = 4096;
  std::vector<Sums> sums((count + step - 1) / step);
  parallel::loop(0, sums.size(), [&](std::size_t s) {
    Sums& mine = sums[s];
    for (std::size_t t = s * step; t < std::min(count, (s + 1) * step); ++t) {
      double p[3][3];
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3& v = positions[indices[3 * t + k]];
        p[k][0] = v.x - o.x;
        p[k][1] = v.y - o.y;
        p[k][2] = v.z - o.z;
        for (const double along : p[k]) mine.reach = std::max(mine.reach, std::abs(along));
      }
      mine.add(p);
    }
  });
  Sums all;
  for (const Sums& s : sums) {
    all.sum += s.sum;
    all.size += s.size;
    all.reach = std::max(all.reach, s.reach);
  }
  // Products that underflow are off by the least double times a third factor.
  return all.sum > 0x1p-20 * all.size && all.size > 0x1p-900 * all.reach && count < 0x1p28;
}

}  // namespace sectile
