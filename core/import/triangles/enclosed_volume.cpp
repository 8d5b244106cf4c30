#include "import/triangles/enclosed_volume.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "numbers/rounding.h"
#include "parallel/parallel.h"

namespace sectile {
namespace {

// Of six times the volume.
struct Sum {
  double value = 0;
  double size = 0;   // of its terms
  double reach = 0;  // the largest coordinate beside the origin of the terms

  void add(const Vec3& o, const Vec3& a, const Vec3& b, const Vec3& c) {
    const double p[3] = {a.x - o.x, a.y - o.y, a.z - o.z}, q[3] = {b.x - o.x, b.y - o.y, b.z - o.z},
                 r[3] = {c.x - o.x, c.y - o.y, c.z - o.z};
    const double term = p[0] * (q[1] * r[2] - q[2] * r[1]) + p[1] * (q[2] * r[0] - q[0] * r[2]) +
                        p[2] * (q[0] * r[1] - q[1] * r[0]);
    value += term;
    size += std::abs(term);
    for (int k = 0; k < 3; ++k)
      reach = std::max({reach, std::abs(p[k]), std::abs(q[k]), std::abs(r[k])});
  }
  friend Sum operator+(const Sum& a, const Sum& b) {
    return {a.value + b.value, a.size + b.size, std::max(a.reach, b.reach)};
  }
};

}  // namespace

bool encloses_volume(const TriangleMesh& mesh) {
  const Vec3 origin = mesh.position(0);
  const Sum sum = parallel::reduce(
      tbb::blocked_range<std::size_t>(0, mesh.triangle_count(), 4096), Sum(),
      [&](const auto& range, Sum part) {
        for (std::size_t f = range.begin(); f < range.end(); ++f) {
          const auto first = static_cast<std::uint32_t>(3 * f);
          part.add(origin, mesh.position(first), mesh.position(first + 1),
                   mesh.position(first + 2));
        }
        return part;
      },
      std::plus<>());
  const auto terms = static_cast<double>(mesh.triangle_count());
  // As for all shells (import/shells.cpp), whatever the order of the sum.
  const double error =
      8 * rounding::unit * terms * (sum.size + sum.reach * sum.reach * sum.reach) + 0x1p-1000;
  return sum.value > error;
}

}  // namespace sectile
