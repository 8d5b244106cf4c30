#include "boolean/gluing/gluing.h"

#include <utility>

#include "boolean/collect.h"
#include "boolean/gluing/glue_sources.h"
#include "boolean/gluing/kept_blocks.h"
#include "numbers/threshold.h"
#include "sectile/errors.h"
#include "topology/open_ends.h"
#include "topology/vertex_cycles.h"

namespace sectile {
namespace {

using Mate = GlueSources::Mate;

struct GluedEdge {
  SourceHalfEdge first, second;
  PlaneId plane;
  bool seam;
};
struct OutsideEdge {
  SourceHalfEdge inner;
  BorderEdge border;
  PlaneId plane;
};

// Some of the faces, with the edges whose first half-edge is theirs.
struct Part {
  std::vector<GluedEdge> edges;
  std::vector<OutsideEdge> outside;
  std::size_t loops = 0;
  bool has_planes = false;
  // Numbers in the result, once all parts are known.
  std::size_t first_edge = 0, first_outside = 0, first_loop = 0;
  std::vector<std::pair<HalfEdgeId, Mate>> chain;  // scratch
};

// The edges are numbered first, on all cores: edges to shared blocks come before all others, and
// those of earlier faces before those of later ones. Then all faces are made beside each other.
class Gluer {
 public:
  Gluer(const Workspace& w, GlueSources& sources)
      : w_(w), sources_(sources), faces_(sources.faces()), brep_(glued_.brep) {}

  Glued run() {
    parts_ = collect<Part>(w_, faces_.size(), faces_of_a_part,
                           [&](std::size_t i, Part& part) { find_edges(i, part); });
    make_room();
    for_each(w_, parts_.size(), 1, [&](std::size_t p) { number_edges(parts_[p]); });
    note_seams();
    for_each(w_, parts_.size(), 1, [&](std::size_t p) { make_faces(p); });
    close_ends();
    check_faces();
    make_vertices(brep_, start_);
    return std::move(glued_);
  }

 private:
  static constexpr std::size_t faces_of_a_part = threshold(256, 4);

  void find_edges(std::size_t place, Part& part) const {
    const std::uint32_t source = faces_[place].source;
    const GlueSource& from = sources_[source];
    for (LoopId l = from.brep->outer_loop[faces_[place].face]; l.valid();
         l = from.brep->next_loop[l]) {
      part.chain.clear();
      for_each_in_loop(*from.brep, l, [&](HalfEdgeId h) {
        if (!from.is_passed_over(h)) part.chain.push_back({h, sources_.mate({source, h})});
      });
      if (part.chain.empty()) continue;
      ++part.loops;
      for (const auto& [h, mate] : part.chain)
        if (mate.kind == Mate::Kind::shared) add_outside({source, h}, mate, part);
      for (std::size_t i = 0; i < part.chain.size(); ++i) {
        const auto& [h, mate] = part.chain[from.turned ? part.chain.size() - 1 - i : i];
        if (mate.kind == Mate::Kind::glued && is_first({source, h}, mate.h, place))
          add_edge({source, h}, mate, part);
      }
    }
  }

  // Of the two half-edges of an edge, the one whose face stands before that of the other.
  bool is_first(const SourceHalfEdge& e, const SourceHalfEdge& mate, std::size_t place) const {
    const std::size_t other = sources_.place(mate);
    return place < other || (place == other && e.h < mate.h);
  }

  void add_outside(const SourceHalfEdge& e, const Mate& mate, Part& part) const {
    const PlaneId plane = own_plane(e);
    part.outside.push_back({e, mate.border, plane});
    part.has_planes |= plane.valid();
  }
  void add_edge(const SourceHalfEdge& e, const Mate& mate, Part& part) const {
    const PlaneId plane = mate.seam ? seam_plane(e, mate) : own_plane(e);
    part.edges.push_back({e, mate.h, plane, mate.seam});
    part.has_planes |= plane.valid();
  }

  PlaneId own_plane(const SourceHalfEdge& e) const {
    const GlueSource& from = sources_[e.source];
    return from.plane(from.brep->extra_plane(Brep::edge_of(e.h)));
  }
  // Seams between coplanar faces need a plane that pins them down.
  PlaneId seam_plane(const SourceHalfEdge& e, const Mate& mate) const {
    const GlueSource& from = sources_[e.source];
    const PlaneId p = from.brep->plane_of(e.h),
                  q = sources_[mate.h.source].brep->plane_of(mate.h.h);
    return w_.tests().parallel(p, q) ? w_.patch[from.operand].side(e.h) : PlaneId();
  }

  void make_room() {
    std::size_t edges = 0, outside = 0, loops = 0;
    bool has_planes = false;
    for (Part& part : parts_) {
      part.first_outside = std::exchange(outside, outside + part.outside.size());
      part.first_loop = std::exchange(loops, loops + part.loops);
      has_planes |= part.has_planes;
    }
    edges = outside;
    for (Part& part : parts_) part.first_edge = std::exchange(edges, edges + part.edges.size());
    brep_.resize_half_edges(2 * edges);
    brep_.resize_faces(faces_.size());
    brep_.resize_loops(loops);
    if (has_planes) brep_.edge_plane.resize(edges);
    glued_.outside.resize(outside);
    start_.resize(2 * edges);
  }

  void number_edges(const Part& part) {
    EdgeId next(part.first_outside);
    for (const OutsideEdge& edge : part.outside) {
      sources_[edge.inner.source].made[edge.inner.h] = Brep::half_edge(next);
      glued_.outside[next.value()] = edge.border;
      set_plane(next, edge.plane);
      next = EdgeId(next.value() + 1);
    }
    next = EdgeId(part.first_edge);
    for (const GluedEdge& edge : part.edges) {
      sources_[edge.first.source].made[edge.first.h] = Brep::half_edge(next, 0);
      sources_[edge.second.source].made[edge.second.h] = Brep::half_edge(next, 1);
      set_plane(next, edge.plane);
      next = EdgeId(next.value() + 1);
    }
  }
  void set_plane(EdgeId e, PlaneId plane) {
    if (plane.valid()) brep_.edge_plane[e] = plane;
  }

  void note_seams() {
    for (const Part& part : parts_)
      for (std::size_t i = 0; i < part.edges.size(); ++i)
        if (part.edges[i].seam) glued_.seams.push_back(EdgeId(part.first_edge + i));
  }

  void make_faces(std::size_t p) {
    LoopId loop(parts_[p].first_loop);
    std::vector<HalfEdgeId> chain;
    const std::size_t end = std::min(faces_.size(), (p + 1) * faces_of_a_part);
    for (std::size_t place = p * faces_of_a_part; place < end; ++place) {
      const auto [source, face] = faces_[place];
      const GlueSource& from = sources_[source];
      const FaceId here(place);
      brep_.plane[here] = from.face_plane(face);
      brep_.source[here] = from.brep->source[face];
      LoopId* link = &brep_.outer_loop[here];
      for (LoopId l = from.brep->outer_loop[face]; l.valid(); l = from.brep->next_loop[l]) {
        chain.clear();
        for_each_in_loop(*from.brep, l, [&](HalfEdgeId h) {
          if (!from.is_passed_over(h)) chain.push_back(h);
        });
        if (chain.empty()) continue;
        *link = loop;
        link = &brep_.next_loop[loop];
        brep_.loop_face[loop] = here;
        make_loop(from, chain, loop);
        loop = LoopId(loop.value() + 1);
      }
    }
  }

  void make_loop(const GlueSource& from, std::span<const HalfEdgeId> chain, LoopId loop) {
    HalfEdgeId before = made(from, chain.back());
    for (const HalfEdgeId h : chain) {
      const HalfEdgeId id = made(from, h);
      brep_.loop[id] = loop;
      (from.turned ? brep_.prev : brep_.next)[before] = id;
      (from.turned ? brep_.next : brep_.prev)[id] = before;
      start_[id.value()] =
          from.point(from.brep->point_of(from.turned ? from.brep->to(h) : from.brep->from(h)));
      before = id;
    }
    brep_.loop_half_edge[loop] = made(from, from.turned ? chain.back() : chain.front());
  }

  static HalfEdgeId made(const GlueSource& from, HalfEdgeId h) {
    const HalfEdgeId id = from.made[h];
    if (!id.valid()) throw InternalError("an edge of the result has only one face");
    return id;
  }

  // As in a patch: what is shared is stood for by faces of kind `rest`.
  void close_ends() {
    if (glued_.outside.empty()) return;
    brep_.kind.assign(brep_.face_count(), FaceKind::real);
    std::vector<HalfEdgeId> open;
    for (const EdgeId e : IdRange<EdgeId>(EdgeId(0), EdgeId(glued_.outside.size()))) {
      open.push_back(Brep::half_edge(e, 1));
      start_[open.back().value()] = start_[brep_.next_of(Brep::half_edge(e)).value()];
    }
    close_open_ends(brep_, open);
  }

  void check_faces() const {
    for (const LoopId l : brep_.loop)
      if (!l.valid()) throw InternalError("an edge of the result has only one face");
  }

  const Workspace& w_;
  GlueSources& sources_;
  std::span<const GlueSources::Kept> faces_;
  Glued glued_;
  Brep& brep_;
  std::vector<Part> parts_;
  std::vector<PointId> start_;  // per half-edge of the result
};

}  // namespace

Glued glue(Workspace& w, Operation operation, const Neighborhoods& neighborhoods,
           const Wedges& wedges, const JoinedCuts& joined, const FaceLabels& kept) {
  KeptBlocks blocks(w, operation, kept);
  GlueSources sources(w, operation, kept, blocks);
  sources.pair_sides(neighborhoods, wedges, joined);
  Glued glued = Gluer(w, sources).run();
  glued.shared = std::move(blocks.shared);
  for (const Operand s : both_operands)
    for (KeptLoops& loops : blocks.kept_loops(s)) {
      loops.face = FaceId(sources[static_cast<std::size_t>(s)].place[loops.face]);
      glued.kept_loops.push_back(std::move(loops));
    }
  return glued;
}

}  // namespace sectile
