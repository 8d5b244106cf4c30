#include "storage/touching_slots.h"

#include <algorithm>

namespace sectile {
namespace {

// Of the vertices at which it touches itself, and the edges between two of them.
void add_boxes(const Block& block, std::vector<Box>& boxes) {
  const Brep& brep = block.brep();
  const std::vector<VertexId>& touching = block.touching_vertices();
  const auto touches = [&](VertexId v) {
    return std::binary_search(touching.begin(), touching.end(), v);
  };
  const auto add = [&](VertexId v, VertexId w) {
    Bounds bounds;
    for (const VertexId end : {v, w}) bounds.add(block.geometry().position(brep.point_of(end)));
    boxes.push_back(bounds.box());
  };
  for (const VertexId v : touching) add(v, v);
  for (const EdgeId e : brep.edges()) {
    const VertexId v = brep.from(Brep::half_edge(e, 0)), w = brep.from(Brep::half_edge(e, 1));
    if (touches(v) && touches(w)) add(v, w);
  }
}

}  // namespace

std::vector<std::uint32_t> slots_near(const SolidData& solid, const std::vector<Box>& boxes) {
  std::vector<std::uint32_t> slots;
  BoxTree::overlaps(BoxTree(boxes), solid.slot_tree(), [&](std::uint32_t, std::uint32_t i) {
    slots.push_back(solid.slots_in_tree()[i]);
  });
  std::sort(slots.begin(), slots.end());
  slots.erase(std::unique(slots.begin(), slots.end()), slots.end());
  return slots;
}

std::vector<std::uint32_t> find_touching_slots(const SolidData& solid) {
  std::vector<Box> boxes;
  for (const Slot& slot : solid.slots())
    if (slot.may_touch()) add_boxes(*slot.block, boxes);
  return boxes.empty() ? std::vector<std::uint32_t>() : slots_near(solid, boxes);
}

}  // namespace sectile
