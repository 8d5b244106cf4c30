#include "rounding/near_triangles.h"

#include "parallel/parallel.h"

namespace sectile {
namespace {

constexpr std::size_t most_recent = 256;

}  // namespace

Box NearTriangles::make_box(std::uint32_t triangle, double room) const {
  Bounds bounds;
  for (const PointId p : rounded_.surface.corners[triangle]) {
    const Vec3& at = rounded_.geometry.position(p);
    bounds.add(at);
    if (room == 0) continue;
    bounds.add({at.x - room, at.y - room, at.z - room});
    bounds.add({at.x + room, at.y + room, at.z + room});
  }
  return bounds.box();
}

void NearTriangles::build_tree() {
  const std::size_t count = rounded_.corners.size();
  box_.assign(count, Box());
  box_in_tree_.assign(count, Box());
  parallel::loop(parallel::Range<std::size_t>(0, count, 4096), [&](const auto& range) {
    for (std::size_t t = range.begin(); t < range.end(); ++t) {
      if (rounded_.alive[t] == 0) continue;
      box_[t] = make_box(static_cast<std::uint32_t>(t), 0);
      box_in_tree_[t] = make_box(static_cast<std::uint32_t>(t), room_);
    }
  });
  home_in_tree_ = homes();
  tree_ = BoxTree(box_in_tree_, home_in_tree_);
  oriented_.clear();
  if (are_mostly_empty(box_in_tree_))
    for (std::uint32_t t = 0; t < count; ++t) oriented_.push_back(oriented_box(t));
  is_changed_.assign(count, 0);
  recent_.clear();
}

OrientedBox NearTriangles::oriented_box(std::uint32_t triangle) const {
  std::array<Vec3, 3> at;
  for (std::size_t k = 0; k < 3; ++k)
    at[k] = rounded_.geometry.position(rounded_.surface.corners[triangle][k]);
  return OrientedBox(at);
}

// Empty if there are none.
std::vector<std::uint32_t> NearTriangles::homes() const {
  static_assert(TouchingCones::none == BoxTree::no_group);
  std::vector<std::uint32_t> homes;
  if (cones_ == nullptr || cones_->empty()) return homes;
  homes.resize(rounded_.corners.size());
  for (std::uint32_t t = 0; t < homes.size(); ++t) homes[t] = cones_->home(t);
  return homes;
}

void NearTriangles::renew(std::uint32_t triangle) {
  box_[triangle] = make_box(triangle, 0);
  if (!oriented_.empty()) oriented_[triangle] = oriented_box(triangle);
}

void NearTriangles::begin(std::span<const std::uint32_t> triangles) {
  recent_before_ = recent_.size();
  for (const std::uint32_t t : triangles) {
    if (is_changed_[t] != 0) continue;
    is_changed_[t] = 1;
    recent_.push_back(t);
  }
}

// Those that changed little are found in the tree again.
void NearTriangles::keep() {
  const auto first = recent_.begin() + static_cast<std::ptrdiff_t>(recent_before_);
  const auto left = std::remove_if(first, recent_.end(), [&](std::uint32_t t) {
    if (!is_where_tree_has_it(t)) return false;
    is_changed_[t] = 0;
    return true;
  });
  recent_.erase(left, recent_.end());
  if (recent_.size() > most_recent) build_tree();
}

bool NearTriangles::is_where_tree_has_it(std::uint32_t t) const {
  return rounded_.alive[t] != 0 && box_in_tree_[t].contains(box_[t]) &&
         (home_in_tree_.empty() || home_in_tree_[t] == cones_->home(t));
}

void NearTriangles::undo() {
  for (; recent_.size() > recent_before_; recent_.pop_back()) is_changed_[recent_.back()] = 0;
}

}  // namespace sectile
