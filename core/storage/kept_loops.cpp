#include "storage/kept_loops.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include "sectile/errors.h"
#include "storage/geometry_loader.h"

namespace sectile {
namespace {

// Of a block that is copied with more points for each corner than this, only those that are needed
// are: what is no longer needed does not grow from one solid to the next.
constexpr std::size_t most_points_of_a_corner = 8;

// The face that is alone in a block, with what was beyond its edges.
struct OldFace {
  std::uint32_t slot;
  std::shared_ptr<const Block> block;
  bool turned;
  std::vector<BorderLink> links;
};

// Takes it out of its slot.
OldFace taken_out(SharedSlots& shared, std::uint32_t slot) {
  std::vector<BorderLink>& links = shared.links_of(slot);
  Slot& old = shared.slots[slot];
  OldFace face{slot, std::move(old.block), old.turned, std::move(links)};
  old = {};
  links.clear();
  return face;
}

// The new block of a face whose loops come from several blocks: the first of them may be copied
// with most of its numbers, and its half-edges run as they did.
class JoinedFace {
 public:
  JoinedFace(SharedSlots& shared, std::uint32_t slot) : shared_(shared), slot_(slot) {}

  void add(const OldFace& from, std::span<const LoopId> loops) {
    const bool turned = !sources_.empty() && from.turned != sources_[0].old.turned;
    sources_.push_back({from, loops, turned, {}, {}, {}});
    Source& source = sources_.back();
    const Brep& brep = from.block->brep();
    source.number.assign(from.block->border_count, none);
    source.vertex.resize(brep.vertex_count());
    for (const LoopId l : loops)
      for_each_in_loop(brep, l, [&](HalfEdgeId h) {
        source.number[h.value() / 2] = unnumbered;
        ++edges_;
      });
  }

  /// The last source has the outer loop.
  void run() {
    number_edges();
    fill();
    link();
  }

 private:
  static constexpr std::uint32_t none = 0xFFFFFFFFu, unnumbered = 0xFFFFFFFEu;

  struct Source {
    const OldFace& old;
    std::span<const LoopId> loops;
    bool turned;                             // against the first one
    std::vector<std::uint32_t> number;       // per border edge: in the new block, or none
    std::vector<VertexId> vertex;            // per vertex: in the new block
    std::optional<GeometryLoader> geometry;  // none where numbers of points stay

    const Brep& brep() const { return old.block->brep(); }
    PointId point(PointId p) { return geometry ? geometry->point(p) : p; }
    PlaneId plane(PlaneId s) { return geometry ? geometry->plane(s) : s; }
    HalfEdgeId half_edge(HalfEdgeId h) const { return HalfEdgeId(2 * number[h.value() / 2]); }
    // As it runs in the new block.
    HalfEdgeId next_of(HalfEdgeId h) const {
      return turned ? brep().prev_of(h) : brep().next_of(h);
    }
    VertexId from(HalfEdgeId h) const { return turned ? brep().to(h) : brep().from(h); }
  };

  // Where the slot stays, so do numbers, and with them the links of the blocks around.
  void number_edges() {
    std::vector<bool> taken(edges_);
    if (sources_[0].old.slot == slot_)
      for (std::uint32_t e = 0; e < std::min(edges_, sources_[0].number.size()); ++e)
        if (sources_[0].number[e] == unnumbered) {
          sources_[0].number[e] = e;
          taken[e] = true;
        }
    std::uint32_t next = 0;
    for (Source& source : sources_)
      for (std::uint32_t& number : source.number) {
        if (number != unnumbered) continue;
        while (taken[next]) ++next;
        number = next++;
      }
  }

  void fill() {
    load_geometry();
    Brep& to = block_->brep();
    block_->border_count = static_cast<std::uint32_t>(edges_);
    to.resize_half_edges(2 * edges_);
    to.point.reserve(edges_);
    to.vertex_half_edge.reserve(edges_);
    Source& last = sources_.back();
    to.add_face(face_plane(), last.brep().source[FaceId(0)], LoopId(0));
    add_loop(last, last.loops[0]);
    for (Source& source : sources_)
      for (const LoopId l : source.loops.subspan(&source == &last ? 1 : 0)) add_loop(source, l);
    to.next_loop.back() = LoopId();
    for (const EdgeId e : to.edges()) {
      const HalfEdgeId h = Brep::half_edge(e);
      to.origin[Brep::twin(h)] = to.from(to.next_of(h));
    }
    block_->set_bounds(last.old.block->bounds());
    keep_touching_vertices(last);
  }

  void load_geometry() {
    Source &first = sources_.front(), &last = sources_.back();
    Geometry& to = block_->geometry();
    const Geometry& old = first.old.block->geometry();
    is_copied_ = old.positions.size() <= most_points_of_a_corner * edges_;
    if (is_copied_) copy_with_room(old, last.old.block->geometry(), to);
    for (Source& source : sources_) {
      if (is_copied_ && &source == &first) continue;
      source.geometry.emplace(source.old.block->geometry(), to, source.vertex.size());
      if (is_copied_)
        source.geometry->set_plane(source.brep().plane[FaceId(0)], first.brep().plane[FaceId(0)]);
    }
  }

  // That of the first face is known by the numbers of the others, once it is copied.
  PlaneId face_plane() {
    Source& last = sources_.back();
    const PlaneId plane = last.brep().plane[FaceId(0)];
    return last.turned && !is_copied_ ? last.geometry->plane(plane, true) : last.plane(plane);
  }

  void add_loop(Source& source, LoopId loop) {
    Brep& to = block_->brep();
    const Brep& from = source.brep();
    const LoopId next(to.loop_count() + 1);
    const LoopId made = to.add_loop(FaceId(0), source.half_edge(from.loop_half_edge[loop]), next);
    for_each_in_loop(from, loop, [&](HalfEdgeId h) {
      const HalfEdgeId here = source.half_edge(h), after = source.half_edge(source.next_of(h));
      to.next[here] = after;
      to.prev[after] = here;
      to.loop[here] = made;
      const VertexId old = source.from(h);
      VertexId& vertex = source.vertex[old.value()];
      if (!vertex.valid()) {
        vertex = to.point.add(source.point(from.point_of(old)));
        to.vertex_half_edge.add(here);
      }
      to.origin[here] = vertex;
      if (const PlaneId plane = from.extra_plane(Brep::edge_of(h)); plane.valid()) {
        if (to.edge_plane.empty()) to.edge_plane.resize(edges_);
        to.edge_plane[Brep::edge_of(here)] = source.plane(plane);
      }
    });
  }

  // Kept loops have none.
  void keep_touching_vertices(const Source& made) {
    std::vector<VertexId> touching;
    for (const VertexId v : made.old.block->touching_vertices())
      touching.push_back(made.vertex[v.value()]);
    std::sort(touching.begin(), touching.end());
    block_->set_touching_vertices(std::move(touching));
  }

  void link() {
    std::vector<BorderLink> links(edges_);
    for (const Source& source : sources_)
      for (std::uint32_t e = 0; e < source.number.size(); ++e)
        if (source.number[e] != none) link(source, e, links);
    shared_.slots[slot_] = {block_, nullptr, sources_[0].old.turned};
    shared_.links_of(slot_) = std::move(links);
  }

  void link(const Source& source, std::uint32_t edge, std::vector<BorderLink>& links) {
    const BorderLink& old = source.old.links[edge];
    const std::uint32_t beyond = source.old.slot + static_cast<std::uint32_t>(old.slots);
    if (shared_.slots[beyond].empty())
      throw InternalError("an edge of the result has only one face");
    const std::uint32_t number = source.number[edge];
    const auto slots = static_cast<std::int32_t>(beyond - slot_);
    links[number] = {slots, old.border, old.piece};
    if (source.old.slot != slot_ || number != edge)
      shared_.links_of(beyond)[old.border] = {-slots, number, 0};
  }

  SharedSlots& shared_;
  std::uint32_t slot_;
  std::vector<Source> sources_;
  std::size_t edges_ = 0;
  bool is_copied_ = false;  // the geometry of the first source
  std::shared_ptr<Block> block_ = std::make_shared<Block>();
};

std::vector<LoopId> all_loops(const Block& block) {
  std::vector<LoopId> loops;
  const Brep& brep = block.brep();
  for (LoopId l = brep.outer_loop[FaceId(0)]; l.valid(); l = brep.next_loop[l]) loops.push_back(l);
  return loops;
}

}  // namespace

void add_kept_loops(SharedSlots& shared, std::vector<KeptLoops> kept,
                    std::span<const std::uint32_t> made) {
  // Some may be of one slot, and some for one face.
  std::vector<OldFace> old;
  const auto old_face = [&](std::uint32_t slot) {
    return std::ranges::find(old, slot, &OldFace::slot);
  };
  for (const KeptLoops& k : kept)
    if (old_face(k.slot) == old.end()) old.push_back(taken_out(shared, k.slot));
  for (std::size_t i = 0; i < kept.size(); ++i) {
    if (std::ranges::find(made.first(i), made[i]) != made.first(i).end()) continue;
    const OldFace changed = taken_out(shared, made[i]);
    const std::vector<LoopId> loops = all_loops(*changed.block);
    JoinedFace face(shared, shared.slots[kept[i].slot].empty() ? kept[i].slot : made[i]);
    for (std::size_t j = i; j < kept.size(); ++j)
      if (made[j] == made[i]) face.add(*old_face(kept[j].slot), kept[j].loops);
    face.add(changed, loops);
    face.run();
  }
}

}  // namespace sectile
