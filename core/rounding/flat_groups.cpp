#include "rounding/flat_groups.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "numbers/threshold.h"
#include "parallel/parallel.h"
#include "search/curve_order.h"

namespace sectile {
namespace {

// All boxes of a group are looked at where one is near.
constexpr std::uint32_t most_of_a_group = threshold(32, 4);

double size_of(const std::array<double, 3>& n) {
  return std::abs(n[0]) + std::abs(n[1]) + std::abs(n[2]);
}

}  // namespace

// Any normal is right; that of the largest triangle is nearest to those of the others.
Slab::Slab(std::span<const ViewedTriangle> triangles, double slack, double extent) {
  const auto largest = std::max_element(
      triangles.begin(), triangles.end(), [](const ViewedTriangle& s, const ViewedTriangle& t) {
        return size_of(s.plane.normal()) < size_of(t.plane.normal());
      });
  const double size = size_of(largest->plane.normal());
  // Underflow of products is nothing beside numbers of that order.
  if (!(size * extent > 0x1p-700 && size * extent < 0x1p700)) return;
  normal_ = largest->plane.normal();
  origin_ = largest->placed.at[0];
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const ViewedTriangle& t : triangles)
    for (const Vec3& p : t.placed.at) {
      low = std::min(low, value(p));
      high = std::max(high, value(p));
    }
  // Of the value of each of two corners: four roundings of half an ulp of at most size * extent,
  // and a move. Boxes reach beyond the extent by less than a fifth rounding takes in.
  const double off = (1 + 0x1p-40) * 2 * (5 * 0x1p-53 * size * extent + slack * size);
  low_ = low - off;
  high_ = high + off;
}

bool Slab::always_clear_of(const Box& box) const {
  const Vec3 low{box.low[0], box.low[1], box.low[2]}, high{box.high[0], box.high[1], box.high[2]};
  const auto farthest = [&](const Vec3& behind, const Vec3& ahead) {
    return value({normal_[0] < 0 ? behind.x : ahead.x, normal_[1] < 0 ? behind.y : ahead.y,
                  normal_[2] < 0 ? behind.z : ahead.z});
  };
  return farthest(low, high) < low_ || farthest(high, low) > high_;
}

FlatGroups::FlatGroups(const std::function<PlacedTriangle(std::uint32_t)>& triangle,
                       const std::vector<std::uint32_t>& ends, double slack, double extent)
    : slack_(slack) {
  gather(triangle, ends);
  triangles_.resize(number_.size());
  fours_.resize(first_four_.back());
  boxes_.resize(first_.size() - 1);
  slabs_.resize(boxes_.size());
  parallel::loop(parallel::Range<std::uint32_t>(0, count(), 128), [&](const auto& range) {
    for (std::uint32_t g = range.begin(); g < range.end(); ++g) look_at(g, triangle, slack, extent);
  });
  index_ = BoxIndex(boxes_, true);
}

const OrientedIndex& FlatGroups::oriented() const {
  oriented_->once.run([&] {
    oriented_->index = OrientedIndex(count(), 2 * slack_, [&](std::uint32_t g, const auto& add) {
      for (std::uint32_t i = first_[g]; i < first_[g + 1]; ++i)
        for (const Vec3& p : triangles_[i].placed.at) add(p);
    });
  });
  return oriented_->index;
}

// Those of a large face are put along a curve first.
void FlatGroups::gather(const std::function<PlacedTriangle(std::uint32_t)>& triangle,
                        const std::vector<std::uint32_t>& ends) {
  number_.resize(ends.empty() ? 0 : ends.back());
  std::iota(number_.begin(), number_.end(), 0u);
  first_.assign(1, 0);
  first_four_.assign(1, 0);
  for (const std::uint32_t end : ends) {
    std::uint32_t first = first_.back();
    if (end - first > most_of_a_group) {
      std::vector<Box> boxes;
      for (std::uint32_t i = first; i < end; ++i) boxes.push_back(box_around(triangle(i), 0));
      for (std::uint32_t k = first; const std::uint32_t i : order_along_curve(boxes))
        number_[k++] = first + i;
    }
    for (std::uint32_t size = 0; first < end; first += size) {
      size = std::min(end - first, most_of_a_group);
      first_.push_back(first + size);
      first_four_.push_back(first_four_.back() + (size + 3) / 4);
    }
  }
}

void FlatGroups::look_at(std::uint32_t group,
                         const std::function<PlacedTriangle(std::uint32_t)>& triangle, double slack,
                         double extent) {
  const std::uint32_t first = first_[group], size = first_[group + 1] - first;
  for (std::uint32_t i = 0; i < size; ++i) {
    ViewedTriangle& viewed = triangles_[first + i];
    viewed = ViewedTriangle(triangle(number_[first + i]), slack);
    if (!viewed.view.clear()) continue;
    const Box box = box_around(viewed.placed, 2 * slack);
    fours_[first_four_[group] + i / 4].set(i % 4, box);
    boxes_[group].add(box);
  }
  slabs_[group] = Slab(std::span(triangles_).subspan(first, size), slack, extent);
}

FlatGroups::Members FlatGroups::beside(std::uint32_t group, const Slab& slab, Members among) const {
  Members found = 0;
  for (; among != 0; among &= among - 1) {
    const auto i = static_cast<std::uint32_t>(std::countr_zero(among));
    if (slab.always_clear_of(triangles_[first_[group] + i].placed)) found |= Members(1) << i;
  }
  return found;
}

}  // namespace sectile
