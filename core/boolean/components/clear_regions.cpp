#include "boolean/components/clear_regions.h"

#include <span>
#include <utility>

#include "numbers/disjoint_sets.h"
#include "search/box_tree.h"

namespace sectile {
namespace {

// The highest nodes whose boxes are clear, and single items beside others that are not.
class ClearBoxes {
 public:
  ClearBoxes(const BoxTree& own, const BoxTree& across) : own_(own), across_(across) {
    look_at(own.root(), own.bounds());
  }

  std::vector<Box> boxes;
  std::vector<std::span<const std::uint32_t>> items;  // per box

 private:
  void look_at(BoxTree::Node n, const Box& box) {
    if (!across_.overlaps_any(box)) return add(box, own_.items(n));
    if (n.level == 0) return look_at_items(n);
    for (std::uint32_t i = 0; i < own_.child_count(n); ++i)
      look_at(BoxTree::child(n, i), own_.box_below(n, i));
  }
  void look_at_items(BoxTree::Node leaf) {
    const std::span<const std::uint32_t> all = own_.items(leaf);
    for (std::uint32_t i = 0; i < all.size(); ++i)
      if (const Box box = own_.box_below(leaf, i); !across_.overlaps_any(box))
        add(box, all.subspan(i, 1));
  }
  void add(const Box& box, std::span<const std::uint32_t> of) {
    boxes.push_back(box);
    items.push_back(of);
  }

  const BoxTree &own_, &across_;
};

// Boxes that have points in common hang together.
DisjointSets::Numbered hanging_together(const std::vector<Box>& boxes, const Box& across) {
  DisjointSets sets(boxes.size() + 1);
  for (std::uint32_t i = 0; i < boxes.size(); ++i)
    if (!boxes[i].overlaps(across)) sets.unite(ClearRegions::beyond, i + 1);
  const BoxTree tree(boxes);
  for (const BoxTree::SelfPart& part : tree.self_parts(1))
    tree.self_overlaps(part, [&](std::uint32_t i, std::uint32_t j) { sets.unite(i + 1, j + 1); });
  return std::move(sets).numbered();
}

}  // namespace

ClearRegions clear_regions(const SolidData& solid, const SolidData& other) {
  const ClearBoxes clear(solid.slot_tree(), other.slot_tree());
  const DisjointSets::Numbered regions = hanging_together(clear.boxes, other.slot_tree().bounds());
  ClearRegions result{std::vector(solid.slots().size(), ClearRegions::none), regions.count};
  for (std::size_t i = 0; i < clear.boxes.size(); ++i)
    for (const std::uint32_t item : clear.items[i])
      result.of_slot[solid.slots_in_tree()[item]] = regions.of[i + 1];
  return result;
}

}  // namespace sectile
