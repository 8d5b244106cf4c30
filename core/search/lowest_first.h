// Visits the items of a tree of boxes, of the branches of a node first the one that begins lowest
// along an axis. So what was found can tell that the others need not be visited.
#pragma once

#include <cstdint>

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
  const auto [children, count] =
      tree.children_in_order(n, [&](BoxTree::Node child, BoxTree::Node other) {
        return tree.box(child).low[axis] < tree.box(other).low[axis];
      });
  for (std::uint32_t i = 0; i < count; ++i)
    visit_lowest_first(tree, children[i], axis, meets, visit);
}

template <class Meets, class Visit>
void visit_lowest_first(const BoxTree& tree, int axis, const Meets& meets, const Visit& visit) {
  if (tree.empty()) return;
  visit_lowest_first(tree, tree.root(), axis, meets, visit);
}

}  // namespace sectile
