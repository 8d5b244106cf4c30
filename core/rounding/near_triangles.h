// Which triangles of a surface are near others, while some of them change.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "rounding/rounded_surface.h"
#include "rounding/touching_cones.h"
#include "search/box_tree.h"
#include "search/oriented_box.h"

namespace sectile {

class NearTriangles {
 public:
  /// Those that two of `cones` keep apart are passed over.
  explicit NearTriangles(const RoundedSurface& rounded, const TouchingCones* cones = nullptr)
      : rounded_(rounded), cones_(cones) {
    build_tree();
  }

  const Box& box(std::uint32_t triangle) const { return box_[triangle]; }
  /// Calls visit(other) for the other living triangles whose boxes overlap that of a triangle.
  template <class Visit>
  void for_each(std::uint32_t triangle, const Visit& visit) const;

  /// Corners may move by so much from now on before the search takes longer.
  void leave_room(double room) {
    room_ = room;
    build_tree();
  }
  /// These triangles are about to change.
  void begin(std::span<const std::uint32_t> triangles);
  /// A triangle has changed.
  void renew(std::uint32_t triangle);
  /// The changes since begin() stay, or were undone.
  void keep();
  void undo();

 private:
  Box make_box(std::uint32_t triangle, double room) const;
  void build_tree();
  std::vector<std::uint32_t> homes() const;
  OrientedBox oriented_box(std::uint32_t triangle) const;
  bool is_where_tree_has_it(std::uint32_t triangle) const;

  const RoundedSurface& rounded_;
  const TouchingCones* cones_;
  double room_ = 0;
  BoxTree tree_;                             // groups: sites of cones
  std::vector<Box> box_, box_in_tree_;       // per triangle
  std::vector<OrientedBox> oriented_;        // the same, if boxes are mostly empty
  std::vector<std::uint32_t> home_in_tree_;  // per triangle
  std::vector<std::uint8_t> is_changed_;     // not as the tree has it
  std::vector<std::uint32_t> recent_;        // the same as a list
  std::size_t recent_before_ = 0;
};

// What is at home at a site where the triangle lies in a cone is in a cone near that, or apart.
template <class Visit>
void NearTriangles::for_each(std::uint32_t triangle, const Visit& visit) const {
  const Box& own = box_[triangle];
  std::span<const TouchingCones::Member> around;
  if (cones_ != nullptr) around = cones_->cones_around(triangle);
  const auto visit_near = [&](std::uint32_t t) {
    if (t == triangle || rounded_.alive[t] == 0 || !box_[t].overlaps(own)) return;
    if (!oriented_.empty() && apart(oriented_[triangle], oriented_[t])) return;
    if (around.empty() || !cones_->are_apart(around, t)) visit(t);
  };
  const auto visit_unchanged = [&](std::uint32_t t) {
    if (is_changed_[t] == 0) visit_near(t);
  };
  tree_.query([&](const Box& b) { return b.overlaps(own); }, visit_unchanged,
              [&](std::uint32_t site) {
                return std::any_of(around.begin(), around.end(),
                                   [&](const auto& cone) { return cone.site == site; });
              });
  for (auto cone = around.begin(); cone != around.end(); ++cone) {
    const auto is_of_site = [&](const auto& other) { return other.site == cone->site; };
    if (std::any_of(around.begin(), cone, is_of_site)) continue;  // what is near is near both
    cones_->for_each_at_home(*cone, [&](std::uint32_t t) {
      if (home_in_tree_[t] == cone->site) visit_unchanged(t);
    });
  }
  for (const std::uint32_t t : recent_) visit_near(t);
}

}  // namespace sectile
