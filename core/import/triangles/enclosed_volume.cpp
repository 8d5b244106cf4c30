#include "import/triangles/enclosed_volume.h"

#include <algorithm>
#include <cmath>

#include "numbers/rounding.h"
#include "parallel/parallel.h"
#include "search/box.h"

namespace sectile {
namespace {

struct Sum {
  double value = 0, size = 0;  // of six times the volume, and of its terms
};

double term(const Vec3& o, const Vec3& a, const Vec3& b, const Vec3& c) {
  const double x = a.x - o.x, y = a.y - o.y, z = a.z - o.z;
  const double p[3] = {b.x - o.x, b.y - o.y, b.z - o.z}, q[3] = {c.x - o.x, c.y - o.y, c.z - o.z};
  return x * (p[1] * q[2] - p[2] * q[1]) + y * (p[2] * q[0] - p[0] * q[2]) +
         z * (p[0] * q[1] - p[1] * q[0]);
}

Bounds bounds_of(const Geometry& geometry) {
  Bounds bounds;
  for (const Vec3& p : geometry.positions) bounds.add(p);
  return bounds;
}

}  // namespace

bool encloses_volume(const TriangleMesh& mesh) {
  const auto [low, high] = bounds_of(*mesh.geometry);
  const Sum sum = parallel::reduce(
      tbb::blocked_range<std::size_t>(0, mesh.triangle_count(), 4096), Sum(),
      [&, low = low](const auto& range, Sum part) {
        for (std::size_t f = range.begin(); f < range.end(); ++f) {
          const auto first = static_cast<std::uint32_t>(3 * f);
          const double t =
              term(low, mesh.position(first), mesh.position(first + 1), mesh.position(first + 2));
          part.value += t;
          part.size += std::abs(t);
        }
        return part;
      },
      [](const Sum& a, const Sum& b) {
        return Sum{a.value + b.value, a.size + b.size};
      });
  const double reach = std::max({high.x - low.x, high.y - low.y, high.z - low.z});
  const auto terms = static_cast<double>(mesh.triangle_count());
  // As for all shells (import/shells.cpp), whatever the order of the sum.
  const double error = 8 * rounding::unit * terms * (sum.size + reach * reach * reach) + 0x1p-1000;
  return sum.value > error;
}

}  // namespace sectile
