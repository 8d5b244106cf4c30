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
  struct Keyed {
    std::uint8_t solid;
    Entity entity;
    PlaceId place;
    std::uint32_t index;
    bool same_site(const Keyed& k) const {
      return solid == k.solid && entity == k.entity && place == k.place;
    }
    auto operator<=>(const Keyed&) const = default;
  };
  std::vector<Keyed> order(w.cut_ends.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) {
    const CutEnd& end = w.cut_ends[i];
    const Carrier& c = w.carriers[end.carrier];
    order[i] = {c.solid, c.end[end.which], w.segments[end.segment].place[end.which], i};
  }
  std::sort(order.begin(), order.end());
  std::vector<CutEnd> sorted;
  sorted.reserve(order.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) {
    if (i == 0 || !order[i].same_site(order[i - 1]))
      w.sites.push_back({order[i].solid, order[i].entity, order[i].place, i, 0, {}, {}});
    ++w.sites.back().end_count;
    sorted.push_back(w.cut_ends[order[i].index]);
    sorted.back().site = static_cast<std::uint32_t>(w.sites.size() - 1);
  }
  w.cut_ends = std::move(sorted);
  // A site may divide an edge, and a cut is two null edges and one between them.
  std::size_t more_edges[2] = {0, 0};
  for (const Site& site : w.sites) more_edges[site.solid] += 1 + 2 * site.end_count;
  for (int s = 0; s < 2; ++s) w.patch[s].reserve(more_edges[s]);
}

namespace {

void subdivide(Workspace& w, EdgeId e, std::span<Site> sites, std::vector<Site*>& order) {
  Patch& patch = w.patch[sites[0].solid];
  Brep& brep = patch.brep;
  const HalfEdgeId first = Brep::half_edge(e);
  const auto [a, b] = line_planes(patch, first);
  const int axis = w.tests().cross_axis(a, b);
  const Sign along =
      w.tests().compare(brep.point_of(brep.from(first)), brep.point_of(brep.to(first)), axis);
  order.clear();
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
  std::vector<Site*> order;
  for (std::size_t from = 0, to; from < w.sites.size(); from = to) {
    Site& site = w.sites[from];
    for (to = from + 1; to < w.sites.size() && w.sites[to].solid == site.solid &&
                        w.sites[to].entity == site.entity;)
      ++to;
    if (site.entity.is_vertex()) site.vertex = site.entity.vertex();
    if (site.entity.is_edge())
      subdivide(w, site.entity.edge(), std::span(w.sites).subspan(from, to - from), order);
  }
}

}  // namespace sectile
