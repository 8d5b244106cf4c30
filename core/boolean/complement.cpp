#include "boolean/complement.h"

#include <algorithm>

#include "boolean/boolean.h"
#include "boolean/loading/load.h"
#include "storage/touching_lines.h"
#include "storage/touching_slots.h"

namespace sectile {
namespace {

// Several edges, or an edge and a face: an edge that is met by nothing but itself is paired.
bool is_along(const SegmentRecord& record, const SegmentRecord& other) {
  return record.place[0] == other.place[0] && record.place[1] == other.place[1];
}

// A solid meets itself along all of its edges. What is left are the segments in which several of
// its edges or faces meet.
void leave_touching_segments(Contacts& contacts) {
  SegmentRecords& all = contacts.segments;
  std::sort(all.begin(), all.end(), [](const SegmentRecord& p, const SegmentRecord& q) {
    return std::tie(p.place[0], p.place[1]) < std::tie(q.place[0], q.place[1]);
  });
  SegmentRecords touching;
  for (auto from = all.begin(), to = from; from != all.end(); from = to) {
    to = std::find_if(from, all.end(), [&](const SegmentRecord& r) { return !is_along(r, *from); });
    const Entity first = from->on[Operand::a];
    if (std::any_of(from, to, [&](const SegmentRecord& r) { return r.on[Operand::a] != first; }))
      touching.insert(touching.end(), from, to);
  }
  all = std::move(touching);
}

// Those in which edges run beside each other.
void leave_touching_rows(Contacts& contacts) {
  std::erase_if(contacts.rows, [](const Row& row) {
    std::vector<std::array<std::uint32_t, 2>> stretches;
    for (const Row::Run& run : row.runs)
      if (run.operand == Operand::a) stretches.push_back({run.from, run.to});
    std::ranges::sort(stretches);
    return std::ranges::adjacent_find(stretches, [](const auto& p, const auto& q) {
             return q[0] < p[1];
           }) == stretches.end();
  });
}

// All of the first operand, which is the solid, and nothing of the second, which is the solid too.
FaceLabels all_of_one(const Workspace& w) {
  FaceLabels kept;
  const Patch& patch = w.patch[Operand::a];
  for (const Operand s : both_operands) kept.loaded[s].assign(w.patch[s].brep.face_count(), 0);
  for (const FaceId f : patch.brep.faces())
    if (patch.is_real(f)) kept.loaded[Operand::a][f] = 1;
  RestLabels& rest = kept.rest[Operand::a] = RestLabels(patch);
  if (!rest.empty()) {
    rest.set_regions({std::vector(patch.solid->slots().size(), 0u), 1});
    rest.of_region(0) = 1;
  }
  return kept;
}

// The slots near the contacts' segments, and rows.
std::vector<std::uint32_t> slots_near_segments(const Workspace& w, const SolidData& solid,
                                               const Contacts& contacts) {
  std::vector<Box> boxes;
  const auto add = [&](PlaceId from, PlaceId to) {
    Bounds bounds;
    for (const PlaceId place : {from, to}) bounds.add(w.geometry.position(contacts.point(place)));
    boxes.push_back(bounds.box());
  };
  for (const SegmentRecord& r : contacts.segments) add(r.place[0], r.place[1]);
  for (const Row& row : contacts.rows)
    for (const Row::Run& run : row.runs) add(row.places[run.from], row.places[run.to]);
  return slots_near(solid, boxes);
}

// A line in which the solid touches itself may lead on to other slots. Where very many edges run
// along one line, faces that leave it in different directions are in no pair, but the edges are
// in one row.
std::shared_ptr<const SolidData> paired_for_complement(const SolidData& solid,
                                                       std::vector<std::uint32_t> slots) {
  const BooleanOptions options;
  const Operation united[] = {Operation::unite};
  const Wanted wanted{united, true};
  for (;;) {
    Workspace w(options);
    FacePairs pairs;
    load_slots(w, solid, slots, pairs, wanted);
    Contacts contacts = reduce(w, pairs);
    leave_touching_segments(contacts);
    leave_touching_rows(contacts);
    if (contacts.segments.empty() && contacts.rows.empty()) return nullptr;
    const std::vector<std::uint32_t> near = slots_near_segments(w, solid, contacts);
    const std::size_t known = slots.size();
    slots.insert(slots.end(), near.begin(), near.end());
    std::sort(slots.begin(), slots.end());
    slots.erase(std::unique(slots.begin(), slots.end()), slots.end());
    if (slots.size() > known) continue;
    const CutBoundaries boundaries = cut_at(w, std::move(contacts), wanted);
    return assemble(w, boundaries, all_of_one(w), Operation::unite, 0).data();
  }
}

}  // namespace

const SolidData& reversible(const SolidData& solid) {
  if (solid.touching_slots().empty()) return solid;
  const SolidData* paired = solid.complement([&]() -> std::shared_ptr<const SolidData> {
    std::vector<std::uint32_t> slots = slots_touching_in_lines(solid);
    return slots.empty() ? nullptr : paired_for_complement(solid, std::move(slots));
  });
  return paired ? *paired : solid;
}

}  // namespace sectile
