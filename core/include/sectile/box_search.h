// Finding things by their place: the tree of boxes that the Booleans find faces with.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <type_traits>

#include "sectile/mesh.h"

namespace sectile {

class BoxTree;

/// From the least to the greatest coordinates of a thing.
struct Extent {
  Vec3 low, high;
  bool meets(const Extent& other) const {
    return low.x <= other.high.x && other.low.x <= high.x && low.y <= other.high.y &&
           other.low.y <= high.y && low.z <= other.high.z && other.low.z <= high.z;
  }
};

/// Things that are numbered from 0, each in a box along the axes. Boxes are kept as floats, rounded
/// outwards, and things are visited leaf by leaf: a query gives all that are asked for, and
/// neighbours of some. A value: copies share the tree. Safe to use in many threads.
class BoxSearch {
 public:
  BoxSearch() = default;
  /// Takes O(n log n), on all cores.
  explicit BoxSearch(std::span<const Extent> things);

  bool empty() const { return !tree_; }
  Extent extent() const;  ///< around all things; of none: it meets nothing

  /// Calls visit(number) for the things whose box may meet `place`.
  template <class Visit>
  void near(const Extent& place, Visit&& visit) const {
    visit_near(place, {&visit, call<Visit>});
  }

  /// Calls visit(number) for the things whose box may come within `margin` of origin + t ·
  /// direction for some t from 0 to the value that `limit` has then; near ones first, so that a
  /// search for the nearest lowers `limit` as it goes on.
  template <class Visit>
  void along(const Vec3& origin, const Vec3& direction, double margin, const double& limit,
             Visit&& visit) const {
    visit_along(origin, direction, margin, limit, {&visit, call<Visit>});
  }

 private:
  struct Visitor {
    void* object;
    void (*call)(void* object, std::uint32_t number);
    void operator()(std::uint32_t number) const { call(object, number); }
  };
  template <class Visit>
  static void call(void* object, std::uint32_t number) {
    (*static_cast<std::remove_reference_t<Visit>*>(object))(number);
  }
  void visit_near(const Extent& place, Visitor visit) const;
  void visit_along(const Vec3& origin, const Vec3& direction, double margin, const double& limit,
                   Visitor visit) const;

  std::shared_ptr<const BoxTree> tree_;  ///< null: there are no things
};

}  // namespace sectile
