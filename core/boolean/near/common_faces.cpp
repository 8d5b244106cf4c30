#include "boolean/near/common_faces.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>

#include "boolean/collect.h"
#include "boolean/near/face_match.h"
#include "numbers/threshold.h"
#include "parallel/sort.h"
#include "search/box_index.h"
#include "search/face_tree.h"

namespace sectile {
namespace {

// Has a solid this face of another one, too?
bool has_face(const SolidData& solid, const FaceAt& face, const SolidData& of, FaceMatch& same) {
  const Block& block = *of.slot(face.slot).block;
  const Box box = face_box(block.brep(), block.geometry(), face.face);
  const auto meets = [&](const Box& around) { return around.contains(box); };
  bool has = false;
  solid.slot_tree().query(meets, [&](std::uint32_t i) {
    const std::uint32_t s = solid.slots_in_tree()[i];
    solid.slot(s).block->tree().query(meets, [&](std::uint32_t f) {
      has = has || same(face, {s, FaceId(f)}).has_value();
    });
  });
  return has;
}

}  // namespace

bool seem_to_have_common_faces(const SolidData& a, const SolidData& b, const SlotsOfBoth& slots) {
  // Less is tested in no time; and one in so many is enough.
  constexpr std::size_t few_faces = threshold(1000, 1), sample = 64, one_in = 16;
  const auto count = [](const SolidData& solid, std::span<const std::uint32_t> of) {
    return std::accumulate(of.begin(), of.end(), std::size_t(0),
                           [&](std::size_t n, std::uint32_t s) { return n + solid.slot(s).faces; });
  };
  const std::size_t of_a = count(a, slots[Operand::a]), of_b = count(b, slots[Operand::b]);
  if (std::min(of_a, of_b) < few_faces) return false;
  const bool a_has_fewer = of_a <= of_b;
  const SolidData &fewer = a_has_fewer ? a : b, &more = a_has_fewer ? b : a;
  FaceMatch same(fewer, more);
  const std::size_t step = (std::min(of_a, of_b) + sample - 1) / sample;
  std::size_t at = 0, looked_at = 0, common = 0;  // at: in the slot
  for (const std::uint32_t s : slots[a_has_fewer ? Operand::a : Operand::b]) {
    for (; at < fewer.slot(s).faces; at += step, ++looked_at)
      common += has_face(more, {s, FaceId(at)}, fewer, same) ? 1 : 0;
    at -= fewer.slot(s).faces;
  }
  return common * one_in >= looked_at;
}

class CommonFacesFinder {
 public:
  CommonFacesFinder(const Workspace& w, const SolidData& a, const SolidData& b,
                    const SlotsOfBoth& slots, CommonFaces& found)
      : w_(w), solid_{{&a, &b}}, slots_(slots), found_(found) {}

  void find() {
    for (const Operand s : both_operands) {
      const std::size_t count = solid_[s]->slots().size();
      found_.of_[s] = {std::vector<std::uint8_t>(count, CommonFaces::differing),
                       std::vector<std::uint32_t>(count, CommonFaces::none),
                       {},
                       std::vector<std::uint8_t>(count, CommonFaces::some_differ)};
    }
    match_blocks();
    choose_slots();
    for (const Operand s : both_operands)
      for (const std::uint32_t i : chosen_[s]) number_faces(s, i);
    match_faces();
    for (const Operand s : both_operands) mark_corners_of_others(s);
    for (const Operand s : both_operands) find_rim(s);
    count_deep_faces();
  }

  void give_up(const CommonFaces::Faces& faces) {
    std::vector<Box> boxes;
    for (const auto& [s, f] : faces) {
      const std::uint32_t i = solid_[s]->slot_of(f);
      const FaceId local = solid_[s]->local(i, f);
      for_each_corner(s, {i, local}, [&](const Vec3& p) { marked_.add(p); });
      const Block& block = *slot(s, i).block;
      boxes.push_back(face_box(block.brep(), block.geometry(), local));
    }
    const BoxIndex index(boxes);
    for (const Operand s : both_operands) {
      for (const std::uint32_t i : slots_[s]) {
        if (!index.any_overlaps(slot(s, i).block->bounds())) continue;
        chosen_[s].push_back(i);
        if (found_.of_[s].first[i] == CommonFaces::none) number_faces(s, i);
      }
      find_rim(s);
    }
    count_deep_faces();
  }

 private:
  struct Keyed {
    std::uint64_t key;
    FaceAt at;
    bool operator<(const Keyed& other) const {
      return std::tie(key, at.slot, at.face) < std::tie(other.key, other.at.slot, other.at.face);
    }
  };

  const Slot& slot(Operand s, std::uint32_t number) const { return solid_[s]->slot(number); }
  std::size_t number(Operand s, const FaceAt& at) const {
    return found_.of_[s].first[at.slot] + at.face.value();
  }
  std::uint8_t& state(Operand s, const FaceAt& at) const {
    return found_.of_[s].of_face[number(s, at)];
  }
  template <class Visit>
  void for_each_chosen(Operand s, const Visit& visit) const {
    for_each(w_, chosen_[s].size(), 4, [&](std::size_t i) { visit(chosen_[s][i]); });
  }
  template <class Visit>
  void for_each_face(Operand s, std::uint32_t i, const Visit& visit) const {
    for (std::uint32_t f = 0; f < slot(s, i).faces; ++f) visit(FaceAt{i, FaceId(f)});
  }
  template <class Visit>
  void for_each_corner(Operand s, const FaceAt& at, const Visit& visit) const {
    const Block& block = *slot(s, at.slot).block;
    const Brep& brep = block.brep();
    for_each_in_face(brep, at.face, [&](HalfEdgeId h) {
      visit(block.geometry().position(brep.point_of(brep.from(h))));
    });
  }

  // What both have as a block.
  void match_blocks() {
    std::vector<std::pair<const Block*, std::uint32_t>> of_b;
    for (const std::uint32_t i : slots_[Operand::b])
      of_b.push_back({slot(Operand::b, i).block.get(), i});
    std::sort(of_b.begin(), of_b.end());
    for (const std::uint32_t i : slots_[Operand::a]) {
      const Slot& of_a = slot(Operand::a, i);
      const auto same = std::ranges::lower_bound(of_b, of_a.block.get(), {},
                                                 &std::pair<const Block*, std::uint32_t>::first);
      const auto is_it = [&](auto at) { return at < of_b.end() && at->first == of_a.block.get(); };
      if (!is_it(same) || is_it(same + 1)) continue;
      const std::uint32_t j = same->second;
      const bool turned = of_a.turned != slot(Operand::b, j).turned;
      found_.of_[Operand::a].of_slot[i] = found_.of_[Operand::b].of_slot[j] =
          static_cast<std::uint8_t>(turned ? Class::on_minus : Class::on_plus);
    }
  }

  // The faces of a block that both have, and that is off all other ones, are all deep.
  void choose_slots() {
    std::vector<Box> others;
    const auto must_be = [&](Operand s, std::uint32_t i) {
      return found_.of_[s].of_slot[i] == CommonFaces::differing || slot(s, i).may_touch();
    };
    for (const Operand s : both_operands)
      for (const std::uint32_t i : slots_[s])
        if (must_be(s, i)) others.push_back(slot(s, i).block->bounds());
    const BoxIndex index(others);
    for (const Operand s : both_operands)
      for (const std::uint32_t i : slots_[s]) {
        if (must_be(s, i) || index.any_overlaps(slot(s, i).block->bounds()))
          chosen_[s].push_back(i);
        else
          found_.of_[s].others[i] = CommonFaces::none_is;
      }
  }

  void number_faces(Operand s, std::uint32_t i) {
    CommonFaces::OfSolid& of = found_.of_[s];
    of.first[i] = static_cast<std::uint32_t>(of.of_face.size());
    of.of_face.resize(of.of_face.size() + slot(s, i).faces, of.of_slot[i]);
  }

  void match_faces() {
    const std::vector<FaceAt> partner = find_partners(keys(Operand::a), keys(Operand::b));
    for_each_chosen(Operand::a, [&](std::uint32_t i) {
      FaceMatch match(*solid_[Operand::a], *solid_[Operand::b]);
      for_each_face(Operand::a, i, [&](const FaceAt& of_a) {
        const FaceAt of_b = partner[number(Operand::a, of_a)];
        if (of_b.slot == CommonFaces::none) return;
        if (const std::optional<Class> cls = match(of_a, of_b))
          state(Operand::a, of_a) = state(Operand::b, of_b) = static_cast<std::uint8_t>(*cls);
      });
    });
  }

  // Of the faces of blocks that not both have, by their corners, ascending.
  std::vector<Keyed> keys(Operand s) const {
    std::vector<std::uint32_t> slots, first = {0};
    for (const std::uint32_t i : chosen_[s]) {
      if (found_.of_[s].of_slot[i] != CommonFaces::differing) continue;
      slots.push_back(i);
      first.push_back(first.back() + slot(s, i).faces);
    }
    std::vector<Keyed> keys(first.back());
    for_each(w_, slots.size(), 4, [&](std::size_t i) {
      for_each_face(s, slots[i], [&](const FaceAt& at) {
        std::uint64_t key = 0;
        for_each_corner(s, at, [&](const Vec3& p) { key += hash_of(p); });
        keys[first[i] + at.face.value()] = {key, at};
      });
    });
    parallel::sort(keys.begin(), keys.end());
    return keys;
  }

  // Per numbered face of A: the one of B with its key, if both are the only ones.
  std::vector<FaceAt> find_partners(const std::vector<Keyed>& of_a,
                                    const std::vector<Keyed>& of_b) const {
    std::vector<FaceAt> partner(found_.of_[Operand::a].of_face.size(),
                                FaceAt{CommonFaces::none, {}});
    for_each_range(w_, of_a.size(), 4096, [&](std::size_t first, std::size_t last) {
      auto at = std::ranges::lower_bound(of_b, of_a[first].key, {}, &Keyed::key);
      for (std::size_t i = first; i < last; ++i) {
        while (at != of_b.end() && at->key < of_a[i].key) ++at;
        if (at == of_b.end()) return;
        if (at->key == of_a[i].key && !is_one_of_several(of_a, i) &&
            !is_one_of_several(of_b, static_cast<std::size_t>(at - of_b.begin())))
          partner[number(Operand::a, of_a[i].at)] = at->at;
      }
    });
    return partner;
  }
  static bool is_one_of_several(const std::vector<Keyed>& keys, std::size_t i) {
    return (i > 0 && keys[i - 1].key == keys[i].key) ||
           (i + 1 < keys.size() && keys[i + 1].key == keys[i].key);
  }

  // Of faces that differ; and where vertices may share places.
  void mark_corners_of_others(Operand s) {
    for (const std::uint32_t i : chosen_[s]) {
      const bool all = slot(s, i).may_touch();
      for_each_face(s, i, [&](const FaceAt& at) {
        if (all || state(s, at) == CommonFaces::differing)
          for_each_corner(s, at, [&](const Vec3& p) { marked_.add(p); });
      });
    }
  }

  // Common faces with a marked corner are at the rim.
  void find_rim(Operand s) {
    for_each_chosen(s, [&](std::uint32_t i) {
      std::uint8_t& others = found_.of_[s].others[i];
      others = CommonFaces::none_is;
      for_each_face(s, i, [&](const FaceAt& at) {
        std::uint8_t& face = state(s, at);
        if (face < CommonFaces::at_rim)
          for_each_corner(s, at, [&](const Vec3& p) {
            if (marked_.has(p)) face = CommonFaces::at_rim;
          });
        if (face == CommonFaces::differing)
          others = CommonFaces::some_differ;
        else if (face == CommonFaces::at_rim && others == CommonFaces::none_is)
          others = CommonFaces::some_at_rim;
      });
    });
  }

  void count_deep_faces() {
    found_.count_ = 0;
    for (const std::uint32_t i : slots_[Operand::a]) {
      if (found_.of_[Operand::a].first[i] == CommonFaces::none)
        found_.count_ += slot(Operand::a, i).faces;
      else
        for_each_face(Operand::a, i, [&](const FaceAt& at) {
          found_.count_ += state(Operand::a, at) < CommonFaces::at_rim ? 1 : 0;
        });
    }
    if (found_.count_ == 0) found_ = CommonFaces();
  }

  const Workspace& w_;
  const PerOperand<const SolidData*> solid_;
  const SlotsOfBoth& slots_;
  PerOperand<std::vector<std::uint32_t>> chosen_;  // those that are looked at face by face
  CommonFaces& found_;
  PlaceSet marked_;
};

CommonFaces::CommonFaces(const Workspace& w, const SolidData& a, const SolidData& b,
                         const SlotsOfBoth& slots) {
  CommonFacesFinder(w, a, b, slots, *this).find();
}

void CommonFaces::give_up(const Workspace& w, const SolidData& a, const SolidData& b,
                          const SlotsOfBoth& slots, const Faces& faces) {
  CommonFacesFinder(w, a, b, slots, *this).give_up(faces);
}

}  // namespace sectile
