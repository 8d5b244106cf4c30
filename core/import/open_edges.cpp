// A face may have one long edge where its neighbours have several short ones.
#include <algorithm>

#include "import/polygons.h"
#include "search/box_tree.h"

namespace sectile {
namespace {

class EdgeDivider {
 public:
  EdgeDivider(const Polygons& polygons, const Kernel& kernel,
              std::span<const std::uint32_t> open_corners)
      : polygons_(polygons), kernel_(kernel), after_(polygons.corners.size()) {
    find_next_corners();
    collect_ends(open_corners);
  }

  /// The points within the edge that leaves a corner, in order.
  std::vector<PointId> within(std::uint32_t corner) const {
    const PointId from = polygons_.corners[corner], to = next(corner);
    Bounds bounds;
    bounds.add(position(from));
    bounds.add(position(to));
    const Box box = bounds.box();
    std::vector<PointId> found;
    tree_.query([&](const Box& other) { return other.overlaps(box); },
                [&](std::uint32_t i) {
                  if (is_between(from, ends_[i], to)) found.push_back(ends_[i]);
                });
    std::sort(found.begin(), found.end(),
              [&](PointId p, PointId q) { return p != q && is_between(from, p, q); });
    return found;
  }

 private:
  const Vec3& position(PointId p) const { return kernel_.geometry().position(p); }
  PointId next(std::uint32_t corner) const { return polygons_.corners[after_[corner]]; }

  void find_next_corners() {
    for (std::uint32_t l = 0; l < polygons_.loop_end.size(); ++l) {
      const std::uint32_t begin = polygons_.loop_begin(l), end = polygons_.loop_end[l];
      for (std::uint32_t i = begin; i < end; ++i) after_[i] = i + 1 < end ? i + 1 : begin;
    }
  }

  void collect_ends(std::span<const std::uint32_t> open_corners) {
    for (const std::uint32_t corner : open_corners)
      ends_.insert(ends_.end(), {polygons_.corners[corner], next(corner)});
    std::sort(ends_.begin(), ends_.end());
    ends_.erase(std::unique(ends_.begin(), ends_.end()), ends_.end());
    std::vector<Box> boxes;
    boxes.reserve(ends_.size());
    for (const PointId p : ends_) {
      Bounds bounds;
      bounds.add(position(p));
      boxes.push_back(bounds.box());
    }
    tree_ = BoxTree(boxes);
  }

  bool is_between(PointId from, PointId p, PointId to) const {
    for (int axis = 0; axis < 3; ++axis)
      if (kernel_.turn(from, p, to, axis) != Sign::zero) return false;
    for (int axis = 0; axis < 3; ++axis)
      if (const Sign s = kernel_.compare(from, to, axis); s != Sign::zero)
        return kernel_.compare(from, p, axis) == s && kernel_.compare(p, to, axis) == s;
    return false;
  }

  const Polygons& polygons_;
  const Kernel& kernel_;
  std::vector<std::uint32_t> after_;  // per corner: the next one of its loop
  std::vector<PointId> ends_;
  BoxTree tree_;
};

}  // namespace

bool divide_open_edges(Polygons& polygons, const Kernel& kernel,
                       std::span<const std::uint32_t> open_corners) {
  const EdgeDivider divider(polygons, kernel, open_corners);
  std::vector<std::vector<PointId>> within(polygons.corners.size());
  bool found = false;
  for (const std::uint32_t corner : open_corners) {
    within[corner] = divider.within(corner);
    found |= !within[corner].empty();
  }
  if (!found) return false;
  std::vector<PointId> corners;
  std::uint32_t i = 0;
  for (std::uint32_t& end : polygons.loop_end) {
    for (; i < end; ++i) {
      corners.push_back(polygons.corners[i]);
      corners.insert(corners.end(), within[i].begin(), within[i].end());
    }
    end = static_cast<std::uint32_t>(corners.size());
  }
  polygons.corners = std::move(corners);
  return true;
}

}  // namespace sectile
