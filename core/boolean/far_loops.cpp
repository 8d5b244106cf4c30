#include "boolean/far_loops.h"

#include <algorithm>

#include "search/box_tree.h"
#include "storage/cut_into_blocks.h"

namespace sectile {
namespace {

class Finder {
 public:
  explicit Finder(const SolidData& solid) : solid_(solid) {}

  void add_face(FaceId f, const std::vector<Box>& near) {
    FarLoops far;
    far.face = f;
    far.slot = solid_.slot_of(f);
    far.part.resize(solid_.slot(far.slot).block->loop_count());
    find_loops(far, BoxTree(near));
    if (!far.loops.empty()) found_.push_back(std::move(far));
  }

  /// Loops beyond whose edges faces are loaded are loaded, too.
  void keep_neighbours(FaceId loaded) {
    const std::uint32_t slot = solid_.slot_of(loaded);
    const Block& block = *solid_.slot(slot).block;
    std::uint32_t without = slot;  // the last slot seen that has none
    for_each_in_face(block.brep(), solid_.local(slot, loaded), [&](HalfEdgeId h) {
      if (!block.is_border(h)) return;
      const auto beyond = solid_.across(slot, h);
      if (beyond.slot == without) return;
      const auto far = std::ranges::lower_bound(found_, beyond.slot, {}, &FarLoops::slot);
      if (far == found_.end() || far->slot != beyond.slot) {
        without = beyond.slot;
        return;
      }
      far->part[solid_.slot(beyond.slot).block->brep().loop_of(beyond.local)] = FaceId();
    });
  }

  std::vector<FarLoops> take() {
    for (FarLoops& far : found_) {
      std::erase_if(far.loops, [&](LoopId l) { return !far.has(l); });
      for (const LoopId l : far.loops)
        for_each_in_loop(solid_.slot(far.slot).block->brep(), l,
                         [&](HalfEdgeId) { ++far.corners; });
    }
    std::erase_if(found_, [](const FarLoops& far) { return far.loops.empty(); });
    return std::move(found_);
  }
  bool empty() const { return found_.empty(); }

 private:
  // Inner loops whose boxes overlap none of the others, and at which the solid does not touch
  // itself: there, points are known from their blocks.
  void find_loops(FarLoops& far, const BoxTree& near) const {
    const Block& block = *solid_.slot(far.slot).block;
    const Brep& brep = block.brep();
    const std::vector<VertexId>& touching = block.touching_vertices();
    const LoopId outer = brep.outer_loop[FaceId(0)];
    for (const LoopId l : brep.loops()) {
      if (l == outer) continue;
      Bounds bounds;
      bool is_far = true;
      for_each_in_loop(brep, l, [&](HalfEdgeId h) {
        bounds.add(block.geometry().position(brep.point_of(brep.from(h))));
        if (!touching.empty())
          is_far &= !std::binary_search(touching.begin(), touching.end(), brep.from(h));
      });
      const Box box = bounds.box();
      near.query([&](const Box& b) { return b.overlaps(box); },
                 [&](std::uint32_t) { is_far = false; });
      if (!is_far) continue;
      far.part[l] = far.face;
      far.loops.push_back(l);
    }
  }

  const SolidData& solid_;
  std::vector<FarLoops> found_;
};

}  // namespace

bool may_have_far_loops(const Slot& slot) {
  return slot.faces == 1 && slot.half_edges >= 2 * corners_of_a_large_face &&
         slot.half_edges == 2 * slot.block->border_count;
}

std::vector<FarLoops> find_far_loops(const SolidData& solid, const std::vector<FaceId>& faces,
                                     std::vector<FaceAndBox> near) {
  std::ranges::stable_sort(near, {}, &FaceAndBox::face);
  Finder finder(solid);
  std::vector<Box> boxes;
  for (std::size_t from = 0, to = 0; from < near.size(); from = to) {
    boxes.clear();
    for (; to < near.size() && near[to].face == near[from].face; ++to)
      boxes.push_back(near[to].box);
    finder.add_face(near[from].face, boxes);
  }
  if (finder.empty()) return {};
  for (const FaceId f : faces) finder.keep_neighbours(f);
  return finder.take();
}

}  // namespace sectile
