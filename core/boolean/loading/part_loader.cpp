#include "boolean/loading/part_loader.h"

#include <algorithm>
#include <utility>

#include "numbers/threshold.h"
#include "parallel/parallel.h"
#include "topology/open_ends.h"

namespace sectile {

PartLoader::PartLoader(const SolidData& solid, const std::vector<FaceId>& faces, Geometry& geometry,
                       std::size_t more_edges, std::vector<FarLoops> far_loops)
    : solid_(solid), faces_(faces), to_(geometry), near_of_slot_(solid.slots().size(), none) {
  patch_.far_loops = std::move(far_loops);
  divide_into_runs();
  for_each_run([&](Run& run) { count(run); });
  make_room(more_edges);
  const auto load_structure = [&] {
    for_each_run([&](const Run& run) { number_edges(run); });
    for_each_run([&](const Run& run) { make_faces(run); });
  };
  constexpr std::size_t few = threshold(512, 2);
  if (faces.size() < few) {
    load_structure();
    load_planes_of_faces();
  } else {
    parallel::invoke(load_structure, [&] { load_planes_of_faces(); });
  }
  load_planes_of_edges();
  close_ends();
  make_vertices();
}

// The faces ascend, so those of a slot come one after the other.
void PartLoader::divide_into_runs() {
  constexpr std::uint32_t most_faces = threshold(128, 2);
  auto far = patch_.far_loops.begin();
  const auto count = static_cast<std::uint32_t>(faces_.size());
  for (std::uint32_t from = 0, to; from < count; from = to) {
    const std::uint32_t s = solid_.slot_of(faces_[from]);
    const Slot& slot = solid_.slot(s);
    near_of_slot_[s] = static_cast<std::uint32_t>(near_.size());
    NearSlot near{s, &slot, nullptr, {}, {}, {}};
    near.place.assign(slot.faces, none);
    near.made.resize(slot.half_edges);
    for (to = from; to < count && solid_.slot_of(faces_[to]) == s; ++to)
      near.place[solid_.local(s, faces_[to]).value()] = to;
    if (far != patch_.far_loops.end() && far->slot == s) {
      near.far = &*far++;
      near.far->face = FaceId(from);
      near.far->lie_in(near.far->face);
    }
    for (std::uint32_t first = from; first < to; first += most_faces)
      runs_.push_back({near_of_slot_[s], first, std::min(to, first + most_faces), {}});
    near_.push_back(std::move(near));
  }
}

template <class Body>
void PartLoader::for_each_run(const Body& body) {
  parallel::loop(0, runs_.size(), [&](std::size_t r) { body(runs_[r]); });
}

// Calls visit(face, loop of the block) for the loops that are loaded.
template <class Visit>
void PartLoader::for_each_loop(const Run& run, const Visit& visit) const {
  const NearSlot& near = near_[run.near];
  const Brep& brep = near.of_solid->block->brep();
  for (std::uint32_t f = run.first; f < run.last; ++f)
    for (LoopId l = brep.outer_loop[solid_.local(near.slot, faces_[f])]; l.valid();
         l = brep.next_loop[l])
      if (!near.far || !near.far->has(l)) visit(f, l);
}

// That of a half-edge; none if it is not loaded.
std::uint32_t PartLoader::loaded_face(const SolidData::Neighbour& n) const {
  if (near_of_slot_[n.slot] == none) return none;
  const NearSlot& near = near_[near_of_slot_[n.slot]];
  const Brep& brep = near.of_solid->block->brep();
  if (near.far && near.far->has(brep.loop_of(n.local))) return none;
  return near.place[brep.face_of(n.local).value()];
}

void PartLoader::count(Run& run) {
  const NearSlot& near = near_[run.near];
  run.edges.reserve(2 * (run.last - run.first));
  for_each_loop(run, [&](std::uint32_t face, LoopId l) {
    ++run.loops;
    for_each_in_loop(*near.of_solid, l, [&](HalfEdgeId h) {
      const SolidData::Neighbour mate = solid_.across(near.slot, h);
      const std::uint32_t other = loaded_face(mate);
      if (other < face || (other == face && mate.local < h)) return;
      run.edges.push_back({h, mate, other == none});
    });
  });
}

void PartLoader::make_room(std::size_t more_edges) {
  std::uint32_t edges = 0, loops = 0;
  for (Run& run : runs_) {
    run.first_edge = std::exchange(edges, edges + static_cast<std::uint32_t>(run.edges.size()));
    run.first_loop = std::exchange(loops, loops + run.loops);
  }
  Brep& to = patch_.brep;
  patch_.reserve(edges + more_edges);
  to.resize_half_edges(2 * std::size_t(edges));
  to.resize_faces(faces_.size());
  to.resize_loops(loops);
  to.kind.assign(faces_.size(), FaceKind::real);
  patch_.face_in_solid = faces_;
  patch_.edge_in_solid.resize(edges);
  patch_.half_edge_in_solid.resize(to.half_edge_count());
  patch_.side_plane.resize(to.half_edge_count());
  source_.resize(to.half_edge_count());
}

// An edge between two blocks goes by the smaller number of its half-edges.
bool PartLoader::begins_with(const Source& first, const Source& second) {
  return first.slot != second.slot ? first.slot < second.slot : first.h < second.h;
}

void PartLoader::number_edges(const Run& run) {
  const std::uint32_t slot = near_[run.near].slot;
  EdgeId next(run.first_edge);
  for (const auto& [h, mate, is_open] : run.edges) {
    Source first{slot, h}, second{mate.slot, mate.local};
    const unsigned side = begins_with(first, second) ? 0 : 1;
    if (side == 1) std::swap(first, second);
    const HalfEdgeId here = Brep::half_edge(next, side), there = Brep::twin(here);
    near_[run.near].made[h.value()] = here;
    if (is_open)
      patch_.half_edge_in_solid[there] = solid_.half_edge(mate.slot, mate.local);
    else
      near_[near_of_slot_[mate.slot]].made[mate.local.value()] = there;
    patch_.edge_in_solid[next.value()] = Brep::edge_of(solid_.half_edge(first.slot, first.h));
    source_[2 * next.value()] = first;
    source_[2 * next.value() + 1] = second;
    next = EdgeId(next.value() + 1);
  }
}

void PartLoader::make_faces(const Run& run) {
  const NearSlot& near = near_[run.near];
  Brep& to = patch_.brep;
  LoopId here(run.first_loop), last;
  std::uint32_t face = none;
  for_each_loop(run, [&](std::uint32_t f, LoopId l) {
    if (f == face)
      to.next_loop[last] = here;
    else
      to.outer_loop[FaceId(f)] = here;
    face = f;
    last = here;
    to.loop_face[here] = FaceId(f);
    make_loop(near, l, here);
    here = LoopId(here.value() + 1);
  });
  const Brep& brep = near.of_solid->block->brep();
  for (std::uint32_t f = run.first; f < run.last; ++f)
    to.source[FaceId(f)] = brep.source[solid_.local(near.slot, faces_[f])];
}

void PartLoader::make_loop(const NearSlot& near, LoopId there, LoopId here) {
  Brep& to = patch_.brep;
  HalfEdgeId first, before;
  for_each_in_loop(*near.of_solid, there, [&](HalfEdgeId h) {
    const HalfEdgeId made = near.made[h.value()];
    to.loop[made] = here;
    if (before.valid()) {
      to.next[before] = made;
      to.prev[made] = before;
    } else {
      first = made;
    }
    before = made;
  });
  to.next[before] = first;
  to.prev[first] = before;
  to.loop_half_edge[here] = first;
}

GeometryLoader& PartLoader::geometry(std::uint32_t slot, std::size_t expected) {
  const auto made = [&](std::unique_ptr<GeometryLoader>& loader) -> GeometryLoader& {
    if (!loader)
      loader = std::make_unique<GeometryLoader>(solid_.slot(slot).block->geometry(), to_, expected);
    return *loader;
  };
  if (const std::uint32_t near = near_of_slot_[slot]; near != none)
    return made(near_[near].geometry);
  if (beyond_.empty()) beyond_.resize(solid_.slots().size());
  return made(beyond_[slot]);
}

void PartLoader::load_planes_of_faces() {
  for (const Run& run : runs_) {
    const NearSlot& near = near_[run.near];
    const Slot& slot = *near.of_solid;
    const std::size_t points = slot.half_edges / 2 - (near.far ? near.far->corners : 0);
    GeometryLoader& loader = geometry(near.slot, points);
    const Brep& brep = slot.block->brep();
    for (std::uint32_t f = run.first; f < run.last; ++f)
      patch_.brep.plane[FaceId(f)] =
          loader.plane(brep.plane[solid_.local(near.slot, faces_[f])], slot.turned);
  }
}

// Those that pin down edges, and those beyond open ends: they still bound the loaded faces' edges.
void PartLoader::load_planes_of_edges() {
  constexpr std::size_t few_points = threshold(64, 4);
  Brep& to = patch_.brep;
  const auto extra_plane = [&](const Source& from) {
    return solid_.slot(from.slot).block->brep().extra_plane(Brep::edge_of(from.h));
  };
  for (const EdgeId e : to.edges()) {
    const Source& from = source_[2 * e.value()];
    const PlaneId plane = extra_plane(from);
    if (!plane.valid()) continue;
    if (to.edge_plane.empty()) to.edge_plane.resize(to.edge_count());
    to.edge_plane[e] = geometry(from.slot, few_points).plane(plane);
  }
  for (const HalfEdgeId h : to.half_edges()) {
    if (!patch_.half_edge_in_solid[h].valid()) continue;
    const Source& from = source_[h.value()];
    const Slot& slot = solid_.slot(from.slot);
    patch_.side_plane[Brep::twin(h)] =
        geometry(from.slot, few_points).plane(slot.block->brep().plane_of(from.h), slot.turned);
  }
}

void PartLoader::close_ends() {
  std::vector<HalfEdgeId> open;
  for (const HalfEdgeId h : patch_.half_edge_in_solid.ids())
    if (patch_.half_edge_in_solid[h].valid()) open.push_back(h);
  close_open_ends(patch_.brep, open);
}

void PartLoader::make_vertices() {
  Brep& to = patch_.brep;
  for (const HalfEdgeId first : to.half_edges()) {
    if (to.origin[first].valid()) continue;
    const VertexId v(to.vertex_count());
    const Source& from = source_[first.value()];
    const Slot& slot = solid_.slot(from.slot);
    const VertexId there = slot.from(from.h);
    patch_.vertex_in_solid.push_back(VertexId(solid_.base(from.slot) + there.value()));
    to.point.add(geometry(from.slot, 0).point(slot.block->brep().point_of(there)));
    to.vertex_half_edge.add(first);
    HalfEdgeId h = first;
    do {
      to.origin[h] = v;
      if (to.kind[to.face_of(h)] == FaceKind::real) to.vertex_half_edge.back() = h;
      h = to.around(h);
    } while (h != first);
  }
}

}  // namespace sectile
