// Triangles in groups that are flat, as the pieces of one face are, to find those that may be near
// another one. Where they are long and thin and lie aslant, boxes overlap far more often than what
// is in them; whether all of a group is beside another triangle is seen at one go.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <vector>

#include "rounding/clear_pairs.h"
#include "search/box_index.h"
#include "search/four_boxes.h"

namespace sectile {

/// With so much more on all sides.
Box box_around(const PlacedTriangle& triangle, double wider);

/// What is between two parallel planes. Everything, unless told otherwise.
class Slab {
 public:
  Slab() = default;
  /// Around triangles whose corners, as those of all that are compared with it, were up to `slack`
  /// away in each coordinate. No two of these corners are farther apart in one than `extent`.
  Slab(const ViewedTriangle* first, const ViewedTriangle* end, double slack, double extent);

  /// Was a triangle beside it all the way on which its corners came to where they are?
  bool always_clear_of(const PlacedTriangle& triangle) const {
    const double a = value(triangle.at[0]), b = value(triangle.at[1]), c = value(triangle.at[2]);
    return (a < low_ && b < low_ && c < low_) || (a > high_ && b > high_ && c > high_);
  }
  /// Was all in a box?
  bool always_clear_of(const Box& box) const;

 private:
  double value(const Vec3& p) const {
    return normal_[0] * (p.x - origin_.x) + normal_[1] * (p.y - origin_.y) +
           normal_[2] * (p.z - origin_.z);
  }

  Vec3 origin_;
  std::array<double, 3> normal_ = {};
  double low_ = -std::numeric_limits<double>::infinity(),
         high_ = std::numeric_limits<double>::infinity();
};

class FlatGroups {
 public:
  FlatGroups() = default;
  /// Of some of the triangles, those that are `chosen`: up to each of the `ends` they are in one
  /// plane, or nearly so. `boxes`: around each triangle, two slacks wider. See Slab.
  FlatGroups(const std::vector<ViewedTriangle>& triangles, const std::vector<Box>& boxes,
             std::vector<std::uint32_t> chosen, const std::vector<std::uint32_t>& ends,
             double slack, double extent);

  // The triangles have places 0 … size() - 1, group by group.
  std::uint32_t size() const { return static_cast<std::uint32_t>(triangles_.size()); }
  const ViewedTriangle& triangle(std::uint32_t place) const { return triangles_[place]; }
  std::uint32_t chosen(std::uint32_t place) const { return chosen_[place]; }
  std::uint32_t count() const { return static_cast<std::uint32_t>(slabs_.size()); }
  std::uint32_t first(std::uint32_t group) const { return first_[group]; }

  Box box(std::uint32_t group) const { return boxes_[group]; }

  /// Some of the groups.
  struct Selection {
    bool all = false;       ///< of the first ones, as what is near would be too many
    std::uint32_t end = 0;  ///< of these
    std::vector<std::uint32_t> groups;
    BoxIndex index;  ///< of their boxes
    bool is_empty() const { return !all && groups.empty(); }
  };
  /// Those of the first `groups` to which anything in a box may be near.
  Selection near(const Box& box, std::uint32_t groups) const;

  /// Calls visit(place) for all in some groups, and before a place, that are not certainly beside a
  /// triangle with this box, until it returns false. Did it never? False also if that would take
  /// too many groups.
  template <class Visit>
  bool near(const Selection& some, const PlacedTriangle& triangle, const Box& box,
            std::uint32_t end, const Visit& visit) const {
    std::uint32_t count = 0;
    const auto visit_group = [&](std::uint32_t g) {
      return ++count <= most_groups && near_of(g, triangle, box, end, visit);
    };
    if (some.all) return index_.overlapping(box, some.end, visit_group);
    return some.index.overlapping(box,
                                  [&](std::uint32_t i) { return visit_group(some.groups[i]); });
  }

  /// In the boxes of so many groups one triangle may be.
  static constexpr std::uint32_t most_groups = 8192;

 private:
  template <class Visit>
  bool near_of(std::uint32_t group, const PlacedTriangle& triangle, const Box& box,
               std::uint32_t end, const Visit& visit) const;

  std::vector<ViewedTriangle> triangles_;
  std::vector<std::uint32_t> chosen_;              // per triangle
  std::vector<std::uint32_t> first_, first_four_;  // per group, and the end
  std::vector<FourBoxes> fours_;                   // of triangles of one group
  std::vector<Slab> slabs_;                        // per group
  std::vector<Box> boxes_;                         // per group
  BoxIndex index_;                                 // of the groups, which are along a curve
};

template <class Visit>
bool FlatGroups::near_of(std::uint32_t group, const PlacedTriangle& triangle, const Box& box,
                         std::uint32_t end, const Visit& visit) const {
  std::uint32_t first = first_[group];
  if (first >= end || slabs_[group].always_clear_of(triangle)) return true;
  if (first + 1 == first_[group + 1]) return visit(first);  // its box is the group's
  for (std::uint32_t four = first_four_[group]; four < first_four_[group + 1]; ++four, first += 4)
    for (unsigned hit = fours_[four].overlapping(box); hit != 0; hit &= hit - 1) {
      const std::uint32_t place = first + static_cast<std::uint32_t>(std::countr_zero(hit));
      if (place >= end) return true;
      if (!visit(place)) return false;
    }
  return true;
}

}  // namespace sectile
