#include "real/winding_check.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>

namespace sectile::test {
namespace {

Vec3 minus(const Vec3& a, const Vec3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
double dot(const Vec3& a, const Vec3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

// Van Oosterom and Strackee.
double half_solid_angle(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double u = std::sqrt(dot(a, a)), v = std::sqrt(dot(b, b)), w = std::sqrt(dot(c, c));
  return std::atan2(dot(a, cross(b, c)), u * v * w + dot(a, b) * w + dot(b, c) * u + dot(c, a) * v);
}

template <class Visit>
void for_each_triangle(const PolygonMesh& mesh, const Visit& visit) {
  std::size_t first = 0;
  for (const std::uint32_t size : mesh.face_sizes) {
    for (std::size_t k = 1; k + 1 < size; ++k)
      visit(mesh.positions[mesh.indices[first]], mesh.positions[mesh.indices[first + k]],
            mesh.positions[mesh.indices[first + k + 1]]);
    first += size;
  }
}

struct Extent {
  Vec3 low, high;
  double size() const { return std::max({high.x - low.x, high.y - low.y, high.z - low.z}); }
};

Extent extent_of(const PolygonMesh& mesh) {
  constexpr double far = std::numeric_limits<double>::infinity();
  Extent e{{far, far, far}, {-far, -far, -far}};
  for (const std::uint32_t i : mesh.indices) {
    const Vec3& p = mesh.positions[i];
    e.low = {std::min(e.low.x, p.x), std::min(e.low.y, p.y), std::min(e.low.z, p.z)};
    e.high = {std::max(e.high.x, p.x), std::max(e.high.y, p.y), std::max(e.high.z, p.z)};
  }
  return e;
}

}  // namespace

std::vector<Vec3> sample_points(const PolygonMesh& mesh, std::size_t count) {
  std::mt19937_64 random(7);
  const auto part = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  const Extent e = extent_of(mesh);
  std::vector<std::array<Vec3, 3>> triangles;
  for_each_triangle(mesh, [&](const Vec3& a, const Vec3& b, const Vec3& c) {
    triangles.push_back({a, b, c});
  });
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < count; ++i) {
    if (i % 2 == 0 || triangles.empty()) {
      const auto within = [&](double low, double high) {
        return low + (1.1 * part() - 0.05) * (high - low);
      };
      points.push_back(
          {within(e.low.x, e.high.x), within(e.low.y, e.high.y), within(e.low.z, e.high.z)});
      continue;
    }
    const auto& [a, b, c] = triangles[random() % triangles.size()];
    double u = part(), v = part();
    if (u + v > 1) u = 1 - u, v = 1 - v;
    const double step = e.size() * std::pow(10.0, -2 - 3 * part());
    const auto beside = [&](double p, double q, double r) {
      return p + u * (q - p) + v * (r - p) + step * (2 * part() - 1);
    };
    points.push_back({beside(a.x, b.x, c.x), beside(a.y, b.y, c.y), beside(a.z, b.z, c.z)});
  }
  return points;
}

double winding_number(const PolygonMesh& mesh, const Vec3& point) {
  double sum = 0;
  for_each_triangle(mesh, [&](const Vec3& a, const Vec3& b, const Vec3& c) {
    sum += half_solid_angle(minus(a, point), minus(b, point), minus(c, point));
  });
  return sum / (2 * std::acos(-1.0));
}

Agreement check_points(const PolygonMesh& mesh, bool turned, const PolygonMesh& solid,
                       std::size_t points) {
  const std::vector<Vec3> at = sample_points(mesh, points);
  enum class Verdict : std::uint8_t { right, wrong, undecided };
  std::vector<Verdict> verdict(at.size());
  tbb::parallel_for(std::size_t(0), at.size(), [&](std::size_t i) {
    const double mine = winding_number(mesh, at[i]), result = winding_number(solid, at[i]);
    constexpr double clear = 1e-3;
    if (std::abs(mine - std::round(mine)) > clear || std::abs(result - std::round(result)) > clear)
      verdict[i] = Verdict::undecided;
    else if ((std::round(turned ? -mine : mine) >= 1) != (std::round(result) == 1))
      verdict[i] = Verdict::wrong;
    else
      verdict[i] = Verdict::right;
  });
  Agreement result;
  result.points = at.size();
  for (const Verdict v : verdict) {
    result.wrong += v == Verdict::wrong;
    result.undecided += v == Verdict::undecided;
  }
  return result;
}

}  // namespace sectile::test
