#include "storage/join_blocks.h"

#include "geometry/kernel.h"
#include "storage/geometry_loader.h"
#include "storage/shared_points.h"
#include "topology/vertex_cycles.h"

namespace sectile {
namespace {

class Joiner {
 public:
  Joiner(const SolidData& solid, Brep& brep, Geometry& geometry)
      : solid_(solid), brep_(brep), geometry_(geometry), joined_(solid.slots().size()) {}

  void run() {
    for (std::uint32_t s = 0; s < joined_.size(); ++s) number_edges(s);
    brep_.resize_half_edges(edges_ * 2);
    start_.resize(edges_ * 2);
    for (std::uint32_t s = 0; s < joined_.size(); ++s)
      if (!solid_.slot(s).empty()) add_block(s);
    if (!brep_.edge_plane.empty()) brep_.edge_plane.resize(edges_);
    make_vertices(brep_, start_);
    if (solid_.touches_itself()) share_points(brep_, Kernel(geometry_));  // blocks have their own
  }

 private:
  std::vector<HalfEdgeId>& joined(std::uint32_t s) {
    std::vector<HalfEdgeId>& ids = joined_[s];
    if (ids.empty()) ids.resize(solid_.slot(s).half_edges);
    return ids;
  }

  // An edge between blocks gets its number from the first of them.
  void number_edges(std::uint32_t s) {
    if (solid_.slot(s).empty()) return;
    for (std::uint32_t h = 0; h < joined(s).size(); h += 2) {
      if (joined_[s][h].valid()) continue;
      const auto other = solid_.across(s, HalfEdgeId(h));
      joined_[s][h] = HalfEdgeId(2 * edges_);
      joined(other.slot)[other.local.value()] = HalfEdgeId(2 * edges_ + 1);
      ++edges_;
    }
  }

  void add_block(std::uint32_t s) {
    const Slot& slot = solid_.slot(s);
    const Brep& from = slot.block->brep();
    const GeometryOffset offset = append_geometry(slot.block->geometry(), geometry_, slot.turned);
    for (const FaceId f : from.faces()) {
      const FaceId mine =
          brep_.add_face(offset.plane(from.plane[f]), from.source[f], LoopId(brep_.loop_count()));
      for (LoopId l = from.outer_loop[f]; l.valid(); l = from.next_loop[l])
        add_loop(s, l, mine, offset);
    }
    add_edge_planes(s, offset);
  }

  void add_loop(std::uint32_t s, LoopId l, FaceId face, const GeometryOffset& offset) {
    const Slot& slot = solid_.slot(s);
    const Brep& from = slot.block->brep();
    const std::vector<HalfEdgeId>& ids = joined_[s];
    const LoopId next(brep_.loop_count() + 1);
    const LoopId mine = brep_.add_loop(face, ids[from.loop_half_edge[l].value()],
                                       from.next_loop[l].valid() ? next : LoopId());
    for_each_in_loop(slot, l, [&](HalfEdgeId h) {
      const HalfEdgeId here = ids[h.value()], after = ids[slot.next_of(h).value()];
      brep_.next[here] = after;
      brep_.prev[after] = here;
      brep_.loop[here] = mine;
      start_[here.value()] = offset.point(slot.start_of(h));
    });
  }

  void add_edge_planes(std::uint32_t s, const GeometryOffset& offset) {
    const Brep& from = solid_.slot(s).block->brep();
    for (const EdgeId e : from.edge_plane.ids()) {
      if (!from.edge_plane[e].valid()) continue;
      if (brep_.edge_plane.empty()) brep_.edge_plane.resize(edges_);
      brep_.edge_plane[Brep::edge_of(joined_[s][Brep::half_edge(e).value()])] =
          offset.plane(from.edge_plane[e]);
    }
  }

  const SolidData& solid_;
  Brep& brep_;
  Geometry& geometry_;
  std::vector<std::vector<HalfEdgeId>> joined_;  // per slot and half-edge of its block
  std::vector<PointId> start_;                   // per half-edge
  std::size_t edges_ = 0;
};

}  // namespace

void join_blocks(const SolidData& solid, Brep& brep, Geometry& geometry) {
  Joiner(solid, brep, geometry).run();
}

}  // namespace sectile
