// A tree of boxes over small things (triangles, edges), for rays and for boxes.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace sectile::viewer {

struct FloatBox {
  glm::vec3 low{1e30f}, high{-1e30f};
  void add(const glm::vec3& p) { low = glm::min(low, p), high = glm::max(high, p); }
  void add(const FloatBox& b) { low = glm::min(low, b.low), high = glm::max(high, b.high); }
  bool meets(const FloatBox& b) const {
    return glm::all(glm::lessThanEqual(low, b.high)) && glm::all(glm::lessThanEqual(b.low, high));
  }
};

class BoxTree {
 public:
  BoxTree() = default;
  explicit BoxTree(const std::vector<FloatBox>& items);

  const FloatBox& box() const { return box_; }  ///< around all

  /// Calls visit(item) for the items of all leaves whose box comes within `margin` of a box.
  template <class Visit>
  void near(const FloatBox& place, double margin, Visit&& visit) const {
    if (nodes_.empty()) return;
    const FloatBox wide{place.low - static_cast<float>(margin),
                        place.high + static_cast<float>(margin)};
    std::uint32_t stack[64];
    int top = 0;
    stack[top++] = 0;
    while (top > 0) {
      const BoxNode& node = nodes_[stack[--top]];
      if (!node.box.meets(wide)) continue;
      for (std::uint32_t i = node.first; i < node.first + node.count; ++i) visit(order_[i]);
      if (node.count > 0) continue;
      stack[top++] = node.first;
      stack[top++] = node.first + 1;
    }
  }

  /// Calls visit(item) for the items of all leaves whose box comes within `margin` of the line
  /// origin + t·direction for some t from 0 to the value that `limit` has then; near ones first.
  template <class Visit>
  void along(const glm::dvec3& origin, const glm::dvec3& direction, double margin,
             const double& limit, Visit&& visit) const {
    if (nodes_.empty()) return;
    const glm::dvec3 inverse = 1.0 / direction;
    std::uint32_t stack[64];
    int top = 0;
    stack[top++] = 0;
    while (top > 0) {
      const BoxNode& node = nodes_[stack[--top]];
      if (entry(node.box, origin, inverse, margin) > limit) continue;
      if (node.count > 0) {
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i) visit(order_[i]);
        continue;
      }
      // Children stand together; the nearer one goes onto the stack last.
      const std::uint32_t a = node.first, b = node.first + 1;
      const bool a_first = entry(nodes_[a].box, origin, inverse, margin) <=
                           entry(nodes_[b].box, origin, inverse, margin);
      stack[top++] = a_first ? b : a;
      stack[top++] = a_first ? a : b;
    }
  }

 private:
  struct BoxNode {
    FloatBox box;
    std::uint32_t first = 0, count = 0;  // items of a leaf, or the first of two children
  };
  /// Where the line enters the box; infinite if it misses it.
  static double entry(const FloatBox& box, const glm::dvec3& origin, const glm::dvec3& inverse,
                      double margin);
  void build(std::uint32_t node, std::uint32_t first, std::uint32_t last,
             const std::vector<FloatBox>& items);

  FloatBox box_;
  std::vector<BoxNode> nodes_;
  std::vector<std::uint32_t> order_;
};

}  // namespace sectile::viewer
