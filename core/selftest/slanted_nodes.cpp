#include "selftest/slanted_nodes.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "parallel/parallel.h"
#include "search/approximate.h"

namespace sectile {
namespace {

// Triangles of good shape reach 8 where they lie slanted, needles their ratio of length to width.
constexpr double slanted_needle = 16;

// Half the surface of the triangles' boxes, and twice the areas of the triangles.
struct Extent {
  double boxes = 0, triangles = 0;
};

void add_triangle(const std::array<PointId, 3>& corners, const Geometry& geometry, Extent& to) {
  using namespace approximate;
  const Vec3 &p = geometry.position(corners[0]), &q = geometry.position(corners[1]),
             &r = geometry.position(corners[2]);
  const Vec3 normal = cross(q - p, r - p);
  to.triangles += std::sqrt(dot(normal, normal));
  const double x = std::max({p.x, q.x, r.x}) - std::min({p.x, q.x, r.x}),
               y = std::max({p.y, q.y, r.y}) - std::min({p.y, q.y, r.y}),
               z = std::max({p.z, q.z, r.z}) - std::min({p.z, q.z, r.z});
  to.boxes += x * y + y * z + z * x;
}

// Are points certainly all on one side of what is in a box, across it? As apart() looks along this
// axis, for boxes of one point each; they were put into a box with that slack.
bool is_beside(const OrientedBox& box, std::span<const Vec3> points, double slack) {
  using namespace approximate;
  const double most = box.extent[2] + 2 * (box.slack + slack);
  bool below = true, above = true;
  for (const Vec3& p : points) {
    const double at = dot(box.axis[2], p - box.centre);
    below = below && at < -most;
    above = above && at > most;
  }
  return below || above;
}

}  // namespace

SlantedNodes::SlantedNodes(const TriangleSurface& surface, const Geometry& geometry,
                           const TriangleTree& tree, Which which)
    : tree_(&tree) {
  if (which == Which::needles) {
    find_needles(surface, geometry);
  } else {
    for (std::size_t level = 0; level < tree.levels(); ++level)
      number_.emplace_back(tree.nodes(level), 0);
    corners_.reserve(3 * tree.order().size());
    for (const std::uint32_t t : tree.order())
      for (const PointId p : surface.corners[t]) corners_.push_back(geometry.position(p));
  }
  for (std::size_t level = 0; level < number_.size(); ++level) {
    std::vector<std::uint32_t> nodes;
    for (std::uint32_t node = 0; node < number_[level].size(); ++node) {
      if (number_[level][node] == none) continue;
      number_[level][node] = static_cast<std::uint32_t>(nodes.size());
      nodes.push_back(node);
    }
    boxes_.emplace_back(nodes.size());
    parallel::loop(parallel::Range<std::size_t>(0, nodes.size(), 64), [&](const auto& range) {
      for (std::size_t i = range.begin(); i < range.end(); ++i)
        boxes_[level][i] = box_around(surface, geometry, level, nodes[i]);
    });
  }
}

// Nodes of needles get any number, for now. A node above them is one if half of them are.
void SlantedNodes::find_needles(const TriangleSurface& surface, const Geometry& geometry) {
  std::vector<std::uint32_t> found(tree_->nodes(0), none);
  parallel::loop(parallel::Range<std::size_t>(0, found.size(), 256), [&](const auto& range) {
    for (std::size_t node = range.begin(); node < range.end(); ++node) {
      Extent extent;
      const auto [begin, end] = tree_->range(0, node);
      for (std::uint32_t i = begin; i < end; ++i)
        add_triangle(surface.corners[tree_->order()[i]], geometry, extent);
      if (extent.boxes > slanted_needle * extent.triangles) found[node] = 0;
    }
  });
  while (std::any_of(found.begin(), found.end(), [](std::uint32_t n) { return n != none; })) {
    number_.push_back(std::move(found));
    const std::size_t level = number_.size();
    if (level == tree_->levels()) return;
    found.assign(tree_->nodes(level), none);
    for (std::size_t node = 0; node < found.size(); ++node) {
      unsigned count = 0;
      for (unsigned i = 0; i < tree_->children(level, node); ++i)
        count += number_[level - 1][8 * node + i] != none ? 1 : 0;
      if (2 * count > tree_->children(level, node)) found[node] = 0;
    }
  }
}

OrientedBox SlantedNodes::box_around(const TriangleSurface& surface, const Geometry& geometry,
                                     std::size_t level, std::size_t node) const {
  std::vector<Vec3> points;
  const auto [begin, end] = tree_->range(level, node);
  for (std::uint32_t i = begin; i < end; ++i)
    for (const PointId p : surface.corners[tree_->order()[i]])
      points.push_back(geometry.position(p));
  return OrientedBox(points);
}

OrientedBox SlantedNodes::box(std::size_t level, std::size_t node) const {
  const std::uint32_t number = number_[level][node];
  return number != none ? boxes_[level][number] : OrientedBox(tree_->boxes(level, node).all());
}

bool SlantedNodes::apart(std::size_t level, std::size_t a, std::size_t b) const {
  if (level >= number_.size() || (number_[level][a] == none && number_[level][b] == none))
    return false;
  if (sectile::apart(box(level, a), box(level, b))) return true;
  return level == 0 && !corners_.empty() && (are_beside(a, b) || are_beside(b, a));
}

// Boxes reach farther than triangles: where layers bend, those of one are in many layers beside it.
bool SlantedNodes::are_beside(std::size_t leaf, std::size_t other) const {
  const auto [begin, end] = tree_->range(0, other);
  const auto corners = std::span(corners_).subspan(3 * std::size_t(begin), 3 * (end - begin));
  return is_beside(boxes_[0][leaf], corners, boxes_[0][other].slack);
}

bool SlantedNodes::apart(std::size_t level, std::size_t node, const OrientedBox& box) const {
  if (level >= number_.size() || number_[level][node] == none) return false;
  return sectile::apart(boxes_[level][number_[level][node]], box);
}

}  // namespace sectile
