#include "boolean/null_edges/cut_order.h"

#include <algorithm>
#include <map>
#include <span>

#include "boolean/collect.h"
#include "boolean/corner_fan.h"
#include "boolean/direction.h"
#include "numbers/threshold.h"
#include "sectile/errors.h"

namespace sectile {
namespace {

// Where a cut leaves a site: after the `turn`-th half-edge around its vertex, in the sector there.
struct Leaving {
  OrderedEnd end;
  std::uint32_t turn = 0;
  int rank = 1;  // 0: beside the corner's first edge, 1: within the sector, 2: beside the last
  Direction direction;  // within the face, for rank 1
};

// The corners of several vertices, to be found by their face.
class Corners {
 public:
  void collect(const Patch& patch, std::span<const VertexId> vertices) {
    corners_.clear();
    for (const VertexId v : vertices)
      for_each_around(patch.brep, patch.brep.vertex_half_edge[v], [&](HalfEdgeId h) {
        if (!patch.is_null(h))
          corners_.push_back(
              {patch.brep.face_of(h), static_cast<std::uint32_t>(corners_.size()), h});
      });
    std::sort(corners_.begin(), corners_.end());
  }

  struct Corner {
    FaceId face;
    std::uint32_t number;
    HalfEdgeId h;
    friend auto operator<=>(const Corner&, const Corner&) = default;
  };
  // Those of a face, in the order in which they were collected.
  std::span<const Corner> of(FaceId face) const {
    const auto [from, to] =
        std::equal_range(corners_.begin(), corners_.end(), Corner{face, 0, {}},
                         [](const Corner& p, const Corner& q) { return p.face < q.face; });
    return {from, to};
  }

 private:
  std::vector<Corner> corners_;
};

// What all cuts have in common.
struct Given {
  const Workspace& w;
  const Neighborhoods& n;
  const CutPlan& plan;
  const SiteVertices& vertices;
};

// Where the cuts leave the sites of one place.
class PlaceLeaver {
  static constexpr std::size_t few_corners = threshold(16, 1);

 public:
  explicit PlaceLeaver(const Given& given)
      : w_(given.w),
        kernel_(given.w.tests()),
        n_(given.n),
        plan_(given.plan),
        vertices_(given.vertices) {}

  // The ends at all sites of one place, site by site.
  std::span<Leaving> leave_place(std::span<const SiteId> sites) {
    patch_ = &w_.patch[plan_.sites[sites[0]].operand];
    sites_here_.clear();
    vertices_here_.clear();
    for (const SiteId s : sites) {
      if (plan_.sites[s].entity.is_face()) continue;
      sites_here_.push_back({vertices_[s].vertex, s});
      vertices_here_.push_back(vertices_[s].vertex);
    }
    std::sort(sites_here_.begin(), sites_here_.end());
    corners_known_ = false;
    fans_.clear();
    is_alone_ = sites.size() == 1;
    leaving_.clear();
    for (const SiteId s : sites)
      for (const PlannedEndId end : plan_.sites[s].ends) leaving_.push_back(leave(s, end));
    return leaving_;
  }

 private:
  // The half-edge of a carrier that is an edge, from whichever end its even half-edge reaches
  // first.
  HalfEdgeId first_half_edge(CarrierId id) const {
    const Carrier& c = n_.carriers[id];
    const unsigned start = c.along ? 0 : 1;
    return c.end[start].is_vertex()
               ? Brep::half_edge(c.entity.edge())
               : vertices_[plan_.ends[plan_.of_carrier[id][start]].site].forward;
  }

  Leaving leave(SiteId site, PlannedEndId id) {
    const PlannedEnd& end = plan_.ends[id];
    const Carrier& c = n_.carriers[end.carrier];
    Leaving l{{id, site, {}}, 0, 1, {}};
    if (c.entity.is_edge()) {
      const HalfEdgeId h = first_half_edge(end.carrier);
      const bool at_start = (end.which == 0) == c.along;
      l.rank = at_start ? 0 : 2;
      l.end.corner = at_start ? h : next_with_length(patch_->brep, h);
    } else {
      l.direction = end.which == 0 ? c.direction : -c.direction;
      if (plan_.sites[site].entity.is_face()) return l;
      l.end.corner = corner_within_edge(site, c.entity.face());
      if (!l.end.corner.valid()) l.end.corner = corner_of(c.entity.face(), l.direction);
    }
    const VertexId from = patch_->brep.from(l.end.corner);
    if (from != vertices_[site].vertex) l.end.site = site_with(from);
    return l;
  }

  // Where a face touches itself, the corner may be that of another vertex at the place.
  SiteId site_with(VertexId v) const {
    const auto at = std::partition_point(sites_here_.begin(), sites_here_.end(),
                                         [&](const auto& known) { return known.first < v; });
    if (at == sites_here_.end() || at->first != v)
      throw InternalError("a cut leaves a vertex that was not prepared for it");
    return at->second;
  }

  // A point within an edge has two corners. Invalid if that does not tell.
  HalfEdgeId corner_within_edge(SiteId site, FaceId face) const {
    if (!is_alone_ || !plan_.sites[site].entity.is_edge()) return {};
    const HalfEdgeId g = vertices_[site].forward, h = patch_->brep.around(g);
    const bool in_g = patch_->brep.face_of(g) == face, in_h = patch_->brep.face_of(h) == face;
    return in_g == in_h ? HalfEdgeId() : in_g ? g : h;
  }

  // Among the corners of all the face's vertices here, if it touches itself.
  HalfEdgeId corner_of(FaceId face, Direction d) {
    if (!corners_known_) corners_.collect(*patch_, vertices_here_);
    corners_known_ = true;
    const std::span<const Corners::Corner> all = corners_.of(face);
    if (all.empty()) throw InternalError("a cut leaves a vertex into a face that is not there");
    if (all.size() > few_corners)
      if (const CornerFan::Bound& last = fan_of(face, all).last(kernel_, d); last.begins)
        return last.h;
    HalfEdgeId found = all[0].h;
    for (const Corners::Corner& corner : all)
      if (within_corner(kernel_, *patch_, corner.h, d) == Within::inside) found = corner.h;
    return found;
  }

  const CornerFan& fan_of(FaceId face, std::span<const Corners::Corner> corners) {
    const auto known = fans_.find(face);
    if (known != fans_.end()) return known->second;
    std::vector<HalfEdgeId> leaving;
    leaving.reserve(corners.size());
    for (const Corners::Corner& corner : corners) leaving.push_back(corner.h);
    return fans_.emplace(face, CornerFan(kernel_, *patch_, leaving)).first->second;
  }

  const Workspace& w_;
  const Kernel& kernel_;
  const Neighborhoods& n_;
  const CutPlan& plan_;
  const SiteVertices& vertices_;

  // Of the place that is looked at.
  const Patch* patch_ = nullptr;
  std::vector<std::pair<VertexId, SiteId>> sites_here_;
  std::vector<VertexId> vertices_here_;
  bool is_alone_ = false;  // there is no other site
  Corners corners_;        // of the vertices here, once somebody asked
  bool corners_known_ = false;
  std::map<FaceId, CornerFan> fans_;  // of faces with very many corners here, once asked for
  std::vector<Leaving> leaving_;
};

class Ordering {
 public:
  explicit Ordering(const Given& given)
      : given_(given), w_(given.w), kernel_(given.w.tests()), plan_(given.plan) {}

  CutOrder run(const SitesByPlace& places) {
    order_.at.resize_unwritten(plan_.sites.size());
    order_.ends.resize_unwritten(plan_.ends.size());
    const auto moved = collect_ranges<std::uint8_t>(
        w_, places.size(), chunk, [&](std::size_t first, std::size_t last, std::uint8_t& any) {
          PlaceLeaver leaver(given_);
          for (std::size_t i = first; i < last; ++i)
            if (!places[i].empty()) any |= order_place(places[i], leaver.leave_place(places[i]));
        });
    if (std::ranges::find(moved, 1) != moved.end()) group_by_site();
    return std::move(order_);
  }

 private:
  static constexpr std::size_t chunk = threshold(512, 2);

  // Puts the ends at one place, site by site, where those stand that were planned there. True if
  // one of them leaves another site than was planned.
  bool order_place(std::span<const SiteId> sites, std::span<Leaving> ends) {
    const auto site = [](const Leaving& l) { return l.end.site; };
    const bool moved = std::ranges::any_of(
        ends, [&](const Leaving& l) { return site(l) != plan_.ends[l.end.planned].site; });
    if (moved) std::ranges::stable_sort(ends, {}, site);
    for (std::size_t from = 0, to = 0; from < ends.size(); from = to) {
      while (to < ends.size() && site(ends[to]) == site(ends[from])) ++to;
      if (to - from > 1) sort_at_site(site(ends[from]), ends.subspan(from, to - from));
    }
    const Leaving* next = ends.data();
    for (const SiteId s : sites) {
      const IdRange<PlannedEndId>& planned = plan_.sites[s].ends;
      order_.at[s] = {CutEndId(planned.front().value()), CutEndId(planned.end_id().value())};
      for (const CutEndId end : order_.at[s]) order_.ends[end] = next++->end;
    }
    return moved;
  }

  void group_by_site() {
    Table<SiteId, std::uint32_t> count(plan_.sites.size());
    for (const OrderedEnd& end : order_.ends) ++count[end.site];
    CutEndId next(0);
    for (const SiteId s : count.ids()) {
      order_.at[s] = {next, next};
      next = CutEndId(next.value() + count[s]);
    }
    Table<CutEndId, OrderedEnd> grouped(order_.ends.size());
    for (const OrderedEnd& end : order_.ends) {
      IdRange<CutEndId>& here = order_.at[end.site];
      grouped[here.end_id()] = end;
      here.extend();
    }
    order_.ends = std::move(grouped);
  }

  void sort_at_site(SiteId s, std::span<Leaving> ends) const {
    const Site& site = plan_.sites[s];
    const Patch& patch = w_.patch[site.operand];
    if (site.entity.is_face()) {
      sort_within_face(patch, site.entity.face(), ends);
    } else {
      number_corners(patch, given_.vertices[s].vertex, ends);
      sort_around_vertex(patch, ends);
    }
  }

  static void number_corners(const Patch& patch, VertexId vertex, std::span<Leaving> ends) {
    const auto corner = [](const Leaving& l) { return l.end.corner; };
    std::sort(ends.begin(), ends.end(),
              [&](const Leaving& p, const Leaving& q) { return corner(p) < corner(q); });
    std::uint32_t turn = 0;
    for_each_around(patch.brep, patch.brep.vertex_half_edge[vertex], [&](HalfEdgeId h) {
      auto at = std::partition_point(ends.begin(), ends.end(),
                                     [&](const Leaving& l) { return corner(l) < h; });
      for (; at != ends.end() && corner(*at) == h; ++at) at->turn = turn;
      ++turn;
    });
  }

  void sort_around_vertex(const Patch& patch, std::span<Leaving> ends) const {
    std::sort(ends.begin(), ends.end(), [&](const Leaving& p, const Leaving& q) {
      if (p.turn != q.turn) return p.turn < q.turn;
      if (p.rank != q.rank || p.rank != 1) return p.rank < q.rank;
      const HalfEdgeId corner = p.end.corner;
      return before_counter_clockwise(kernel_, patch.brep.plane_of(corner),
                                      direction_of(kernel_, patch, corner), p.direction,
                                      q.direction);
    });
  }

  void sort_within_face(const Patch& patch, FaceId face, std::span<Leaving> ends) const {
    const Direction start = ends[0].direction;
    std::sort(ends.begin() + 1, ends.end(), [&](const Leaving& p, const Leaving& q) {
      return before_counter_clockwise(kernel_, patch.plane(face), start, p.direction, q.direction);
    });
  }

  const Given& given_;
  const Workspace& w_;
  const Kernel& kernel_;
  const CutPlan& plan_;
  CutOrder order_;
};

}  // namespace

CutOrder order_cuts(const Workspace& w, const Neighborhoods& neighborhoods, const CutPlan& plan,
                    const SitesByPlace& places, const SiteVertices& vertices) {
  return Ordering({w, neighborhoods, plan, vertices}).run(places);
}

}  // namespace sectile
