#include "import/unite_positions.h"

#include <atomic>
#include <bit>
#include <numeric>

#include "parallel/parallel.h"
#include "search/equal_elements.h"

namespace sectile {
namespace {

std::uint32_t hash_of(const Vec3& p) {
  std::uint64_t h = 0;
  for (const double v : {p.x, p.y, p.z}) {
    h = (h ^ std::bit_cast<std::uint64_t>(v + 0.0)) * 0x9E3779B97F4A7C15u;  // -0 as 0
    h ^= h >> 32;
  }
  return static_cast<std::uint32_t>(h);
}

template <class Body>
void for_each(std::size_t count, const Body& body) {
  parallel::loop(parallel::Range<std::uint32_t>(0, static_cast<std::uint32_t>(count), 4096),
                 [&](const auto& range) {
                   for (std::uint32_t i = range.begin(); i < range.end(); ++i) body(i);
                 });
}

}  // namespace

std::vector<std::uint32_t> first_equals(std::span<const Vec3> positions) {
  std::vector<std::uint32_t> first(positions.size());
  std::iota(first.begin(), first.end(), 0u);
  std::atomic<bool> any = false;
  for_each_equal(
      positions.size(), [&](std::uint32_t i) { return hash_of(positions[i]); },
      [&](std::uint32_t i, std::uint32_t j) { return positions[i] == positions[j]; },
      [&](std::uint32_t earlier, std::uint32_t i) {
        first[i] = earlier;
        any.store(true, std::memory_order_relaxed);
      });
  if (!any) first.clear();
  return first;
}

std::vector<PointId> unite_positions(std::span<const Vec3> positions, Geometry& geometry,
                                     std::vector<std::uint32_t>& input_vertex) {
  const std::vector<std::uint32_t> first = first_equals(positions);
  std::vector<PointId> points(positions.size());
  input_vertex.reserve(positions.size());
  for (std::uint32_t i = 0; i < positions.size(); ++i) {
    if (first.empty() || first[i] == i) {
      points[i] = PointId(input_vertex.size());
      input_vertex.push_back(i);
    } else {
      points[i] = points[first[i]];
    }
  }
  geometry.positions.resize(input_vertex.size());
  geometry.construct.assign(input_vertex.size(), Geometry::explicit_point);
  for_each(input_vertex.size(), [&](std::uint32_t p) {
    const Vec3& at = positions[input_vertex[p]];
    geometry.positions[PointId(p)] = {at.x + 0.0, at.y + 0.0, at.z + 0.0};
  });
  return points;
}

}  // namespace sectile
