#include "storage/faces_on_ray.h"

#include <algorithm>

#include "numbers/threshold.h"
#include "search/approximate.h"
#include "search/missed_face.h"

namespace sectile {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
// So many blocks are looked at in no more time than their oriented boxes take.
constexpr std::size_t few_slots = threshold(8, 0);
// To make an oriented box or a tree takes about as long as so many steps.
constexpr std::size_t steps_for_a_box = threshold(8, 0);
constexpr std::size_t many_corners = threshold(64, 5);

std::size_t corner_count(const Brep& brep, FaceId face) {
  std::size_t count = 0;
  for_each_in_face(brep, face, [&](HalfEdgeId) { ++count; });
  return count;
}

bool has_many_corners(const Brep& brep, FaceId face) {
  std::size_t count = 0;
  for (LoopId l = brep.outer_loop[face]; l.valid(); l = brep.next_loop[l]) {
    const HalfEdgeId first = brep.loop_half_edge[l];
    HalfEdgeId h = first;
    do {
      if (++count == many_corners) return true;
      h = brep.next_of(h);
    } while (h != first);
  }
  return false;
}

template <class Visit>
void for_each_child(const BoxTree& tree, BoxTree::Node n, const Visit& visit) {
  for (std::uint32_t i = 0; i < tree.child_count(n); ++i) visit(BoxTree::child(n, i));
}

// Corners of an oriented box that is so much larger that all of it is in their hull, and that they
// are known up to half an ulp.
template <class Add>
void for_each_corner(const OrientedBox& box, const Add& add) {
  using namespace approximate;
  const double more = 4 * box.slack + 0x1p-40 * max_norm(box.centre);
  for (int k = 0; k < 8; ++k) {
    Vec3 p = box.centre;
    for (int i = 0; i < 3; ++i)
      p = p + ((k >> i & 1) != 0 ? 1 : -1) * (1 + 0x1p-40) * (box.extent[i] + more) * box.axis[i];
    add(p);
  }
}

}  // namespace

FacesOnRay::FacesOnRay(const SolidData& solid) : solid_(solid), of_slot_(solid.slots().size()) {}

void FacesOnRay::start(const Vec3& from) {
  ray_.emplace(from);
  front_.clear();
  slots_entered_ = 0;
  if (!solid_.slot_tree().empty()) add_slots(solid_.slot_tree().root(), -infinity);
}

void FacesOnRay::push(Entry entry, double from) {
  if (from == infinity) return;
  entry.from = std::max(entry.from, from);
  front_.push_back(entry);
  std::push_heap(front_.begin(), front_.end());
}

std::optional<FacesOnRay::Met> FacesOnRay::next() {
  std::pop_heap(front_.begin(), front_.end());
  const Entry entry = front_.back();
  front_.pop_back();
  switch (entry.kind) {
    case Entry::Kind::slots:
      enter_slots(entry);
      return {};
    case Entry::Kind::slot:
      enter_slot(entry);
      return {};
    case Entry::Kind::faces:
      enter_faces(entry);
      return {};
    case Entry::Kind::face:
    case Entry::Kind::large_face:
      break;
  }
  return look_at(entry);
}

void FacesOnRay::add_slots(BoxTree::Node n, double from) {
  double begin = ray_->begin(solid_.slot_tree().box(n));
  if (begin < infinity && oriented_) begin = std::max(begin, ray_->begin((*oriented_)[n]));
  push({Entry::Kind::slots, Sign::zero, none, n.level, n.index, from}, begin);
}

void FacesOnRay::enter_slots(const Entry& entry) {
  const BoxTree& tree = solid_.slot_tree();
  const BoxTree::Node n{entry.level, entry.index};
  if (n.level > 0)
    return for_each_child(tree, n, [&](BoxTree::Node m) { add_slots(m, entry.from); });
  for (const std::uint32_t item : tree.items(n)) {
    const std::uint32_t slot = solid_.slots_in_tree()[item];
    push({Entry::Kind::slot, Sign::zero, slot, 0, 0, entry.from},
         ray_->begin(block(slot).bounds()));
  }
}

void FacesOnRay::enter_slot(const Entry& entry) {
  ++steps_;
  double from = entry.from;
  if (++slots_entered_ > few_slots) {
    if (!oriented_ && steps_ > steps_for_a_box * solid_.slots().size()) prepare_slots();
    from = std::max(from, ray_->begin(block(entry.slot).oriented_bounds()));
  }
  if (from < infinity) add_faces(entry.slot, block(entry.slot).tree().root(), from);
}

void FacesOnRay::add_faces(std::uint32_t slot, BoxTree::Node n, double from) {
  double begin = ray_->begin(block(slot).tree().box(n));
  if (begin < infinity && of(slot).oriented)
    begin = std::max(begin, ray_->begin((*of(slot).oriented)[n]));
  push({Entry::Kind::faces, Sign::zero, slot, n.level, n.index, from}, begin);
}

void FacesOnRay::enter_faces(const Entry& entry) {
  take_steps(entry.slot, 1);
  const FaceTree& tree = block(entry.slot).tree();
  const BoxTree::Node n{entry.level, entry.index};
  if (n.level > 0) {
    for_each_child(tree, n, [&](BoxTree::Node m) { add_faces(entry.slot, m, entry.from); });
    return;
  }
  for (const std::uint32_t f : tree.items(n)) add_face(entry.slot, FaceId(f), entry.from);
}

// The plane tells where the face is met, if at all. Very many corners are only looked at if nothing
// is met before that.
void FacesOnRay::add_face(std::uint32_t slot, FaceId local, double from) {
  const Brep& brep = block(slot).brep();
  const Geometry& geometry = block(slot).geometry();
  Entry face{Entry::Kind::face, Sign::zero, slot, 0, local.value(), from, 0};
  std::optional<bool> met;
  if (has_many_corners(brep, local)) {
    face.kind = Entry::Kind::large_face;
  } else {
    met = goes_through(brep, geometry, local, ray_->start());
    if (met == false) return;
  }
  const PlaneValue plane = plane_value(geometry, brep.plane[local]);
  if (plane.exact && plane.n[0] == 0) return;
  const XRayBounds::Stretch stretch = ray_->meeting(plane);
  if (stretch.is_before(ray_->start().x)) return;
  face.to = stretch.to;
  // The start may be on either side of a plane that is as near as that.
  if (stretch.from > ray_->start().x && (met || face.kind == Entry::Kind::large_face))
    face.normal = solid_.slot(slot).turned ? -x_of_normal(plane) : x_of_normal(plane);
  push(face, stretch.from);
}

std::optional<FacesOnRay::Met> FacesOnRay::look_at(const Entry& entry) {
  const FaceId local(entry.index);
  Met result{solid_.face(entry.slot, local), entry.to, entry.normal};
  if (entry.kind == Entry::Kind::large_face) {
    const std::optional<bool> met = is_met(entry);
    if (met == false) return {};
    if (!met) result.normal = Sign::zero;
  }
  if (result.to == infinity)
    result.to = face_box(block(entry.slot).brep(), block(entry.slot).geometry(), local).high[0];
  return result;
}

std::optional<bool> FacesOnRay::is_met(const Entry& entry) {
  const Block& b = block(entry.slot);
  const OfSlot& known = of(entry.slot);
  const Vec3& p = ray_->start();
  if (!known.outlines.empty() && known.outlines[entry.index]) {
    const OutlineAcrossX& outline = *known.outlines[entry.index];
    if (ray_->begin(outline.box()) == infinity) return false;
    return outline.is_met(p);
  }
  const FaceId local(entry.index);
  if (!known.is_ready) take_steps(entry.slot, corner_count(b.brep(), local));
  return goes_through(b.brep(), b.geometry(), local, p);
}

void FacesOnRay::take_steps(std::uint32_t slot, std::size_t steps) {
  OfSlot& known = of(slot);
  if (known.is_ready) return;
  known.steps += steps;
  if (known.steps > steps_for_a_box * block(slot).half_edge_count()) prepare(slot);
}

void FacesOnRay::prepare(std::uint32_t slot) {
  OfSlot& known = of(slot);
  known.is_ready = true;
  const Brep& brep = block(slot).brep();
  const Geometry& geometry = block(slot).geometry();
  known.oriented = block(slot).tree().oriented(brep, geometry);
  for (const FaceId f : brep.plane.ids()) {
    if (!has_many_corners(brep, f)) continue;
    known.outlines.resize(brep.face_count());
    known.outlines[f.value()] = std::make_unique<OutlineAcrossX>(brep, geometry, f);
  }
}

void FacesOnRay::prepare_slots() {
  oriented_.emplace(solid_.slot_tree(), [&](std::uint32_t item, const auto& add) {
    for_each_corner(block(solid_.slots_in_tree()[item]).oriented_bounds(), add);
  });
}

}  // namespace sectile
