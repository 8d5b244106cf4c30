#include "boolean/loading/far_loops.h"

#include <algorithm>

#include "search/box_tree.h"
#include "storage/cut_into_blocks.h"

namespace sectile {
namespace {

class Finder {
 public:
  explicit Finder(const SolidData& solid) : solid_(solid) {}

  /// `meets`: may what meets the face meet a box, too?
  template <class Meets>
  void add_face(FaceId f, const Meets& meets) {
    FarLoops far;
    far.face = f;
    far.slot = solid_.slot_of(f);
    far.part.resize(solid_.slot(far.slot).block->loop_count());
    find_loops(far, meets);
    if (!far.loops.empty()) found_.push_back(std::move(far));
  }

  /// Of all faces that are loaded.
  std::vector<FarLoops> take(const std::vector<FaceId>& loaded) {
    if (found_.empty()) return {};
    for (const FaceId f : loaded) keep_neighbours(f);
    for (FarLoops& far : found_) {
      std::erase_if(far.loops, [&](LoopId l) { return !far.has(l); });
      for (const LoopId l : far.loops)
        for_each_in_loop(solid_.slot(far.slot).block->brep(), l,
                         [&](HalfEdgeId) { ++far.corners; });
    }
    std::erase_if(found_, [](const FarLoops& far) { return far.loops.empty(); });
    return std::move(found_);
  }

 private:
  // Loops beyond whose edges faces are loaded are loaded, too.
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

  // Inner loops whose boxes meet nothing, and at which the solid does not touch itself: there,
  // points are known from their blocks.
  template <class Meets>
  void find_loops(FarLoops& far, const Meets& meets) const {
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
      if (!is_far || meets(bounds.box())) continue;
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
    const BoxTree tree(boxes);
    finder.add_face(near[from].face, [&](const Box& box) {
      bool overlaps = false;
      tree.query([&](const Box& b) { return !overlaps && b.overlaps(box); },
                 [&](std::uint32_t) { overlaps = true; });
      return overlaps;
    });
  }
  return finder.take(faces);
}

std::vector<FarLoops> find_far_loops(const SolidData& solid, const std::vector<FaceId>& faces,
                                     const std::function<bool(const Box&)>& meets) {
  Finder finder(solid);
  for (const FaceId f : faces)
    if (may_have_far_loops(solid.slot(solid.slot_of(f)))) finder.add_face(f, meets);
  return finder.take(faces);
}

}  // namespace sectile
