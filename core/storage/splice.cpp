#include "storage/splice.h"

#include <algorithm>

#include "numbers/threshold.h"
#include "storage/geometry_loader.h"

namespace sectile {
namespace {

// The border edges of shared blocks lead to the new blocks from now on.
void link_to_part(SharedSlots& shared, const std::vector<BorderEdge>& outside,
                  const std::vector<BorderEdge>& made) {
  for (std::size_t e = 0; e < outside.size(); ++e)
    shared.links_of(outside[e].slot)[outside[e].border] = {
        static_cast<std::int32_t>(made[e].slot - outside[e].slot), made[e].border, made[e].piece};
}

void add_part(SharedSlots& shared, const NewPart& part) {
  std::vector<Slot>& slots = shared.slots;
  std::vector<std::uint32_t> free;
  for (std::uint32_t s = 0; s < slots.size(); ++s)
    if (slots[s].empty()) free.push_back(s);
  const Places places{free, static_cast<std::uint32_t>(slots.size())};
  std::vector<FaceId> alone;
  for (const KeptLoops& kept : part.kept_loops) alone.push_back(kept.face);
  CutPart made = cut_into_blocks({part.brep, part.geometry, part.outside, places, {}, alone});
  link_to_part(shared, part.outside, made.outside);
  for (std::size_t g = 0; g < made.slots.size(); ++g) {
    const std::uint32_t place = places(g);
    if (place >= slots.size()) slots.resize(place + std::size_t(1));
    slots[place] = std::move(made.slots[g]);
  }
  add_kept_loops(shared, part.kept_loops, made.alone);
}

// Closes the gaps if there are many: an empty slot costs little, but all blocks are linked anew.
void compact(SharedSlots& shared) {
  const std::vector<Slot>& slots = shared.slots;
  const auto empty = static_cast<std::size_t>(
      std::count_if(slots.begin(), slots.end(), [](const Slot& s) { return s.empty(); }));
  constexpr std::size_t most_slots_a_block = threshold(8, 2);
  if (slots.size() <= most_slots_a_block * (slots.size() - empty)) return;
  std::vector<std::uint32_t> gaps_before(slots.size());
  std::uint32_t gaps = 0;
  for (std::uint32_t s = 0; s < slots.size(); ++s) {
    gaps_before[s] = gaps;
    if (slots[s].empty()) ++gaps;
  }
  SharedSlots dense;
  for (const Slot& slot : slots)
    if (!slot.empty()) dense.slots.push_back(slot);
  for (std::uint32_t s = 0; s < slots.size(); ++s) {
    if (!slots[s].links) continue;
    for (BorderLink& link : dense.links_of(s - gaps_before[s])) {
      const std::uint32_t other = s + static_cast<std::uint32_t>(link.slots);
      link.slots -= static_cast<std::int32_t>(gaps_before[other] - gaps_before[s]);
    }
  }
  dense.relink();
  shared = std::move(dense);
}

}  // namespace

bool vertices_coincide(const Brep& brep, const Geometry& geometry) {
  std::vector<bool> seen(geometry.positions.size());
  for (const VertexId v : brep.vertices()) {
    bool divided = false;
    if (!brep.kind.empty())
      for_each_around(brep, brep.vertex_half_edge[v], [&](HalfEdgeId h) {
        divided |= brep.kind_of(brep.face_of(h)) == FaceKind::rest;
      });
    if (divided) continue;
    const std::uint32_t p = brep.point[v].value();
    if (seen[p]) return true;
    seen[p] = true;
  }
  return false;
}

namespace {

// In one block, with the points and planes that it needs.
std::shared_ptr<SolidData> in_one_block(NewPart part) {
  auto made = std::make_shared<SolidData>();
  Brep& brep = made->brep() = std::move(part.brep);
  GeometryLoader geometry(part.geometry, made->geometry(), brep.vertex_count());
  for (PlaneId& s : brep.plane) s = geometry.plane(s);
  for (PlaneId& s : brep.edge_plane) s = geometry.plane(s);
  for (PointId& p : brep.point) p = geometry.point(p);
  made->cut();
  return made;
}

}  // namespace

std::shared_ptr<SolidData> splice(SharedSlots shared, NewPart part, bool touches_itself) {
  const bool none_shared = std::all_of(shared.slots.begin(), shared.slots.end(),
                                       [](const Slot& s) { return s.empty(); });
  if (none_shared) {
    if (part.brep.face_count() <= most_faces_of_a_block) return in_one_block(std::move(part));
    shared.slots.clear();
  }
  touches_itself = touches_itself || vertices_coincide(part.brep, part.geometry);
  if (part.brep.face_count() > 0) add_part(shared, part);
  shared.relink();
  compact(shared);
  return std::make_shared<SolidData>(std::move(shared.slots), touches_itself);
}

}  // namespace sectile
