#include <algorithm>

#include "boolean/direction.h"
#include "boolean/line.h"
#include "boolean/null_edges.h"
#include "sectile/errors.h"
#include "topology/euler.h"

namespace sectile {

void find_sites(Workspace& w) {
  for (std::uint32_t s = 0; s < w.segments.size(); ++s) {
    const Segment& segment = w.segments[s];
    for (std::uint32_t i = 0; i < segment.carrier_count; ++i) {
      const std::uint32_t index = segment.first_carrier + i;
      if (!w.carriers[index].cut) continue;
      for (std::uint8_t which = 0; which < 2; ++which)
        w.cut_ends.push_back({0, s, index, which, {}, {}, {}});
    }
  }
  const auto key = [&](const CutEnd& end) {
    const Carrier& c = w.carriers[end.carrier];
    return std::tuple(c.solid, c.end[end.which], w.segments[end.segment].place[end.which]);
  };
  std::stable_sort(w.cut_ends.begin(), w.cut_ends.end(),
                   [&](const CutEnd& p, const CutEnd& q) { return key(p) < key(q); });
  for (std::uint32_t i = 0; i < w.cut_ends.size(); ++i) {
    if (i == 0 || key(w.cut_ends[i]) != key(w.cut_ends[i - 1])) {
      const auto [solid, entity, place] = key(w.cut_ends[i]);
      w.sites.push_back({solid, entity, place, i, 0, {}, {}});
    }
    ++w.sites.back().end_count;
    w.cut_ends[i].site = static_cast<std::uint32_t>(w.sites.size() - 1);
  }
}

namespace {

void subdivide(Workspace& w, EdgeId e, std::span<Site> sites) {
  Patch& patch = w.patch[sites[0].solid];
  Brep& brep = patch.brep;
  const HalfEdgeId first = Brep::half_edge(e);
  const auto [a, b] = line_planes(patch, first);
  const int axis = w.tests().cross_axis(a, b);
  const Sign along =
      w.tests().compare(brep.point_of(brep.from(first)), brep.point_of(brep.to(first)), axis);
  std::vector<Site*> order;
  for (Site& site : sites) order.push_back(&site);
  std::sort(order.begin(), order.end(), [&](const Site* p, const Site* q) {
    return w.tests().compare(w.point(p->place), w.point(q->place), axis) == along;
  });
  HalfEdgeId h = first;
  for (Site* site : order) {
    site->vertex = Euler(brep).semv(h, w.point(site->place));
    h = site->forward = brep.vertex_half_edge[site->vertex.value()];
    patch.side_plane.resize(brep.half_edge_count());
    patch.half_edge_in_solid.resize(brep.half_edge_count());
    patch.side_plane[h.value()] = patch.side(first);
    patch.side_plane[Brep::twin(h).value()] = patch.side(Brep::twin(first));
  }
}

}  // namespace

void subdivide_edges(Workspace& w) {
  for (std::size_t from = 0, to; from < w.sites.size(); from = to) {
    Site& site = w.sites[from];
    for (to = from + 1; to < w.sites.size() && w.sites[to].solid == site.solid &&
                        w.sites[to].entity == site.entity;)
      ++to;
    if (site.entity.is_vertex()) site.vertex = site.entity.vertex();
    if (site.entity.is_edge())
      subdivide(w, site.entity.edge(), std::span(w.sites).subspan(from, to - from));
  }
}

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
  std::uint32_t end;  // index of the CutEnd
  std::uint32_t turn = 0;
  HalfEdgeId corner;
  int rank = 1;  // 0: beside the corner's first edge, 1: within the sector, 2: beside the last
  Direction direction;  // within the face, for rank 1
};

class CutOrder {
 public:
  CutOrder(Workspace& w, const Site& site) : w_(w), kernel_(w.tests()), site_(site) {}

  void run() {
    for (std::uint32_t i = 0; i < site_.end_count; ++i) leave(site_.first_end + i);
    if (site_.entity.is_face()) {
      sort_within_face();
    } else {
      number_corners();
      sort_around_vertex();
    }
    std::vector<CutEnd> ordered;
    for (const Leaving& l : leaving_) {
      ordered.push_back(w_.cut_ends[l.end]);
      ordered.back().corner = l.corner;
    }
    for (std::uint32_t i = 0; i < site_.end_count; ++i)
      w_.cut_ends[site_.first_end + i] = ordered[i];
  }

 private:
  const Patch& patch() const { return w_.patch[site_.solid]; }

  void leave(std::uint32_t index) {
    const CutEnd& end = w_.cut_ends[index];
    const Carrier& c = w_.carriers[end.carrier];
    Leaving l;
    l.end = index;
    if (c.entity.is_edge()) {
      const HalfEdgeId h = CarrierEdge(w_, c).h;
      const bool at_start = (end.which == 0) == c.along;
      l.rank = at_start ? 0 : 2;
      l.corner = at_start ? h : patch().brep.next_of(h);
    } else {
      l.direction = direction_within(end, c.entity.face());
      if (!site_.entity.is_face()) l.corner = corner_of(c.entity.face(), l.direction);
    }
    leaving_.push_back(l);
  }

  Direction direction_within(const CutEnd& end, FaceId face) const {
    const Segment& segment = w_.segments[end.segment];
    const PlaneId plane = patch().plane(face);
    const PlaneId across =
        kernel_.parallel(plane, segment.plane[0]) ? segment.plane[1] : segment.plane[0];
    const int axis = kernel_.cross_axis(plane, across);
    const Sign along =
        kernel_.compare(w_.point(segment.place[0]), w_.point(segment.place[1]), axis);
    const Direction d{across, along * kernel_.cross(plane, across, axis)};
    return end.which == 0 ? d : -d;
  }

  HalfEdgeId corner_of(FaceId face, Direction d) const {
    const Brep& brep = patch().brep;
    HalfEdgeId found;
    const HalfEdgeId first = brep.vertex_half_edge[site_.vertex.value()];
    HalfEdgeId h = first;
    do {
      if (brep.face_of(h) == face && (!found.valid() || inside(h, d))) found = h;
      h = brep.around(h);
    } while (h != first);
    if (!found.valid()) throw InternalError("a cut leaves a vertex into a face that is not there");
    return found;
  }

  bool inside(HalfEdgeId corner, Direction d) const {
    return within_corner(kernel_, patch(), corner, d) == Within::inside;
  }

  void number_corners() {
    const Brep& brep = patch().brep;
    const HalfEdgeId first = brep.vertex_half_edge[site_.vertex.value()];
    HalfEdgeId h = first;
    std::uint32_t turn = 0;
    do {
      for (Leaving& l : leaving_)
        if (l.corner == h) l.turn = turn;
      ++turn;
      h = brep.around(h);
    } while (h != first);
  }

  void sort_around_vertex() {
    std::sort(leaving_.begin(), leaving_.end(), [&](const Leaving& p, const Leaving& q) {
      if (p.turn != q.turn) return p.turn < q.turn;
      if (p.rank != q.rank) return p.rank < q.rank;
      if (p.end == q.end) return false;
      return before_counter_clockwise(kernel_, patch().brep.plane_of(p.corner),
                                      direction_of(kernel_, patch(), p.corner), p.direction,
                                      q.direction);
    });
  }

  void sort_within_face() {
    const PlaneId plane = patch().plane(site_.entity.face());
    const Direction start = leaving_[0].direction;
    std::sort(leaving_.begin() + 1, leaving_.end(), [&](const Leaving& p, const Leaving& q) {
      if (p.end == q.end) return false;
      return before_counter_clockwise(kernel_, plane, start, p.direction, q.direction);
    });
  }

  Workspace& w_;
  const Kernel& kernel_;
  const Site& site_;
  std::vector<Leaving> leaving_;
};

}  // namespace

void order_cuts(Workspace& w) {
  for (std::uint32_t i = 0; i < w.cut_ends.size(); ++i)
    w.carriers[w.cut_ends[i].carrier].cut_end[w.cut_ends[i].which] = i;
  for (const Site& site : w.sites) CutOrder(w, site).run();
  for (std::uint32_t i = 0; i < w.cut_ends.size(); ++i)
    w.carriers[w.cut_ends[i].carrier].cut_end[w.cut_ends[i].which] = i;
}

}  // namespace sectile
