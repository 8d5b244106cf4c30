// Finds the pairs of faces that may meet, and loads these faces.
#include <algorithm>
#include <atomic>
#include <limits>
#include <optional>

#include "boolean/boolean.h"
#include "boolean/collect.h"
#include "boolean/common_hubs.h"
#include "boolean/crowded_faces.h"
#include "boolean/crowded_lines.h"
#include "boolean/equal_planes.h"
#include "boolean/tables.h"
#include "numbers/threshold.h"
#include "parallel/scratch.h"
#include "storage/near_faces.h"

namespace sectile {
namespace {

// The slots of two solids whose blocks may meet.
class SlotPairs {
 public:
  SlotPairs(const SolidData& a, const SolidData& b) {
    BoxTree::overlaps(a.slot_tree(), b.slot_tree(), [&](std::uint32_t i, std::uint32_t j) {
      pairs_.push_back({a.slots_in_tree()[i], b.slots_in_tree()[j]});
    });
    collect_slots();
  }
  /// Of some slots of one solid, which are ascending.
  SlotPairs(const SolidData& solid, std::span<const std::uint32_t> slots) {
    std::vector<Box> boxes;
    for (const std::uint32_t s : slots) boxes.push_back(solid.slot(s).block->bounds());
    const BoxTree tree(boxes);
    BoxTree::overlaps(tree, tree, [&](std::uint32_t i, std::uint32_t j) {
      pairs_.push_back({slots[i], slots[j]});
    });
    collect_slots();
  }
  std::span<const std::pair<std::uint32_t, std::uint32_t>> pairs() const { return pairs_; }
  std::span<const std::uint32_t> slots(Operand s) const { return slots_[s]; }

 private:
  void collect_slots() {
    std::sort(pairs_.begin(), pairs_.end());
    for (const auto& [i, j] : pairs_) {
      if (slots_[Operand::a].empty() || slots_[Operand::a].back() != i)
        slots_[Operand::a].push_back(i);
      slots_[Operand::b].push_back(j);
    }
    std::vector<std::uint32_t>& of_b = slots_[Operand::b];
    std::sort(of_b.begin(), of_b.end());
    of_b.erase(std::unique(of_b.begin(), of_b.end()), of_b.end());
  }

  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs_;
  PerOperand<std::vector<std::uint32_t>> slots_;
};

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

}  // namespace

FaceId loaded_face(const Patch& patch, FaceId face) {
  if (patch.whole) return face;
  const auto at = std::lower_bound(patch.face_in_solid.begin(), patch.face_in_solid.end(), face);
  return FaceId(static_cast<std::size_t>(at - patch.face_in_solid.begin()));
}

namespace {

// Those that nobody has asked for before are made side by side.
void make_trees(const Workspace& w, const SolidData& solid, std::span<const std::uint32_t> slots) {
  std::vector<const Block*> without;
  for (const std::uint32_t s : slots)
    if (const Block& block = *solid.slot(s).block; !block.has_tree()) without.push_back(&block);
  for_each(w, without.size(), 4, [&](std::size_t i) { without[i]->tree(); });
}

// Pairs of faces that may meet, but for those that have a hub in common.
class NearPairs {
 public:
  NearPairs(const Workspace& w, const SolidData& a, const SolidData& b, const SlotPairs& slots,
            const CommonHubs& hubs)
      : w_(w), a_(a), b_(b), slots_(slots), hubs_(hubs) {}

  FacePairs all() {
    FacePairs pairs = by_blocks(std::numeric_limits<std::size_t>::max());
    if (!is_crowded()) return pairs;
    return pairs_of_crowded_faces(w_, a_, b_,
                                  {{slots_.slots(Operand::a), slots_.slots(Operand::b)}}, hubs_);
  }
  /// None if there are more than so many for each face, or very many had to be looked at: whichever
  /// of the threads comes first.
  std::optional<FacePairs> few(std::size_t for_each_face) {
    const std::size_t most = for_each_face * faces_;
    FacePairs pairs = by_blocks(most);
    if (is_crowded() || count_ > most) return {};
    hubs_.add_pairs(pairs);
    if (pairs.size() > most) return {};
    return pairs;
  }

 private:
  // More looks than so many for each face are a reason to divide space.
  static constexpr std::size_t very_many = threshold(128, 2);

  FacePairs by_blocks(std::size_t most) {
    looks_ = count_ = 0;
    parallel::Scratch<NearFaces> scratch;
    return joined(collect_ranges<FacePairs>(
        w_, slots_.pairs().size(), 8, [&](std::size_t first, std::size_t last, FacePairs& out) {
          scratch.lend([&](NearFaces& near) {
            for (const auto& [s, t] : slots_.pairs().subspan(first, last - first)) {
              if (is_crowded() || count_.load(std::memory_order_relaxed) > most) return;
              const std::size_t looks = near.looks(), count = out.size();
              add_pairs(s, t, near, out);
              looks_ += near.looks() - looks;
              count_ += out.size() - count;
            }
          });
        }));
  }

  void add_pairs(std::uint32_t s, std::uint32_t t, NearFaces& near, FacePairs& out) const {
    near(
        *a_.slot(s).block, *b_.slot(t).block,
        [&](std::uint32_t f, std::uint32_t g) {
          out.push_back({a_.face(s, FaceId(f)), b_.face(t, FaceId(g))});
        },
        [&](std::uint32_t hub, std::uint32_t across) {
          return !hubs_.empty() && hubs_.are_of_one_fan(s, hub, t, across);
        });
  }

  bool is_crowded() const { return looks_.load(std::memory_order_relaxed) > very_many * faces_; }

  std::size_t count_faces() const {
    std::size_t count = 0;
    for (const std::uint32_t s : slots_.slots(Operand::a)) count += a_.slot(s).faces;
    for (const std::uint32_t t : slots_.slots(Operand::b)) count += b_.slot(t).faces;
    return count;
  }

  const Workspace& w_;
  const SolidData &a_, &b_;
  const SlotPairs& slots_;
  const CommonHubs& hubs_;
  const std::size_t faces_ = count_faces();
  std::atomic<std::size_t> looks_ = 0, count_ = 0;
};

// For each face near the other solid. Where there are more, it is worth while to find out why.
constexpr std::size_t many_pairs = threshold(8, 1);

// Whoever follows the phases, or asks for all that is cut, is shown all that meets.
bool may_leave_out(const Workspace& w, const Wanted& wanted) {
  return !w.options.observer && !wanted.operations.empty() && !wanted.all_pairs;
}

// All pairs that may meet, or, if very many do for nothing, the lines where they do. Pairs of hubs
// are among them as far as directions tell.
std::optional<CrowdedLines> lines_or_pairs(const Workspace& w, const SolidData& a,
                                           const SolidData& b, const SlotPairs& slots,
                                           const CommonHubs& hubs, const Wanted& wanted,
                                           FacePairs& pairs) {
  NearPairs near(w, a, b, slots, hubs);
  if (may_leave_out(w, wanted)) {
    if (auto few = near.few(many_pairs)) {
      pairs = *std::move(few);
      return {};
    }
    CrowdedLines lines(a, b, {{slots.slots(Operand::a), slots.slots(Operand::b)}},
                       wanted.turned_pairs);
    if (!lines.empty()) {
      pairs = lines.pairs();
      return lines;
    }
  }
  pairs = near.all();
  hubs.add_pairs(pairs);
  return {};
}

// Of one solid, by the pairs of its faces, `loaded`, with those of the other one.
std::vector<FarLoops> far_loops(const Workspace& w, Operand s,
                                const PerOperand<const SolidData*>& of, const SlotPairs& slots,
                                const FacePairs& pairs, const std::vector<FaceId>& loaded,
                                const Wanted& wanted) {
  const SolidData &mine = *of[s], &across = *of[other(s)];
  const auto may_leave = [&](std::uint32_t slot) { return may_have_far_loops(mine.slot(slot)); };
  if (w.options.observer || wanted.operations.empty() ||
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
  constexpr std::size_t few = threshold(500, 1);
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

void load(Workspace& w, const SolidData& a, const SolidData& b, const SlotPairs& slots,
          FacePairs& pairs, const Wanted& wanted) {
  make_trees(w, a, slots.slots(Operand::a));
  make_trees(w, b, slots.slots(Operand::b));
  const CommonHubs hubs(a, b, {{slots.slots(Operand::a), slots.slots(Operand::b)}});
  const std::optional<CrowdedLines> lines = lines_or_pairs(w, a, b, slots, hubs, wanted, pairs);
  NearFaceMarks of_a(a, slots.slots(Operand::a)), of_b(b, slots.slots(Operand::b));
  for (const auto& [f, g] : pairs) {
    of_a.mark(f);
    of_b.mark(g);
  }
  const PerOperand<std::vector<FaceId>> in_fans = lines ? lines->faces() : hubs.faces();
  for (const FaceId f : in_fans[Operand::a]) of_a.mark(f);
  for (const FaceId g : in_fans[Operand::b]) of_b.mark(g);
  ToLoad to_load_of_a{of_a.marked(), {}}, to_load_of_b{of_b.marked(), {}};
  if (hubs.empty() && !lines) {  // what meets there is in no pair yet
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
  if (lines) {
    lines->mark(w);
    add_owners_on_lines(w, pairs);
  } else {
    hubs.add_pairs_of_owners(w, pairs);
  }
  sort(pairs, w.patch[Operand::a].loaded_faces);
}

}  // namespace

void load(Workspace& w, const SolidData& a, const SolidData& b, FacePairs& pairs,
          const Wanted& wanted) {
  load(w, a, b, SlotPairs(a, b), pairs, wanted);
}

void load_slots(Workspace& w, const SolidData& solid, std::span<const std::uint32_t> slots,
                FacePairs& pairs) {
  load(w, solid, solid, SlotPairs(solid, slots), pairs, {});
}

}  // namespace sectile
