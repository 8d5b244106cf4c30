#include "rounding/wedge_groups.h"

#include <algorithm>

#include "selftest/wedge_order.h"

namespace sectile {
namespace {

// The directions in which wedges have their sides, as numbers counter-clockwise from some one.
class DirectionsOfSides {
 public:
  DirectionsOfSides(const Kernel& kernel, int axis, std::span<const EdgeSectors::Wedge> wedges) {
    std::vector<SideOfLine> sides;
    for (const auto& [left, right] : wedges) {
      sides.push_back({right.plane, false});
      sides.push_back({left.plane, true});
    }
    of_side_ = places_around(kernel, axis, sides);
    count_ = std::ranges::max(of_side_) + 1;
  }

  std::uint32_t count() const { return count_; }
  std::uint32_t of_right(std::size_t wedge) const { return of_side_[2 * wedge]; }
  std::uint32_t of_left(std::size_t wedge) const { return of_side_[2 * wedge + 1]; }
  std::uint32_t after(std::uint32_t direction) const {
    return direction + 1 < count_ ? direction + 1 : 0;
  }

  // Per direction: is there a wedge from it to the next one?
  std::vector<bool> wedges_after() const {
    std::vector<int> more(count_ + 1, 0);  // than before
    for (std::size_t i = 0; 2 * i < of_side_.size(); ++i) {
      ++more[of_right(i)];
      --more[of_left(i)];
      if (of_left(i) <= of_right(i)) ++more[0];
    }
    std::vector<bool> are_there;
    for (std::uint32_t d = 0, wedges = 0; d < count_; ++d)
      are_there.push_back((wedges += static_cast<std::uint32_t>(more[d])) > 0);
    return are_there;
  }

 private:
  std::vector<std::uint32_t> of_side_;  // right, left
  std::uint32_t count_ = 0;
};

}  // namespace

std::vector<WedgeGroup> groups_of_wedges(const Kernel& kernel, int axis,
                                         std::span<const EdgeSectors::Wedge> wedges) {
  if (wedges.empty()) return {};
  const DirectionsOfSides directions(kernel, axis, wedges);
  const std::vector<bool> wedges_after = directions.wedges_after();
  const auto gap = std::ranges::find(wedges_after, false);
  if (gap == wedges_after.end()) return {};
  const std::uint32_t start =
      directions.after(static_cast<std::uint32_t>(gap - wedges_after.begin()));
  std::vector<std::uint32_t> first, last, group(directions.count());
  for (std::uint32_t i = 0, d = start; i < directions.count(); ++i, d = directions.after(d)) {
    if (first.size() == last.size()) first.push_back(d);
    group[d] = static_cast<std::uint32_t>(first.size() - 1);
    if (!wedges_after[d]) last.push_back(d);
  }
  std::vector<WedgeGroup> groups(first.size());
  for (std::uint32_t i = 0; i < wedges.size(); ++i) {
    const std::uint32_t right = directions.of_right(i), left = directions.of_left(i),
                        g = group[right];
    groups[g].wedges.push_back(i);
    if (right == first[g]) groups[g].all.right = wedges[i].right;
    if (left == last[g]) groups[g].all.left = wedges[i].left;
  }
  return groups;
}

}  // namespace sectile
