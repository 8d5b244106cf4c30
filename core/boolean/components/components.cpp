#include "boolean/components/components.h"

#include <algorithm>
#include <optional>
#include <span>

#include "boolean/components/free_point.h"
#include "boolean/components/point_in_face.h"
#include "boolean/components/point_in_solid.h"
#include "boolean/components/steep_face.h"
#include "boolean/side_by_side.h"
#include "search/id_map.h"
#include "sectile/errors.h"

namespace sectile {
namespace {

constexpr std::uint8_t nothing = 0, unknown = RestLabels::unknown;

// Labels the faces of one operand.
class Labelling {
 public:
  Labelling(Workspace& w, const Contacts& contacts, Operand operand, const LabelOf& label_of,
            FaceLabels& labels)
      : w_(w),
        contacts_(contacts),
        operand_(operand),
        label_(label_of),
        patch_(w.patch[operand]),
        brep_(patch_.brep),
        loaded_(labels.loaded[operand]),
        rest_(labels.rest[operand]) {}

  // Changes nothing but the labels of its operand.
  void spread_from_segments(const Neighborhoods& neighborhoods, const JoinedCuts& joined) {
    loaded_.assign(brep_.face_count(), unknown);
    if (!patch_.unbounded) rest_ = RestLabels(patch_);
    if (!rest_.empty()) {
      find_regions();
      find_open_ends();
    }
    seed_from_segments(neighborhoods, joined);
    spread();
  }

  // May load points for rays.
  void label_untouched() {
    visit_untouched_shells();
    for (const FaceId f : loaded_.ids())
      if (!patch_.is_real(f)) loaded_[f] = nothing;
  }

 private:
  // A loaded face, a region, or a piece of a slot.
  struct Pending {
    std::uint32_t slot, number;
  };
  static constexpr std::uint32_t loaded_slot = 0xFFFFFFFFu, region_slot = 0xFFFFFFFEu;

  const SolidData& solid() const { return *patch_.solid; }
  const Slot& slot(std::uint32_t s) const { return patch_.solid->slot(s); }

  void find_regions() {
    const Patch& across = w_.patch[other(operand_)];
    if (across.unbounded || across.solid->slot_tree().empty()) return;
    rest_.set_regions(clear_regions(solid(), *across.solid));
    rest_.of_region(ClearRegions::beyond) = label_(operand_, Class::out);
  }

  void find_open_ends() {
    const Table<HalfEdgeId, HalfEdgeId>& in_solid = patch_.half_edge_in_solid;
    open_ends_.emplace(static_cast<std::size_t>(
        std::ranges::count_if(in_solid, [](HalfEdgeId h) { return h.valid(); })));
    for (const HalfEdgeId here : in_solid.ids())
      if (in_solid[here].valid()) (*open_ends_)[in_solid[here].value()] = here.value();
  }

  // True if the label is new.
  static bool set(std::uint8_t& now, std::uint8_t label) {
    if (now == label) return false;
    if (now != unknown)
      throw InternalError("a piece of a boundary is kept by one cut, not by another");
    now = label;
    return true;
  }
  void set_loaded(FaceId f, std::uint8_t label) {
    if (set(loaded_[f], label)) front_.push_back({loaded_slot, f.value()});
  }
  void set_region(std::uint32_t region, std::uint8_t label) {
    if (set(rest_.of_region(region), label)) front_.push_back({region_slot, region});
  }
  // Of a slot in no region.
  void set_own(std::uint32_t s, std::uint32_t piece, std::uint8_t label) {
    if (set(rest_.of_piece(s, piece), label)) front_.push_back({s, piece});
  }
  void set_piece(std::uint32_t s, std::uint32_t piece, std::uint8_t label) {
    if (const std::uint32_t region = rest_.region(s); region != RestLabels::none)
      set_region(region, label);
    else
      set_own(s, piece, label);
  }
  void set_rest(std::uint32_t s, FaceId local, std::uint8_t label) {
    if (const std::uint32_t region = rest_.region(s); region != RestLabels::none)
      set_region(region, label);
    else
      set_own(s, rest_.piece(s, local), label);
  }

  void seed_from_segments(const Neighborhoods& n, const JoinedCuts& joined) {
    for (const HalfPlane& h : n.half_planes) {
      if (h.operand != operand_) continue;
      const std::uint8_t label = label_(operand_, h.cls);
      const CutSides& sides = joined.sides[h.carrier];
      // Beside a cut the part is known; elsewhere only a face that was not divided.
      if (n.carriers[h.carrier].cut)
        set_loaded(brep_.face_of(h.forward ? sides.forward : sides.backward), label);
      else if (!joined.divided[operand_][h.face])
        set_loaded(h.face, label);
    }
  }

  void spread() {
    while (!front_.empty()) {
      const Pending next = front_.back();
      front_.pop_back();
      spread(next);
    }
  }

  void spread(const Pending& next) {
    if (next.slot == loaded_slot)
      spread_loaded(FaceId(next.number));
    else if (next.slot == region_slot)
      spread_region(next.number);
    else if (rest_.is_touched(next.slot))
      spread_left(next.slot, next.number);
    else
      spread_piece(next.slot, next.number);
  }

  void spread_loaded(FaceId face) {
    const std::uint8_t label = loaded_[face];
    for_each_in_face(brep_, face, [&](HalfEdgeId h) {
      const HalfEdgeId back = Brep::twin(h);
      // Parts on both sides of a null edge touch in a point only.
      if (patch_.is_null(h)) return;
      const FaceId beyond = brep_.face_of(back);
      switch (brep_.kind_of(beyond)) {
        case FaceKind::real:
          set_loaded(beyond, label);
          break;
        case FaceKind::null:
          break;
        case FaceKind::rest:
          spread_to(patch_.half_edge_in_solid[back], label);
          break;
      }
    });
    if (const FarLoops* far = patch_.far_loops_of(patch_.root_of(face)))
      spread_over_far_loops(*far, face);
  }

  // To what lies beyond: none of it is loaded, and as a rule a loop leads to one piece.
  void spread_over_far_loops(const FarLoops& far, FaceId part) {
    const Slot& from = slot(far.slot);
    BorderLink known;  // at first the slot itself, to which no border leads
    for (const LoopId l : far.loops) {
      if (far.part[l] != part) continue;
      for_each_in_loop(from.block->brep(), l, [&](HalfEdgeId h) {
        const BorderLink& link = from.links->all()[Brep::edge_of(h).value()];
        if (link.slots == known.slots && link.piece == known.piece) return;
        spread_across(far.slot, h, loaded_[part]);
        if (!rest_.is_touched(far.slot + static_cast<std::uint32_t>(link.slots))) known = link;
      });
    }
  }

  void spread_to(HalfEdgeId in_solid, std::uint8_t label) {
    const std::uint32_t s = solid().slot_of(in_solid);
    set_rest(s, slot(s).block->brep().face_of(solid().local(s, in_solid)), label);
  }

  // All faces of a piece have its label; it ends at the block's borders.
  void spread_piece(std::uint32_t s, std::uint32_t piece) {
    const std::uint8_t label = rest_.of_piece(s, piece);
    if (!slot(s).links) return;
    const BorderLinks& links = *slot(s).links;
    for (const BorderLinks::Neighbour& n : links.neighbours(*slot(s).block, piece)) {
      const std::uint32_t t = s + static_cast<std::uint32_t>(n.slots);
      if (!rest_.is_touched(t))
        set_piece(t, n.piece, label);
      else
        for (const std::uint32_t border : links.borders(n))
          spread_across(s, Brep::half_edge(EdgeId(border)), label);
    }
  }

  // The same of what is left of a block: it ends at loaded faces as well.
  void spread_left(std::uint32_t s, std::uint32_t piece) {
    const std::uint8_t label = rest_.of_piece(s, piece);
    const Block& block = *slot(s).block;
    for (const HalfEdgeId h : rest_.left().ends(s, piece)) {
      if (block.is_border(h))
        spread_across(s, h, label);
      else
        set_loaded(loaded_beyond(s, h), label);
    }
  }

  void spread_across(std::uint32_t s, HalfEdgeId h, std::uint8_t label) {
    const BorderLink& link = slot(s).links->all()[Brep::edge_of(h).value()];
    const std::uint32_t t = s + static_cast<std::uint32_t>(link.slots);
    if (!rest_.is_touched(t)) return set_piece(t, link.piece, label);
    const FaceId face = slot(t).block->brep().face_of(Brep::half_edge(EdgeId(link.border)));
    if (rest_.is_loaded(t, face))
      set_loaded(loaded_beyond(s, h), label);
    else
      set_own(t, rest_.piece(t, face), label);
  }

  // The loaded face across a half-edge of a face that is not loaded.
  FaceId loaded_beyond(std::uint32_t s, HalfEdgeId h) const {
    if (!patch_.far_loops.empty()) {
      const auto beyond = solid().across(s, h);
      const FaceId part = patch_.part_of_far(beyond.slot, beyond.local);
      if (part.valid()) return part;
    }
    const HalfEdgeId open_end(open_ends_->known(solid().half_edge(s, h).value()));
    return brep_.face_of(Brep::twin(open_end));
  }

  void visit_untouched_shells() {
    std::optional<FreePoints> points;
    if (!rest_.empty()) spread_from_regions();
    for (const FaceId f : loaded_.ids()) {
      if (loaded_[f] != unknown || !patch_.is_real(f)) continue;
      if (patch_.unbounded) {  // nothing meets the plane: no part of it is inside the solid
        set_loaded(f, label_(operand_, Class::out));
        continue;
      }
      if (!points) points.emplace(w_, contacts_, operand_);
      set_loaded(f, label_of(points->on_shell_of(f), [&] { return points->facing_x(); }));
      spread();
    }
    if (rest_.empty()) return;
    for (std::uint32_t s = 0; s < solid().slots().size(); ++s) {
      if (!rest_.has(s, unknown)) continue;
      for (std::uint32_t piece = 0; piece < rest_.count(s); ++piece) {
        if (rest_.label_of_piece(s, piece) != unknown) continue;
        settle(s, piece);
        spread();
      }
    }
  }

  // What no segment has reached may hang together with what is in a region.
  struct Waiting {
    std::uint32_t region;
    Pending what;
  };

  void spread_from_regions() {
    find_waiting();
    for (std::uint32_t region = 0; region < rest_.region_count(); ++region)
      if (rest_.of_region(region) != unknown) spread_region(region);
    spread();
  }

  void find_waiting() {
    for (const HalfEdgeId here : patch_.half_edge_in_solid.ids())
      if (const HalfEdgeId h = patch_.half_edge_in_solid[here]; h.valid())
        wait_for_slot(solid().slot_of(h), brep_.face_of(Brep::twin(here)));
    for (const FarLoops& far : patch_.far_loops)
      for (const LoopId l : far.loops)
        for_each_in_loop(slot(far.slot).block->brep(), l, [&](HalfEdgeId h) {
          wait_for_slot(solid().across(far.slot, h).slot, far.part[l]);
        });
    for (std::uint32_t s = 0; s < solid().slots().size(); ++s)
      if (rest_.region(s) == RestLabels::none && !slot(s).empty() && rest_.has(s, unknown))
        wait_for_neighbours(s);
    std::ranges::sort(waiting_, {}, &Waiting::region);
  }
  void wait_for_slot(std::uint32_t s, FaceId loaded) {
    if (loaded_[loaded] == unknown && rest_.region(s) != RestLabels::none)
      waiting_.push_back({rest_.region(s), {loaded_slot, loaded.value()}});
  }
  void wait_for_neighbours(std::uint32_t s) {
    const Block& block = *slot(s).block;
    for (std::uint32_t border = 0; border < block.border_count; ++border) {
      const HalfEdgeId h = Brep::half_edge(EdgeId(border));
      const std::uint32_t region = rest_.region(solid().across(s, h).slot);
      if (region == RestLabels::none) continue;
      const FaceId face = block.brep().face_of(h);
      if (rest_.label(s, face) == unknown) waiting_.push_back({region, {s, rest_.piece(s, face)}});
    }
  }

  void spread_region(std::uint32_t region) {
    const std::uint8_t label = rest_.of_region(region);
    for (auto w = std::ranges::lower_bound(waiting_, region, {}, &Waiting::region);
         w != waiting_.end() && w->region == region; ++w) {
      if (w->what.slot == loaded_slot)
        set_loaded(FaceId(w->what.number), label);
      else
        set_own(w->what.slot, w->what.number, label);
    }
  }

  // A shell that both boundaries have is the only one that lies on the other boundary.
  void settle(std::uint32_t s, std::uint32_t piece) {
    const FaceId f = rest_.is_touched(s) ? rest_.left().face_of(s, piece)
                                         : slot(s).block->pieces().face_of(piece);
    if (w_.common_faces.has(operand_, s, f))
      set_rest(s, f, label_(operand_, w_.common_faces.class_of(operand_, s, f)));
    else
      settle_by_ray(s, f);
  }

  void settle_by_ray(std::uint32_t s, FaceId f) {
    const Brep& brep = slot(s).block->brep();
    const HalfEdgeId h = brep.loop_half_edge[brep.outer_loop[f]];
    const PointId p =
        load_point(slot(s).block->geometry(), brep.point_of(brep.from(h)), w_.geometry);
    w_.kernel->refresh();
    set_rest(s, f, label_of(std::span(&p, 1), [&] { return point_within(s, f); }));
  }
  // Within a face that hangs together with one that is not loaded, and is off the other boundary as
  // that is.
  PointId point_within(std::uint32_t s, FaceId f) {
    const auto is_off = [&](const FaceAt& at) {
      return !rest_.is_loaded(at.slot, at.face) &&
             w_.common_faces.differs(operand_, at.slot, at.face);
    };
    const auto steep = steep_face_near(solid(), {s, f}, is_off);
    if (!steep) return {};
    const FaceId face = solid().face(steep->slot, steep->face);
    const Patch alone = load_patch(solid(), {face}, w_.geometry);
    w_.kernel->refresh();
    return point_in_face(w_, alone, loaded_face(alone, face), 0.5, [](PointId) { return true; });
  }

  // Of what some points lie on, which all lie on one side of the other boundary. further() makes
  // one more, if any: parts in a row have their corners on one line, and rays between them do not
  // come near to edges.
  template <class Further>
  std::uint8_t label_of(std::span<const PointId> points, const Further& further) {
    return label_(operand_, are_inside(points, further) ? Class::in : Class::out);
  }
  template <class Further>
  bool are_inside(std::span<const PointId> points, const Further& further) {
    if (!is_inside_) is_inside_.emplace(w_, other(operand_));
    for (const PointId p : points)
      if (const std::optional<bool> is = is_inside_->if_clear(p)) return *is;
    if (const PointId p = further(); p.valid())
      if (const std::optional<bool> is = is_inside_->if_clear(p)) return *is;
    return (*is_inside_)(points[0]);
  }

  Workspace& w_;
  const Contacts& contacts_;
  Operand operand_;
  const LabelOf& label_;
  const Patch& patch_;
  const Brep& brep_;
  Table<FaceId, std::uint8_t>& loaded_;
  RestLabels& rest_;
  std::optional<PointInSolid> is_inside_;  // the other operand, of points of shells
  std::optional<IdMap> open_ends_;         // if not all of the operand is loaded
  std::vector<Waiting> waiting_;           // without label, by the regions beside them
  std::vector<Pending> front_;             // from where labels may spread further
};

}  // namespace

FaceLabels find_components(Workspace& w, const Contacts& contacts,
                           const Neighborhoods& neighborhoods, const JoinedCuts& joined,
                           const LabelOf& label_of) {
  FaceLabels labels;
  Labelling labelling[] = {{w, contacts, Operand::a, label_of, labels},
                           {w, contacts, Operand::b, label_of, labels}};
  for_both_operands(neighborhoods.half_planes.size(), [&](Operand s) {
    labelling[static_cast<std::size_t>(s)].spread_from_segments(neighborhoods, joined);
  });
  for (Labelling& operand : labelling) operand.label_untouched();
  return labels;
}

FaceLabels find_kept(Workspace& w, const Contacts& contacts, const Neighborhoods& neighborhoods,
                     const JoinedCuts& joined, Operation operation) {
  return find_components(w, contacts, neighborhoods, joined,
                         [operation](Operand operand, Class c) -> std::uint8_t {
                           return kept(operation, operand, c) ? 1 : 0;
                         });
}

}  // namespace sectile
