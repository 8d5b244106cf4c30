#include "search/bundle_order.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>

#include "search/approximate.h"

namespace sectile {
namespace {

using namespace approximate;

struct Ends {
  Vec3 at[2];
};

// The first one is the lower one along the axis along which they are farthest apart.
Ends ends_of(const OrientedBox& box) {
  const Vec3 half = box.extent[0] * box.axis[0];
  const std::array<double, 3> way{half.x, half.y, half.z};
  const double most = *std::max_element(
      way.begin(), way.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
  return most < 0 ? Ends{{box.centre + half, box.centre - half}}
                  : Ends{{box.centre - half, box.centre + half}};
}

// Ten bits of each of six coordinates, in turns.
std::uint64_t place_on_curve(const Ends& ends, const Vec3& low, double scale) {
  constexpr int bits = 10;
  std::array<std::uint64_t, 6> cell;
  for (std::size_t e = 0; e < 2; ++e) {
    const Vec3 off = ends.at[e] - low;
    const std::array<double, 3> x{off.x, off.y, off.z};
    for (std::size_t k = 0; k < 3; ++k) {
      const double in_cells = x[k] * scale * (1 << bits);
      cell[3 * e + k] = in_cells > 0 ? static_cast<std::uint64_t>(std::min(in_cells, 1023.0)) : 0;
    }
  }
  std::uint64_t place = 0;
  for (int bit = bits; bit-- > 0;)
    for (const std::uint64_t c : cell) place = place << 1 | (c >> bit & 1);
  return place;
}

}  // namespace

std::vector<std::uint32_t> order_in_bundles(std::span<const OrientedBox> boxes) {
  std::vector<Ends> ends;
  ends.reserve(boxes.size());
  Bounds bounds;
  for (const OrientedBox& box : boxes) {
    ends.push_back(ends_of(box));
    for (const Vec3& p : ends.back().at) bounds.add(p);
  }
  const Vec3 size = bounds.high - bounds.low;
  const double scale = 1 / std::max({size.x, size.y, size.z});
  std::vector<std::uint64_t> place;
  place.reserve(boxes.size());
  for (const Ends& e : ends) place.push_back(place_on_curve(e, bounds.low, scale));
  std::vector<std::uint32_t> order(boxes.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t i, std::uint32_t j) { return place[i] < place[j]; });
  return order;
}

}  // namespace sectile
