// Visits the items of a tree of boxes, of two branches first the one that begins lower along an
// axis. So what was found can tell that the other one need not be visited.
#pragma once

#include <cstdint>
#include <utility>

#include "search/box_tree.h"

namespace sectile {

/// Calls visit(item) for every item in a leaf that satisfies meets(box), as all that is above it
/// does. `meets` may come to hold for fewer boxes meanwhile.
template <class Meets, class Visit>
void visit_lowest_first(const BoxTree& tree, BoxTree::Node n, int axis, const Meets& meets,
                        const Visit& visit) {
  if (!meets(tree.box(n))) return;
  if (n.level == 0) {
    for (const std::uint32_t item : tree.items(n)) visit(item);
    return;
  }
  BoxTree::Node first{n.level - 1, 2 * n.index}, second{n.level - 1, 2 * n.index + 1};
  const bool has_second = second.index < tree.node_count(second.level);
  if (has_second && tree.box(second).low[axis] < tree.box(first).low[axis])
    std::swap(first, second);
  visit_lowest_first(tree, first, axis, meets, visit);
  if (has_second) visit_lowest_first(tree, second, axis, meets, visit);
}

template <class Meets, class Visit>
void visit_lowest_first(const BoxTree& tree, int axis, const Meets& meets, const Visit& visit) {
  if (tree.empty()) return;
  visit_lowest_first(tree, {tree.level_count() - 1, 0}, axis, meets, visit);
}

}  // namespace sectile
