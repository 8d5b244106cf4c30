#include "rounding/flat_groups.h"

#include <algorithm>
#include <cmath>

#include "parallel/parallel.h"
#include "search/curve_order.h"

namespace sectile {
namespace {

// All boxes of a group are looked at where one is near.
constexpr std::uint32_t most_of_a_group = 32;
// Around hubs, and where all is long and thin, nearly all groups would be selected again and again.
constexpr std::uint32_t most_to_select_from = 4096;

double size_of(const std::array<double, 3>& n) {
  return std::abs(n[0]) + std::abs(n[1]) + std::abs(n[2]);
}

struct Group {
  std::uint32_t first, end;  // of those that are chosen
};

Group piece(std::uint32_t first, std::uint32_t end) {
  return {first, std::min(end, first + most_of_a_group)};
}

// Those of a large face are put along a curve first.
std::vector<Group> groups_of(std::vector<std::uint32_t>& chosen, const std::vector<Box>& boxes,
                             const std::vector<std::uint32_t>& ends) {
  std::vector<Group> groups;
  groups.reserve(ends.size());
  std::uint32_t first = 0;
  for (const std::uint32_t end : ends) {
    if (end - first > most_of_a_group) {
      const std::vector<std::uint32_t> face(chosen.begin() + first, chosen.begin() + end);
      std::vector<Box> of_face;
      for (const std::uint32_t i : face) of_face.push_back(boxes[i]);
      for (std::uint32_t k = first; const std::uint32_t i : order_along_curve(of_face))
        chosen[k++] = face[i];
    }
    for (; first < end; first = groups.back().end) groups.push_back(piece(first, end));
  }
  return groups;
}

}  // namespace

Box box_around(const PlacedTriangle& triangle, double wider) {
  Bounds bounds;
  for (const Vec3& p : triangle.at) bounds.add(p);
  bounds.low = {bounds.low.x - wider, bounds.low.y - wider, bounds.low.z - wider};
  bounds.high = {bounds.high.x + wider, bounds.high.y + wider, bounds.high.z + wider};
  return bounds.box();
}

// Any normal is right; that of the largest triangle is nearest to those of the others.
Slab::Slab(const ViewedTriangle* first, const ViewedTriangle* end, double slack, double extent) {
  const ViewedTriangle* const largest =
      std::max_element(first, end, [](const ViewedTriangle& s, const ViewedTriangle& t) {
        return size_of(s.plane.normal()) < size_of(t.plane.normal());
      });
  const double size = size_of(largest->plane.normal());
  // Underflow of products is nothing beside numbers of that order.
  if (!(size * extent > 0x1p-700 && size * extent < 0x1p700)) return;
  normal_ = largest->plane.normal();
  origin_ = largest->placed.at[0];
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const ViewedTriangle* t = first; t != end; ++t)
    for (const Vec3& p : t->placed.at) {
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

FlatGroups::FlatGroups(const std::vector<ViewedTriangle>& triangles, const std::vector<Box>& boxes,
                       std::vector<std::uint32_t> chosen, const std::vector<std::uint32_t>& ends,
                       double slack, double extent) {
  const std::vector<Group> groups = groups_of(chosen, boxes, ends);
  const auto for_groups = [&](const auto& body) {
    parallel::loop(parallel::Range<std::size_t>(0, groups.size(), 256), [&](const auto& range) {
      for (std::size_t g = range.begin(); g < range.end(); ++g) body(g);
    });
  };
  std::vector<Box> around(groups.size());
  for_groups([&](std::size_t g) {
    for (std::uint32_t i = groups[g].first; i < groups[g].end; ++i) around[g].add(boxes[chosen[i]]);
  });
  const std::vector<std::uint32_t> order = order_along_curve(around);
  first_.resize(groups.size() + 1);
  first_four_.resize(groups.size() + 1);
  for (std::size_t g = 0; g < order.size(); ++g) {
    const auto [first, end] = groups[order[g]];
    first_[g + 1] = first_[g] + (end - first);
    first_four_[g + 1] = first_four_[g] + (end - first + 3) / 4;
  }
  boxes_.resize(groups.size());
  chosen_.resize(chosen.size());
  triangles_.resize(chosen.size());
  fours_.resize(first_four_.back());
  slabs_.resize(groups.size());
  for_groups([&](std::size_t g) {
    boxes_[g] = around[order[g]];
    const std::uint32_t first = first_[g], from = groups[order[g]].first;
    for (std::uint32_t i = 0; first + i < first_[g + 1]; ++i) {
      const std::uint32_t number = chosen[from + i];
      chosen_[first + i] = number;
      triangles_[first + i] = triangles[number];
      fours_[first_four_[g] + i / 4].set(i % 4, boxes[number]);
    }
    slabs_[g] = Slab(triangles_.data() + first, triangles_.data() + first_[g + 1], slack, extent);
  });
  index_ = BoxIndex(boxes_, true);
}

FlatGroups::Selection FlatGroups::near(const Box& box, std::uint32_t groups) const {
  Selection found;
  std::vector<Box> boxes;
  std::uint32_t count = 0;
  found.end = groups;
  found.all = !index_.overlapping(box, groups, [&](std::uint32_t g) {
    if (++count > most_to_select_from) return false;
    if (slabs_[g].always_clear_of(box)) return true;
    found.groups.push_back(g);
    boxes.push_back(boxes_[g]);
    return true;
  });
  if (!found.all) found.index = BoxIndex(boxes, true);
  return found;
}

}  // namespace sectile
