#include "boolean/joining/far_parts.h"

#include <algorithm>
#include <memory>

#include "boolean/ray_count.h"
#include "numbers/threshold.h"
#include "search/box_tree.h"
#include "sectile/errors.h"
#include "storage/geometry_loader.h"

namespace sectile {
namespace {

// The parts of one face, which has its far loops in a block.
class PartsOfFace {
 public:
  PartsOfFace(Workspace& w, const Patch& patch, std::vector<FaceId> parts, const Block& block)
      : w_(w),
        patch_(patch),
        parts_(std::move(parts)),
        outlines_(parts_.size()),
        block_(block),
        loader_(block.geometry(), w.geometry, few_points) {
    std::vector<Box> boxes;
    for (const FaceId f : parts_) {
      Bounds bounds;
      for_each_in_loop(patch.brep, patch.brep.outer_loop[f], [&](HalfEdgeId h) {
        bounds.add(w.geometry.position(patch.brep.point_of(patch.brep.from(h))));
      });
      boxes.push_back(bounds.box());
    }
    tree_ = BoxTree(boxes);
  }

  /// All corners of a loop lie in its part or on the part's boundary: as a rule, one of them tells.
  FaceId part_of(LoopId loop) {
    const Brep& brep = block_.brep();
    const HalfEdgeId first = brep.loop_half_edge[loop];
    find_near(block_.geometry().position(brep.point_of(brep.from(first))));
    HalfEdgeId h = first;
    while (near_.size() > 1) {
      const PointId corner = loader_.point(brep.point_of(brep.from(h)));
      w_.kernel->refresh();
      std::erase_if(near_, [&](std::uint32_t part) { return !reaches(part, corner); });
      h = brep.next_of(h);
      if (h == first) break;
    }
    if (near_.size() != 1) throw InternalError("an inner loop lies in no part of its face");
    return parts_[near_[0]];
  }

 private:
  static constexpr std::size_t few_points = threshold(64, 2);

  // What has edges, as a tree over them.
  struct Outline {
    std::vector<HalfEdgeId> edges;
    std::unique_ptr<OutlineTree> tree;
  };

  void find_near(const Vec3& corner) {
    near_.clear();
    tree_.query([&](const Box& b) { return b.contains(corner); },
                [&](std::uint32_t part) { near_.push_back(part); });
  }

  bool reaches(std::uint32_t part, PointId p) {
    const Outline& outline = outline_of(part);
    const Probe probe(w_.tests(), p);
    RayCount count(w_.tests(), patch_, patch_.plane(parts_[part]), probe, touched_);
    count.add(*outline.tree, outline.edges);
    return count.odd() || !touched_.empty();
  }

  const Outline& outline_of(std::uint32_t part) {
    Outline& outline = outlines_[part];
    if (outline.tree) return outline;
    const Brep& brep = patch_.brep;
    std::vector<Vec3> corners;
    std::vector<std::uint32_t> loop_ends;
    for (LoopId l = brep.outer_loop[parts_[part]]; l.valid(); l = brep.next_loop[l]) {
      for_each_in_loop(brep, l, [&](HalfEdgeId h) {
        if (!patch_.side(h).valid()) return;  // a null edge
        outline.edges.push_back(h);
        corners.push_back(w_.geometry.position(brep.point_of(brep.from(h))));
      });
      if (corners.size() > (loop_ends.empty() ? 0 : loop_ends.back()))
        loop_ends.push_back(static_cast<std::uint32_t>(corners.size()));
    }
    outline.tree = std::make_unique<OutlineTree>(corners, loop_ends,
                                                 w_.tests().main_axis(patch_.plane(parts_[part])));
    return outline;
  }

  Workspace& w_;
  const Patch& patch_;
  std::vector<FaceId> parts_;
  std::vector<Outline> outlines_;
  const Block& block_;
  GeometryLoader loader_;
  BoxTree tree_;
  std::vector<std::uint32_t> near_;
  std::vector<Entity> touched_;
};

std::vector<FaceId> parts_of(const Patch& patch, FaceId root) {
  std::vector<FaceId> parts;
  for (const FaceId f : patch.root.ids())
    if (patch.root_of(f) == root && patch.is_real(f)) parts.push_back(f);
  return parts;
}

}  // namespace

void settle_far_loops(Workspace& w, const PerOperand<Table<FaceId, std::uint8_t>>& divided) {
  for (const Operand s : both_operands) {
    Patch& patch = w.patch[s];
    for (FarLoops& far : patch.far_loops) {
      if (!divided[s][far.face]) continue;
      const std::vector<FaceId> parts = parts_of(patch, far.face);
      if (parts.size() == 1) {
        far.lie_in(parts[0]);
        continue;
      }
      PartsOfFace face(w, patch, parts, *patch.solid->slot(far.slot).block);
      for (const LoopId l : far.loops) far.part[l] = face.part_of(l);
    }
  }
}

}  // namespace sectile
