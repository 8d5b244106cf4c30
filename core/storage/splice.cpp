#include "storage/splice.h"

#include <algorithm>

#include "parallel/parallel.h"

namespace sectile {
namespace {

// New links for the slots for which there are some.
void relink(std::vector<Slot>& slots, std::vector<std::vector<BorderLink>> fresh) {
  parallel::loop(tbb::blocked_range<std::size_t>(0, slots.size(), 64), [&](const auto& range) {
    for (std::size_t s = range.begin(); s < range.end(); ++s)
      if (!fresh[s].empty())
        slots[s].links = std::make_shared<BorderLinks>(*slots[s].block, std::move(fresh[s]));
  });
}

// The border edges of shared blocks lead to the new blocks from now on.
void link_to_part(std::vector<Slot>& slots, const std::vector<BorderEdge>& outside,
                  const std::vector<BorderEdge>& made) {
  std::vector<std::vector<BorderLink>> fresh(slots.size());
  for (std::size_t e = 0; e < outside.size(); ++e) {
    const std::uint32_t slot = outside[e].slot;
    if (fresh[slot].empty()) fresh[slot] = slots[slot].links->all();
    fresh[slot][outside[e].border] = {static_cast<std::int32_t>(made[e].slot - slot),
                                      made[e].border, made[e].piece};
  }
  relink(slots, std::move(fresh));
}

void add_part(std::vector<Slot>& slots, const NewPart& part) {
  std::vector<std::uint32_t> free;
  for (std::uint32_t s = 0; s < slots.size(); ++s)
    if (slots[s].empty()) free.push_back(s);
  const Places places{free, static_cast<std::uint32_t>(slots.size())};
  CutPart made = cut_into_blocks({part.brep, part.geometry, part.outside, places});
  link_to_part(slots, part.outside, made.outside);
  for (std::size_t g = 0; g < made.slots.size(); ++g) {
    const std::uint32_t place = places(g);
    if (place >= slots.size()) slots.resize(place + std::size_t(1));
    slots[place] = std::move(made.slots[g]);
  }
}

// Closes the gaps if most slots are empty.
void compact(std::vector<Slot>& slots) {
  const auto empty = static_cast<std::size_t>(
      std::count_if(slots.begin(), slots.end(), [](const Slot& s) { return s.empty(); }));
  if (2 * empty <= slots.size()) return;
  std::vector<std::uint32_t> gaps_before(slots.size());
  std::uint32_t gaps = 0;
  for (std::uint32_t s = 0; s < slots.size(); ++s) {
    gaps_before[s] = gaps;
    if (slots[s].empty()) ++gaps;
  }
  std::vector<Slot> dense;
  std::vector<std::vector<BorderLink>> fresh;
  dense.reserve(slots.size() - gaps);
  fresh.reserve(slots.size() - gaps);
  for (std::uint32_t s = 0; s < slots.size(); ++s) {
    if (slots[s].empty()) continue;
    const Slot& slot = dense.emplace_back(std::move(slots[s]));
    std::vector<BorderLink>& links = fresh.emplace_back();
    if (!slot.links) continue;
    links = slot.links->all();
    for (BorderLink& link : links) {
      const std::uint32_t other = s + static_cast<std::uint32_t>(link.slots);
      link.slots -= static_cast<std::int32_t>(gaps_before[other] - gaps_before[s]);
    }
  }
  relink(dense, std::move(fresh));
  slots = std::move(dense);
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

std::shared_ptr<SolidData> splice(std::vector<Slot> shared, NewPart part, bool touches_itself) {
  const bool none_shared =
      std::all_of(shared.begin(), shared.end(), [](const Slot& s) { return s.empty(); });
  if (none_shared) {
    auto made = std::make_shared<SolidData>();
    made->brep() = std::move(part.brep);
    made->geometry() = std::move(part.geometry);
    made->cut();
    return made;
  }
  touches_itself = touches_itself || vertices_coincide(part.brep, part.geometry);
  if (part.brep.face_count() > 0) add_part(shared, part);
  compact(shared);
  return std::make_shared<SolidData>(std::move(shared), touches_itself);
}

}  // namespace sectile
