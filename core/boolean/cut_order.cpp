// The order of the cuts around each site.
#include <algorithm>
#include <span>

#include "boolean/direction.h"
#include "boolean/null_edges.h"
#include "boolean/places.h"
#include "sectile/errors.h"

namespace sectile {
namespace {

// The half-edge of a cut edge carrier that starts at place[0] or place[1], whichever its even
// half-edge reaches first.
class CarrierEdge {
 public:
  CarrierEdge(const Workspace& w, const Carrier& c) {
    const unsigned start = c.along ? 0 : 1;
    h = c.end[start].is_vertex() ? Brep::half_edge(c.entity.edge())
                                 : w.sites[w.cut_ends[c.cut_end[start]].site].forward;
  }
  HalfEdgeId h;
};

// Where a cut leaves a site: after the `turn`-th half-edge around its vertex, in the sector there.
struct Leaving {
  CutEnd end;
  std::uint32_t turn = 0;
  int rank = 1;  // 0: beside the corner's first edge, 1: within the sector, 2: beside the last
  Direction direction;  // within the face, for rank 1
};

class CutOrder {
 public:
  explicit CutOrder(Workspace& w) : w_(w), kernel_(w.tests()), along_(w.carriers.size()) {}

  void run() {
    for (const Segment& segment : w_.segments)
      for (std::uint32_t i = 0; i < segment.carrier_count; ++i)
        along_[segment.first_carrier + i] =
            direction_along(segment, w_.carriers[segment.first_carrier + i]);
    leaving_.reserve(w_.cut_ends.size());
    for_each_place(w_, [&](std::span<const std::uint32_t> sites) { leave_place(sites); });
    group_by_site();
    for (const Site& site : w_.sites) {
      w_.check_cancelled();
      sort(site);
    }
    for (std::uint32_t i = 0; i < leaving_.size(); ++i) w_.cut_ends[i] = leaving_[i].end;
  }

 private:
  const Patch& patch() const { return w_.patch[site_->solid]; }

  void leave_place(std::span<const std::uint32_t> sites) {
    here_.clear();
    for (const std::uint32_t s : sites)
      if (!w_.sites[s].entity.is_face()) here_.push_back(w_.sites[s].vertex);
    for (const std::uint32_t s : sites) {
      site_ = &w_.sites[s];
      for (std::uint32_t i = 0; i < site_->end_count; ++i) {
        Leaving l = leave(site_->first_end + i);
        if (l.end.corner.valid() && patch().brep.from(l.end.corner) != site_->vertex)
          l.end.site = site_with(sites, patch().brep.from(l.end.corner));
        leaving_.push_back(l);
      }
    }
  }

  // Where a face touches itself, the corner may be that of another vertex at the place.
  void group_by_site() {
    for (Site& site : w_.sites) site.end_count = 0;
    for (const Leaving& l : leaving_) ++w_.sites[l.end.site].end_count;
    std::uint32_t first = 0;
    for (Site& site : w_.sites) {
      site.first_end = first;
      first += site.end_count;
      site.end_count = 0;
    }
    std::vector<Leaving> grouped(leaving_.size());
    for (const Leaving& l : leaving_) {
      Site& site = w_.sites[l.end.site];
      grouped[site.first_end + site.end_count++] = l;
    }
    leaving_.swap(grouped);
  }

  std::uint32_t site_with(std::span<const std::uint32_t> sites, VertexId v) const {
    for (const std::uint32_t s : sites)
      if (!w_.sites[s].entity.is_face() && w_.sites[s].vertex == v) return s;
    throw InternalError("a cut leaves a vertex that was not prepared for it");
  }

  Leaving leave(std::uint32_t index) const {
    Leaving l;
    l.end = w_.cut_ends[index];
    const Carrier& c = w_.carriers[l.end.carrier];
    if (c.entity.is_edge()) {
      const HalfEdgeId h = CarrierEdge(w_, c).h;
      const bool at_start = (l.end.which == 0) == c.along;
      l.rank = at_start ? 0 : 2;
      l.end.corner = at_start ? h : next_with_length(patch().brep, h);
    } else {
      const Direction along = along_[l.end.carrier];
      l.direction = l.end.which == 0 ? along : -along;
      if (!site_->entity.is_face()) l.end.corner = corner_of(c.entity.face(), l.direction);
    }
    return l;
  }

  void sort(const Site& site) {
    if (site.end_count < 2) return;
    site_ = &site;
    const std::span<Leaving> ends = std::span(leaving_).subspan(site.first_end, site.end_count);
    if (site.entity.is_face()) {
      sort_within_face(ends);
    } else {
      number_corners(ends);
      sort_around_vertex(ends);
    }
  }

  // The direction of a segment within a face that it cuts.
  Direction direction_along(const Segment& segment, const Carrier& c) const {
    if (!c.cut || !c.entity.is_face()) return {};
    const PlaneId plane = w_.patch[c.solid].plane(c.entity.face());
    const PlaneId across =
        kernel_.parallel(plane, segment.plane[0]) ? segment.plane[1] : segment.plane[0];
    return direction_between(kernel_, plane, across, w_.point(segment.place[0]),
                             w_.point(segment.place[1]));
  }

  // Among the corners of all the face's vertices here, if it touches itself.
  HalfEdgeId corner_of(FaceId face, Direction d) const {
    const Brep& brep = patch().brep;
    HalfEdgeId found;
    for (const VertexId v : here_) {
      const HalfEdgeId first = brep.vertex_half_edge[v.value()];
      HalfEdgeId h = first;
      do {
        if (brep.face_of(h) == face && !is_null(h) && (!found.valid() || inside(h, d))) found = h;
        h = brep.around(h);
      } while (h != first);
    }
    if (!found.valid()) throw InternalError("a cut leaves a vertex into a face that is not there");
    return found;
  }

  bool is_null(HalfEdgeId h) const {
    const Brep& brep = patch().brep;
    return brep.point_of(brep.from(h)) == brep.point_of(brep.to(h));
  }

  bool inside(HalfEdgeId corner, Direction d) const {
    return within_corner(kernel_, patch(), corner, d) == Within::inside;
  }

  void number_corners(std::span<Leaving> ends) const {
    const Brep& brep = patch().brep;
    const HalfEdgeId first = brep.vertex_half_edge[site_->vertex.value()];
    HalfEdgeId h = first;
    std::uint32_t turn = 0;
    do {
      for (Leaving& l : ends)
        if (l.end.corner == h) l.turn = turn;
      ++turn;
      h = brep.around(h);
    } while (h != first);
  }

  void sort_around_vertex(std::span<Leaving> ends) const {
    std::sort(ends.begin(), ends.end(), [&](const Leaving& p, const Leaving& q) {
      if (p.turn != q.turn) return p.turn < q.turn;
      if (p.rank != q.rank || p.rank != 1) return p.rank < q.rank;
      const HalfEdgeId corner = p.end.corner;
      return before_counter_clockwise(kernel_, patch().brep.plane_of(corner),
                                      direction_of(kernel_, patch(), corner), p.direction,
                                      q.direction);
    });
  }

  void sort_within_face(std::span<Leaving> ends) const {
    const PlaneId plane = patch().plane(site_->entity.face());
    const Direction start = ends[0].direction;
    std::sort(ends.begin() + 1, ends.end(), [&](const Leaving& p, const Leaving& q) {
      return before_counter_clockwise(kernel_, plane, start, p.direction, q.direction);
    });
  }

  Workspace& w_;
  const Kernel& kernel_;
  const Site* site_ = nullptr;
  std::vector<Direction> along_;  // per carrier, for cut faces
  std::vector<VertexId> here_;    // of the sites at the place that is looked at
  std::vector<Leaving> leaving_;
};

void number_cut_ends(Workspace& w) {
  for (std::uint32_t i = 0; i < w.cut_ends.size(); ++i)
    w.carriers[w.cut_ends[i].carrier].cut_end[w.cut_ends[i].which] = i;
}

}  // namespace

void order_cuts(Workspace& w) {
  number_cut_ends(w);
  CutOrder(w).run();
  number_cut_ends(w);
}

}  // namespace sectile
