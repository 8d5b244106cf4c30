// Finds the pairs of faces that may meet, and loads these faces.
#include <algorithm>

#include "boolean/boolean.h"
#include "boolean/collect.h"
#include "boolean/equal_planes.h"
#include "storage/near_faces.h"

namespace sectile {
namespace {

bool same_point(const Geometry& a, PointId p, const Geometry& b, PointId q) {
  if (!(a.position(p) == b.position(q))) return false;
  if (a.is_explicit(p) && b.is_explicit(q)) return true;
  Geometry both;
  const PointId mine = load_point(a, p, both), across = load_point(b, q, both);
  return Kernel(both).same_point(mine, across);
}

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
      slots_[Operand::a].push_back(i);
      slots_[Operand::b].push_back(j);
    }
    for (auto& slots : slots_) {
      std::sort(slots.begin(), slots.end());
      slots.erase(std::unique(slots.begin(), slots.end()), slots.end());
    }
  }

  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs_;
  PerOperand<std::vector<std::uint32_t>> slots_;
};

// The hubs of both solids' blocks, those at one place together.
class CommonHubs {
 public:
  CommonHubs(const SolidData& a, const SolidData& b, const SlotPairs& slots) : data_{&a, &b} {
    for (const Operand s : both_operands) {
      first_[s].resize(data_[s]->slots().size());
      for (const std::uint32_t slot : slots.slots(s)) {
        const std::size_t count = hubs(s, slot).size();
        first_[s][slot] = static_cast<std::uint32_t>(place_[s].size());
        for (std::uint32_t h = 0; h < count; ++h) order_.push_back({s, slot, h});
        place_[s].resize(place_[s].size() + count);
      }
    }
    if (place_[Operand::a].empty() || place_[Operand::b].empty()) order_.clear();
    std::sort(order_.begin(), order_.end(), [&](const Hub& g, const Hub& h) {
      const Vec3 &p = position(g), &q = position(h);
      return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z);
    });
    for (std::size_t i = 0; i < order_.size(); ++i) {
      std::size_t j = i;
      while (j > 0 && position(order_[j - 1]) == position(order_[i]) &&
             !are_at_one_place(order_[j - 1], order_[i]))
        --j;
      const bool known = j > 0 && position(order_[j - 1]) == position(order_[i]);
      place_of(order_[i]) = known ? place_of(order_[j - 1]) : static_cast<std::uint32_t>(i);
    }
    std::stable_sort(order_.begin(), order_.end(),
                     [&](const Hub& g, const Hub& h) { return place_of(g) < place_of(h); });
  }

  bool empty() const { return order_.empty(); }
  /// Hubs of two blocks.
  bool are_at_one_place(std::uint32_t slot_of_a, std::uint32_t hub_of_a, std::uint32_t slot_of_b,
                        std::uint32_t hub_of_b) const {
    return place_[Operand::a][first_[Operand::a][slot_of_a] + hub_of_a] ==
           place_[Operand::b][first_[Operand::b][slot_of_b] + hub_of_b];
  }

  /// The pairs that leave a common hub in a common direction.
  void add_pairs(FacePairs& pairs) const {
    for_each_place([&](const Fan& a, const Fan& b, const Vec3&) {
      BoxTree::overlaps(BoxTree(a.directions), BoxTree(b.directions),
                        [&](std::uint32_t i, std::uint32_t j) {
                          pairs.push_back({a.faces[i], b.faces[j]});
                        });
    });
  }

  /// All faces at a common hub meet there.
  template <class Marks>
  void mark_faces(Marks& of_a, Marks& of_b) const {
    for_each_place([&](const Fan& a, const Fan& b, const Vec3&) {
      for (const FaceId f : a.faces) of_a.mark(f);
      for (const FaceId g : b.faces) of_b.mark(g);
    });
  }

  /// The hub itself meets every face of the other fan: the pairs in which that is tested.
  void add_pairs_of_owners(const Workspace& w, FacePairs& pairs) const {
    for_each_place([&](const Fan& a, const Fan& b, const Vec3& place) {
      for (const FaceId f : owners_at(w, Operand::a, a, place))
        for (const FaceId g : b.faces) pairs.push_back({f, loaded_face(w.patch[Operand::b], g)});
      for (const FaceId g : owners_at(w, Operand::b, b, place))
        for (const FaceId f : a.faces) pairs.push_back({loaded_face(w.patch[Operand::a], f), g});
    });
  }

 private:
  struct Hub {
    Operand solid;
    std::uint32_t slot, number;
  };
  struct Fan {
    std::vector<FaceId> faces;
    std::vector<Box> directions;
  };

  const Block& block(Operand s, std::uint32_t slot) const { return *data_[s]->slot(slot).block; }
  const Block& block(const Hub& h) const { return block(h.solid, h.slot); }
  const Hubs& hubs(Operand s, std::uint32_t slot) const { return block(s, slot).tree().hubs(); }
  PointId point(const Hub& h) const { return hubs(h.solid, h.slot).point(h.number); }
  const Vec3& position(const Hub& h) const { return block(h).geometry().position(point(h)); }
  std::uint32_t& place_of(const Hub& h) {
    return place_[h.solid][first_[h.solid][h.slot] + h.number];
  }
  std::uint32_t place_of(const Hub& h) const {
    return place_[h.solid][first_[h.solid][h.slot] + h.number];
  }
  bool are_at_one_place(const Hub& g, const Hub& h) const {
    return same_point(block(g).geometry(), point(g), block(h).geometry(), point(h));
  }

  template <class Visit>
  void for_each_place(const Visit& visit) const {
    for (std::size_t from = 0, to; from < order_.size(); from = to) {
      PerOperand<Fan> fan;
      for (to = from; to < order_.size() && place_of(order_[to]) == place_of(order_[from]); ++to) {
        const Hub& h = order_[to];
        const auto faces = hubs(h.solid, h.slot).faces(h.number);
        Fan& mine = fan[h.solid];
        for (const FaceId f : faces) mine.faces.push_back(data_[h.solid]->face(h.slot, f));
        append(mine.directions,
               direction_boxes(block(h).brep(), block(h).geometry(), point(h), faces));
      }
      if (!fan[Operand::a].faces.empty() && !fan[Operand::b].faces.empty())
        visit(fan[Operand::a], fan[Operand::b], position(order_[from]));
    }
  }

  static std::vector<FaceId> owners_at(const Workspace& w, Operand s, const Fan& fan,
                                       const Vec3& place) {
    const Patch& patch = w.patch[s];
    std::vector<FaceId> owners;
    for (const FaceId f : fan.faces)
      for_each_in_face(patch.brep, loaded_face(patch, f), [&](HalfEdgeId h) {
        const VertexId v = patch.brep.from(h);
        if (w.geometry.position(patch.brep.point_of(v)) == place) owners.push_back(patch.owner(v));
      });
    std::sort(owners.begin(), owners.end());
    owners.erase(std::unique(owners.begin(), owners.end()), owners.end());
    return owners;
  }

  PerOperand<const SolidData*> data_;
  std::vector<Hub> order_;                        // by place
  PerOperand<std::vector<std::uint32_t>> first_;  // per slot: its first hub
  PerOperand<std::vector<std::uint32_t>> place_;  // per hub
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

// Those that are asked for are made side by side.
void make_trees(const Workspace& w, const SolidData& solid, std::span<const std::uint32_t> slots) {
  for_each(w, slots.size(), 16, [&](std::size_t i) { solid.slot(slots[i]).block->tree(); });
}

// Pairs of faces that may meet, but for those that have a hub in common.
void add_pairs(const Workspace& w, const SolidData& a, const SolidData& b, const SlotPairs& slots,
               const CommonHubs& hubs, FacePairs& pairs) {
  const auto parts = collect_ranges<FacePairs>(
      w, slots.pairs().size(), 8, [&](std::size_t first, std::size_t last, FacePairs& out) {
        NearFaces near;
        for (const auto& [s, t] : slots.pairs().subspan(first, last - first))
          near(
              *a.slot(s).block, *b.slot(t).block,
              [&, s = s, t = t](std::uint32_t f, std::uint32_t g) {
                out.push_back({a.face(s, FaceId(f)), b.face(t, FaceId(g))});
              },
              [&, s = s, t = t](std::uint32_t hub, std::uint32_t across) {
                return !hubs.empty() && hubs.are_at_one_place(s, hub, t, across);
              });
      });
  for (const FacePairs& part : parts) append(pairs, part);
}

// Large ones beside each other, with geometries of their own at first.
void load_patches(Workspace& w, const SolidData& a, const std::vector<FaceId>& of_a,
                  const SolidData& b, const std::vector<FaceId>& of_b) {
  constexpr std::size_t few = 500;
  Patch &patch_a = w.patch[Operand::a], &patch_b = w.patch[Operand::b];
  if (of_a.size() < few || of_b.size() < few) {
    patch_a = load_patch(a, of_a, w.geometry);
    patch_b = load_patch(b, of_b, w.geometry);
    return;
  }
  Geometry geometry_of_b;
  parallel::invoke([&] { patch_a = load_patch(a, of_a, w.geometry); },
                   [&] { patch_b = load_patch(b, of_b, geometry_of_b); });
  move_to_end(patch_b, geometry_of_b, w.geometry);
}

void load(Workspace& w, const SolidData& a, const SolidData& b, const SlotPairs& slots,
          FacePairs& pairs) {
  make_trees(w, a, slots.slots(Operand::a));
  make_trees(w, b, slots.slots(Operand::b));
  const CommonHubs hubs(a, b, slots);
  pairs.clear();
  add_pairs(w, a, b, slots, hubs, pairs);
  hubs.add_pairs(pairs);
  NearFaceMarks of_a(a, slots.slots(Operand::a)), of_b(b, slots.slots(Operand::b));
  for (const auto& [f, g] : pairs) {
    of_a.mark(f);
    of_b.mark(g);
  }
  hubs.mark_faces(of_a, of_b);
  load_patches(w, a, of_a.marked(), b, of_b.marked());
  w.kernel = std::make_unique<Kernel>(w.geometry);
  for (auto& [f, g] : pairs) {
    f = of_a.loaded_face(w.patch[Operand::a], f);
    g = of_b.loaded_face(w.patch[Operand::b], g);
  }
  unite_equal_planes(w, pairs);
  complete_patches(w.patch, w.geometry, *w.kernel);
  hubs.add_pairs_of_owners(w, pairs);
  sort(pairs, w.patch[Operand::a].loaded_faces);
}

}  // namespace

void load(Workspace& w, const SolidData& a, const SolidData& b, FacePairs& pairs) {
  load(w, a, b, SlotPairs(a, b), pairs);
}

void load_slots(Workspace& w, const SolidData& solid, std::span<const std::uint32_t> slots,
                FacePairs& pairs) {
  load(w, solid, solid, SlotPairs(solid, slots), pairs);
}

}  // namespace sectile
