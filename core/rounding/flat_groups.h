// Triangles in groups that are flat, as the pieces of one face are, to find those that may be near
// another one. Where they are long and thin and lie aslant, boxes overlap far more often than what
// is in them; whether all of a group is beside another triangle is seen at one go.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "parallel/once_alone.h"
#include "rounding/clear_pairs.h"
#include "search/box_index.h"
#include "search/four_boxes.h"
#include "search/oriented_index.h"

namespace sectile {

/// What is between two parallel planes. Everything, unless told otherwise.
class Slab {
 public:
  Slab() = default;
  /// Around triangles whose corners, as those of all that are compared with it, were up to `slack`
  /// away in each coordinate. No two of these corners are farther apart in one than `extent`.
  Slab(std::span<const ViewedTriangle> triangles, double slack, double extent);

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
  /// Up to each of the `ends` triangles are in one plane, or nearly so; faces that are near each
  /// other should come one after another. See Slab.
  FlatGroups(const std::function<PlacedTriangle(std::uint32_t)>& triangle,
             const std::vector<std::uint32_t>& ends, double slack, double extent);

  // The triangles have places 0 … size() - 1, group by group. Those without a clear view are at
  // their places, but near nothing.
  std::uint32_t size() const { return static_cast<std::uint32_t>(triangles_.size()); }
  const ViewedTriangle& triangle(std::uint32_t place) const { return triangles_[place]; }
  std::uint32_t number(std::uint32_t place) const { return number_[place]; }
  std::uint32_t count() const { return static_cast<std::uint32_t>(slabs_.size()); }
  std::uint32_t first(std::uint32_t group) const { return first_[group]; }

  const Box& box(std::uint32_t group) const { return boxes_[group]; }
  const Slab& slab(std::uint32_t group) const { return slabs_[group]; }

  /// Calls visit(group) for those of the first `groups` that may meet what is in a box, until it
  /// returns false. Did it never? Beyond `many`, around() is asked for a box around the same that
  /// says more.
  template <class Around, class Visit>
  bool overlapping(const Box& box, std::uint32_t many, const Around& around, std::uint32_t groups,
                   const Visit& visit) const;
  bool any_overlaps(const Box& box) const { return index_.any_overlaps(box); }
  const OrientedBox& oriented(std::uint32_t group) const { return oriented().at(0, group); }

  /// Calls visit(place) for all of a group that are not certainly beside a triangle with this box,
  /// until it returns false. Did it never?
  template <class Visit>
  bool near(std::uint32_t group, const PlacedTriangle& triangle, const Box& box,
            const Visit& visit) const {
    if (slabs_[group].always_clear_of(triangle)) return true;
    return for_places(group, overlapping(group, box, all_of(group)), visit);
  }
  /// The same for all pairs of places, one in each of two groups or both in one, that are not
  /// certainly beside each other.
  template <class Visit>
  bool near_pairs(std::uint32_t group, std::uint32_t other, const Visit& visit) const;

 private:
  using Members = std::uint32_t;  // a bit for each of those in a group

  // Made when first asked for.
  const OrientedIndex& oriented() const;
  void gather(const std::function<PlacedTriangle(std::uint32_t)>& triangle,
              const std::vector<std::uint32_t>& ends);
  void look_at(std::uint32_t group, const std::function<PlacedTriangle(std::uint32_t)>& triangle,
               double slack, double extent);
  Members all_of(std::uint32_t group) const {
    return ~Members(0) >> (32 - (first_[group + 1] - first_[group]));
  }
  Members beside(std::uint32_t group, const Slab& slab, Members among) const;
  Members overlapping(std::uint32_t group, const Box& box, Members among) const;
  Box box_of(std::uint32_t group, std::uint32_t member) const {
    return fours_[first_four_[group] + member / 4].get(member % 4);
  }
  template <class Visit>
  bool for_places(std::uint32_t group, Members members, const Visit& visit) const {
    for (; members != 0; members &= members - 1)
      if (!visit(first_[group] + static_cast<std::uint32_t>(std::countr_zero(members))))
        return false;
    return true;
  }

  std::vector<ViewedTriangle> triangles_;
  std::vector<std::uint32_t> number_;              // per triangle
  std::vector<std::uint32_t> first_, first_four_;  // per group, and the end
  std::vector<FourBoxes> fours_;                   // of triangles of one group
  std::vector<Slab> slabs_;                        // per group
  std::vector<Box> boxes_;                         // per group
  BoxIndex index_;                                 // of the groups
  double slack_ = 0;
  struct Oriented {
    OnceFlag once;
    OrientedIndex index;  // of the groups, too
  };
  std::unique_ptr<Oriented> oriented_ = std::make_unique<Oriented>();
};

inline FlatGroups::Members FlatGroups::overlapping(std::uint32_t group, const Box& box,
                                                   Members among) const {
  Members found = 0;
  unsigned shift = 0;
  for (std::uint32_t four = first_four_[group]; four < first_four_[group + 1]; ++four, shift += 4)
    found |= Members(fours_[four].overlapping(box)) << shift;
  return found & among;
}

template <class Around, class Visit>
bool FlatGroups::overlapping(const Box& box, std::uint32_t many, const Around& around,
                             std::uint32_t groups, const Visit& visit) const {
  std::uint32_t visited = 0;
  std::optional<OrientedBox> oriented_box;
  return index_.overlapping(
      box, groups, [&](std::uint32_t group) { return ++visited, visit(group); },
      [&](std::uint64_t level, std::uint32_t index) {
        if (visited < many) return false;
        if (!oriented_box) oriented_box = around();
        return apart(oriented().at(level, index), *oriented_box);
      });
}

template <class Visit>
bool FlatGroups::near_pairs(std::uint32_t group, std::uint32_t other, const Visit& visit) const {
  Members own = all_of(group), others = own;
  if (group != other) {
    own = overlapping(group, boxes_[other], own);
    others = overlapping(other, boxes_[group], all_of(other));
    if (own == 0 || others == 0) return true;
    own &= ~beside(group, slabs_[other], own);
    if (own == 0) return true;
    others &= ~beside(other, slabs_[group], others);
    if (others == 0) return true;
  }
  for (; own != 0; own &= own - 1) {
    const auto i = static_cast<std::uint32_t>(std::countr_zero(own));
    const Members before = group == other ? (Members(1) << i) - 1 : others;
    const auto with_own = [&](std::uint32_t place) { return visit(first_[group] + i, place); };
    if (before != 0 && !for_places(other, overlapping(other, box_of(group, i), before), with_own))
      return false;
  }
  return true;
}

}  // namespace sectile
