#include "boolean/near/near_pairs.h"

#include <atomic>
#include <limits>
#include <utility>

#include "boolean/collect.h"
#include "boolean/near/crowded_faces.h"
#include "boolean/near/nested_faces.h"
#include "numbers/threshold.h"
#include "parallel/scratch.h"
#include "storage/near_faces.h"

namespace sectile {
namespace {

// Those that nobody has asked for before are made side by side.
void make_trees(const Workspace& w, const SolidData& solid, std::span<const std::uint32_t> slots) {
  std::vector<const Block*> without;
  for (const std::uint32_t s : slots)
    if (const Block& block = *solid.slot(s).block; !block.has_tree()) without.push_back(&block);
  for_each(w, without.size(), 4, [&](std::size_t i) { without[i]->tree(); });
}

// Pairs of faces that may meet, but for those that have a hub in common, and of faces that lie deep
// in what is common those with faces that differ.
class NearPairs {
 public:
  NearPairs(const Workspace& w, const SolidData& a, const SolidData& b, const SlotPairs& slots,
            const CommonHubs& hubs)
      : w_(w), a_(a), b_(b), slots_(slots), hubs_(hubs) {}

  FacePairs all() {
    FacePairs pairs = by_blocks(std::numeric_limits<std::size_t>::max());
    if (!is_crowded()) return pairs;
    return pairs_of_crowded_faces(w_, a_, b_, slots_.slots(), hubs_);
  }
  /// None if there are more than so many for each face, or very many had to be looked at: whichever
  /// of the threads comes first.
  std::optional<FacePairs> few(std::size_t for_each_face) {
    const std::size_t most = for_each_face * faces_;
    FacePairs pairs = by_blocks(most);
    if (is_crowded() || count_ > most) return {};
    if (!hubs_.add_pairs(pairs, most)) return {};
    return pairs;
  }
  /// Did very many have to be looked at?
  bool is_crowded() const { return looks_.load(std::memory_order_relaxed) > very_many * faces_; }

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
    const Block &of_a = *a_.slot(s).block, &of_b = *b_.slot(t).block;
    const auto visit = [&](std::uint32_t f, std::uint32_t g) {
      out.push_back({a_.face(s, FaceId(f)), b_.face(t, FaceId(g))});
    };
    const auto skip = [&](std::uint32_t hub, std::uint32_t across) {
      return !hubs_.empty() && hubs_.are_of_one_fan(s, hub, t, across);
    };
    if (w_.common_faces.empty())
      near(of_a, of_b, visit, skip);
    else
      near(of_a, of_b, visit, skip, BesideDeepOnes{w_.common_faces, s, t});
  }

  // What is common meets nothing else of what is common where it is deep.
  struct BesideDeepOnes {
    const CommonFaces& common;
    std::uint32_t s, t;
    using Faces = std::span<const std::uint32_t>;

    bool is_deep(Operand of, std::uint32_t f) const {
      return common.has(of, of == Operand::a ? s : t, FaceId(f));
    }
    bool differs(Operand of, std::uint32_t f) const {
      return common.differs(of, of == Operand::a ? s : t, FaceId(f));
    }
    bool operator()(std::uint32_t f, std::uint32_t g) const {
      return (is_deep(Operand::a, f) && !differs(Operand::b, g)) ||
             (is_deep(Operand::b, g) && !differs(Operand::a, f));
    }
    bool operator()(Faces of_a, Faces of_b) const {
      const auto all_deep = [&](Operand of, Faces faces) {
        return std::ranges::all_of(faces, [&](std::uint32_t f) { return is_deep(of, f); });
      };
      const auto any_differs = [&](Operand of, Faces faces) {
        return std::ranges::any_of(faces, [&](std::uint32_t f) { return differs(of, f); });
      };
      return (all_deep(Operand::a, of_a) && !any_differs(Operand::b, of_b)) ||
             (all_deep(Operand::b, of_b) && !any_differs(Operand::a, of_a));
    }
  };

  const Workspace& w_;
  const SolidData &a_, &b_;
  const SlotPairs& slots_;
  const CommonHubs& hubs_;
  const std::size_t faces_ = slots_.count_faces(a_, b_);
  std::atomic<std::size_t> looks_ = 0, count_ = 0;
};

// For each face near the other solid. Where there are more, it is worth while to find out why. What
// differs hangs together with what is common, where there are that many.
constexpr std::size_t many_pairs = threshold(8, 1), many_pairs_of_what_differs = threshold(64, 16);
constexpr std::size_t many_pairs_of_a_crowd = threshold(32, 1);
// All pairs of so few faces that leave their boxes empty are no more than others.
constexpr std::size_t few_hollow = threshold(16, 0);
// So many pairs of slots for each slot lie around each other, as rings in rings do, or cross.
constexpr std::size_t many_pairs_of_slots = threshold(64, 1);
// A solid that is tested against itself has some for each face at all of its corners.
constexpr std::size_t many_with_itself = threshold(32, 1);

class NearFinder {
  // What touches a face that was taken for deep makes others be none.
  static constexpr int most_rounds = 4;

 public:
  NearFinder(Workspace& w, const SolidData& a, const SolidData& b, const SlotPairs& slots,
             const Wanted& wanted)
      : w_(w), a_(a), b_(b), slots_(slots), wanted_(wanted) {}

  Near run() {
    if (!may_leave_out()) return whole();
    if (&a_ == &b_) return with_itself();
    const bool have_much_in_common =
        slots_.have_common_blocks(a_, b_) || seem_to_have_common_faces(a_, b_, slots_.slots());
    if (have_much_in_common)
      if (auto near = what_differs()) return fewest(*std::move(near));
    if (has_nested_slots())
      if (auto near = nested(); near && near->pairs.size() <= many_with_itself * faces_)
        return *std::move(near);
    if (auto near = few(slots_, many_pairs)) return *std::move(near);
    if (!have_much_in_common)
      if (auto near = what_differs()) return fewest(*std::move(near));
    return many();
  }

 private:
  // Whoever follows the phases, or asks for all that is cut, is shown all that meets.
  bool may_leave_out() const {
    return !w_.options.observer && !wanted_.operations.empty() && !wanted_.all_pairs;
  }

  bool has_nested_slots() const {
    const SlotsOfBoth slots = slots_.slots();
    return slots_.pairs().size() >
           many_pairs_of_slots * (slots[Operand::a].size() + slots[Operand::b].size());
  }

  Near with_itself() {
    if (auto near = few(slots_, many_with_itself)) return *std::move(near);
    return many();
  }

  // Not those that matter, but all.
  Near whole() {
    if (auto near = few(slots_, many_pairs)) return *std::move(near);
    if (auto near = nested()) return *std::move(near);
    return all();
  }

  Near many() {
    auto near = nested();
    if (near && near->pairs.size() <= many_with_itself * faces_) return *std::move(near);
    if (auto beside = all_but_along_crowded_lines()) return *std::move(beside);
    if (&a_ != &b_) {
      if (auto few_of_a_crowd = few(slots_, many_pairs_of_a_crowd))
        return *std::move(few_of_a_crowd);
      if (auto beside = all_but_at_crossings()) return *std::move(beside);
    }
    return near ? *std::move(near) : all();
  }

  Near without_pairs(const SlotPairs& slots) const {
    make_trees(w_, a_, slots.slots(Operand::a));
    make_trees(w_, b_, slots.slots(Operand::b));
    return {slots, CommonHubs(a_, b_, slots.slots(), w_.common_faces), {}, {}, {}};
  }

  Near all() const {
    Near near = without_pairs(slots_);
    near.pairs = is_crowded_ ? pairs_of_crowded_faces(w_, a_, b_, slots_.slots(), near.hubs)
                             : NearPairs(w_, a_, b_, near.slots, near.hubs).all();
    near.hubs.add_pairs(near.pairs);
    return near;
  }

  // Where very many had to be looked at once, nobody looks again.
  std::optional<Near> few(const SlotPairs& slots, std::size_t for_each_face) {
    if (&slots == &slots_ && is_crowded_) return {};
    Near near = without_pairs(slots);
    NearPairs search(w_, a_, b_, near.slots, near.hubs);
    auto pairs = search.few(for_each_face);
    if (&slots == &slots_) is_crowded_ = search.is_crowded();
    if (!pairs) return {};
    near.pairs = *std::move(pairs);
    return near;
  }

  // What is common is among all pairs again, if these are by far fewer when faces that lie in holes
  // of others are looked at in pieces.
  Near fewest(Near what_differs) {
    if (what_differs.pairs.size() <= many_pairs * faces_) return what_differs;
    CommonFaces common = std::exchange(w_.common_faces, CommonFaces());
    if (auto near = nested(); near && 2 * near->pairs.size() < what_differs.pairs.size())
      return *std::move(near);
    w_.common_faces = std::move(common);
    return what_differs;
  }

  // None if no faces or slots lie in holes of others, or faces have so many corners that all pairs
  // of them take no longer. There is one tree for all faces: where each slot is a ring in a ring,
  // their own ones would be compared each with each.
  std::optional<Near> nested() {
    const NestedFaces faces(w_, a_, b_, slots_.slots());
    if (faces.hollow_faces() <= few_hollow && !is_crowded_ && !has_nested_slots()) return {};
    const std::size_t for_each_face = faces.hollow_corners() / faces_;
    if (for_each_face > many_pairs)
      if (auto near = few(slots_, for_each_face)) return near;
    Near near = without_pairs(slots_);
    auto pairs = faces.pairs(near.hubs);
    if (!pairs) return {};
    near.pairs = *std::move(pairs);
    near.hubs.add_pairs(near.pairs);
    return near;
  }

  // None if all differs, or there are many pairs all the same. What is common would be loaded with
  // a solid that is loaded whole, which is small then.
  std::optional<Near> what_differs() {
    if (a_.is_whole() || b_.is_whole()) return {};
    const SlotsOfBoth slots = slots_.slots();
    CommonFaces& common = w_.common_faces;
    common = CommonFaces(w_, a_, b_, slots);
    for (int round = 0; round < most_rounds && !common.empty(); ++round) {
      auto near = few(slots_.without(common), many_pairs_of_what_differs);
      if (!near) break;
      CommonFaces::Faces touched = touched_deep_faces(near->pairs);
      append(touched, near->hubs.left_out_on_lines());
      if (touched.empty()) return near;
      common.give_up(w_, a_, b_, slots, touched);
    }
    common = CommonFaces();
    return {};
  }

  // What meets a face that differs was taken for deep wrongly. Other pairs of deep ones are
  // dropped.
  CommonFaces::Faces touched_deep_faces(FacePairs& pairs) const {
    CommonFaces::Faces touched;
    std::erase_if(pairs, [&](const auto& pair) {
      const auto& [f, g] = pair;
      const bool first = is_deep(Operand::a, f), second = is_deep(Operand::b, g);
      if (!first && !second) return false;
      if (apart(hull(Operand::a, f), hull(Operand::b, g))) return true;
      touched.push_back(first ? std::pair(Operand::a, f) : std::pair(Operand::b, g));
      return false;
    });
    return touched;
  }

  const SolidData& solid(Operand s) const { return s == Operand::a ? a_ : b_; }
  bool is_deep(Operand s, FaceId f) const {
    const std::uint32_t slot = solid(s).slot_of(f);
    return w_.common_faces.has(s, slot, solid(s).local(slot, f));
  }
  Hull hull(Operand s, FaceId f) const {
    const std::uint32_t slot = solid(s).slot_of(f);
    const Block& block = *solid(s).slot(slot).block;
    return face_hull(block.brep(), block.geometry(), solid(s).local(slot, f));
  }

  std::optional<Near> all_but_along_crowded_lines() const {
    CrowdedLines lines(a_, b_, slots_.slots());
    if (lines.empty()) return {};
    Near near = without_pairs(slots_);
    near.pairs = lines.pairs();
    near.lines = std::move(lines);
    return near;
  }

  std::optional<Near> all_but_at_crossings() const {
    Near near = without_pairs(slots_);
    auto beside = pairs_beside_crossings(w_, a_, b_, near.slots.slots(), near.hubs);
    if (!beside) return {};
    near.pairs = std::move(beside->pairs);
    near.crossings = std::move(beside->crossings);
    near.hubs.add_pairs(near.pairs);
    return near;
  }

  Workspace& w_;
  const SolidData &a_, &b_;
  const SlotPairs& slots_;
  const Wanted& wanted_;
  const std::size_t faces_ = slots_.count_faces(a_, b_);
  bool is_crowded_ = false;  // were very many faces, or nodes above them, looked at in all slots?
};

}  // namespace

Near find_near(Workspace& w, const SolidData& a, const SolidData& b, const SlotPairs& slots,
               const Wanted& wanted) {
  return NearFinder(w, a, b, slots, wanted).run();
}

}  // namespace sectile
