#include "boolean/loading/load.h"

#include <algorithm>

#include "boolean/crowded_corners.h"
#include "boolean/loading/equal_planes.h"
#include "boolean/near/near_pairs.h"
#include "numbers/threshold.h"
#include "parallel/parallel.h"
#include "search/face_tree.h"

namespace sectile {
namespace {

// The faces of the slots that are near, those in pairs marked. They have numbers one after another:
// neither sorting nor search finds what is loaded.
class NearFaceMarks {
 public:
  NearFaceMarks(const SolidData& solid, std::span<const std::uint32_t> slots)
      : solid_(solid), slots_(slots), first_(solid.slots().size()) {
    std::uint32_t count = 0;
    for (const std::uint32_t slot : slots) {
      first_[slot] = count;
      count += solid.slot(slot).faces;
    }
    loaded_.assign(count, none);
  }

  void mark(FaceId f) { loaded_[number(f)] = 0; }
  /// Those that are marked, ascending; they are numbered in that order.
  std::vector<FaceId> marked() {
    std::vector<FaceId> faces;
    for (const std::uint32_t slot : slots_) {
      const std::size_t count = solid_.slot(slot).faces;
      for (std::size_t f = 0; f < count; ++f) {
        std::uint32_t& loaded = loaded_[first_[slot] + f];
        if (loaded == none) continue;
        loaded = static_cast<std::uint32_t>(faces.size());
        faces.push_back(solid_.face(slot, FaceId(f)));
      }
    }
    return faces;
  }
  /// The face of the patch that was loaded with the marked ones.
  FaceId loaded_face(const Patch& patch, FaceId f) const {
    return patch.whole ? f : FaceId(loaded_[number(f)]);
  }

 private:
  static constexpr std::uint32_t none = 0xFFFFFFFFu;
  std::size_t number(FaceId f) const {
    const std::uint32_t slot = solid_.slot_of(f);
    return first_[slot] + solid_.local(slot, f).value();
  }

  const SolidData& solid_;
  std::span<const std::uint32_t> slots_;
  std::vector<std::uint32_t> first_;   // per slot that is near
  std::vector<std::uint32_t> loaded_;  // per face of these slots
};

// Ascending, each once: by the first face at one go, then by the second ones of each.
void sort(FacePairs& pairs, std::size_t first_faces) {
  std::vector<std::uint32_t> end(first_faces + 1, 0);
  for (const auto& [f, g] : pairs) ++end[f.value() + 1];
  for (std::size_t f = 0; f < first_faces; ++f) end[f + 1] += end[f];
  FacePairs sorted(pairs.size());
  for (const auto& pair : pairs) sorted[end[pair.first.value()]++] = pair;
  for (std::size_t f = 0, from = 0; f < first_faces; from = end[f++])
    std::sort(sorted.begin() + static_cast<std::ptrdiff_t>(from),
              sorted.begin() + static_cast<std::ptrdiff_t>(end[f]));
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
  pairs = std::move(sorted);
}

// Of one solid, by the pairs of its faces, `loaded`, with those of the other one.
std::vector<FarLoops> far_loops(const Workspace& w, Operand s,
                                const PerOperand<const SolidData*>& of, const SlotPairs& slots,
                                const FacePairs& pairs, const std::vector<FaceId>& loaded,
                                const Wanted& wanted) {
  const SolidData &mine = *of[s], &across = *of[other(s)];
  const auto may_leave = [&](std::uint32_t slot) { return may_have_far_loops(mine.slot(slot)); };
  if (w.options.observer || wanted.operations.empty() || wanted.of_complement ||
      std::ranges::none_of(slots.slots(s), may_leave))
    return {};
  std::vector<FaceAndBox> near;
  for (const auto& [f, g] : pairs) {
    const FaceId face = s == Operand::a ? f : g, beyond = s == Operand::a ? g : f;
    if (!may_leave(mine.slot_of(face))) continue;
    const std::uint32_t slot = across.slot_of(beyond);
    const Block& block = *across.slot(slot).block;
    near.push_back({face, face_box(block.brep(), block.geometry(), across.local(slot, beyond))});
  }
  return find_far_loops(mine, loaded, std::move(near));
}

struct ToLoad {
  std::vector<FaceId> faces;
  std::vector<FarLoops> far_loops;

  Patch from(const SolidData& solid, Geometry& geometry, std::size_t more_edges = 0) {
    return load_patch(solid, faces, geometry, more_edges, std::move(far_loops));
  }
};

// Large ones beside each other, with geometries of their own at first.
void load_patches(Workspace& w, const SolidData& a, ToLoad of_a, const SolidData& b, ToLoad of_b,
                  std::size_t pairs) {
  constexpr std::size_t few = threshold(200, 1);
  Patch &patch_a = w.patch[Operand::a], &patch_b = w.patch[Operand::b];
  if (of_a.faces.size() < few || of_b.faces.size() < few) {
    // The two faces of a pair are cut once, as a rule: five new edges in each, with both ends.
    const std::size_t more_edges = 5 * std::min(pairs, few);
    patch_a = of_a.from(a, w.geometry, more_edges);
    patch_b = of_b.from(b, w.geometry, more_edges);
    return;
  }
  Geometry geometry_of_b;
  parallel::invoke([&] { patch_a = of_a.from(a, w.geometry); },
                   [&] { patch_b = of_b.from(b, geometry_of_b); });
  move_to_end(patch_b, geometry_of_b, w.geometry);
}

void load(Workspace& w, const SolidData& a, const SolidData& b, const SlotPairs& all_slots,
          FacePairs& pairs, const Wanted& wanted) {
  w.stay_alone_with_few(all_slots.count_faces(a, b));
  auto [slots, hubs, found, lines, crossings] = find_near(w, a, b, all_slots, wanted);
  pairs = std::move(found);
  NearFaceMarks of_a(a, slots.slots(Operand::a)), of_b(b, slots.slots(Operand::b));
  for (const auto& [f, g] : pairs) {
    of_a.mark(f);
    of_b.mark(g);
  }
  const PerOperand<std::vector<FaceId>> in_fans = lines ? lines->faces() : hubs.faces();
  const PerOperand<std::vector<FaceId>> at_crossings = crossings.faces();
  for (const auto& faces : {in_fans, at_crossings}) {
    for (const FaceId f : faces[Operand::a]) of_a.mark(f);
    for (const FaceId g : faces[Operand::b]) of_b.mark(g);
  }
  ToLoad to_load_of_a{of_a.marked(), {}}, to_load_of_b{of_b.marked(), {}};
  if (hubs.empty() && !lines && crossings.empty()) {  // what meets there is in no pair yet
    const PerOperand<const SolidData*> of{{&a, &b}};
    to_load_of_a.far_loops = far_loops(w, Operand::a, of, slots, pairs, to_load_of_a.faces, wanted);
    to_load_of_b.far_loops = far_loops(w, Operand::b, of, slots, pairs, to_load_of_b.faces, wanted);
  }
  load_patches(w, a, std::move(to_load_of_a), b, std::move(to_load_of_b), pairs.size());
  w.kernel = std::make_unique<Kernel>(w.geometry);
  for (auto& [f, g] : pairs) {
    f = of_a.loaded_face(w.patch[Operand::a], f);
    g = of_b.loaded_face(w.patch[Operand::b], g);
  }
  unite_equal_planes(w, pairs);
  complete_patches(w.patch, w.geometry, *w.kernel);
  if (lines)
    lines->mark(w);
  else
    hubs.add_pairs_of_owners(w, pairs);
  if (!crossings.empty()) {
    crossings.mark(w);
    crossings.add_pairs_of_owners(w, pairs);
  }
  for (Patch& patch : w.patch) find_crowded_corners(patch, w.geometry, w.tests());
  sort(pairs, w.patch[Operand::a].loaded_faces);
}

}  // namespace

void load(Workspace& w, const SolidData& a, const SolidData& b, FacePairs& pairs,
          const Wanted& wanted) {
  load(w, a, b, SlotPairs(a, b), pairs, wanted);
}

void load_slots(Workspace& w, const SolidData& solid, std::span<const std::uint32_t> slots,
                FacePairs& pairs, const Wanted& wanted) {
  load(w, solid, solid, SlotPairs(solid, slots), pairs, wanted);
}

}  // namespace sectile
