// Null edges, and where to their ends are to be moved apart so that they can be seen.
#include <algorithm>
#include <cmath>
#include <utility>

#include "boolean/report.h"
#include "boolean/report_names.h"
#include "boolean/report_places.h"

namespace sectile {
namespace {

void add(Vec3& sum, const Vec3& v, double weight) {
  sum = {sum.x + weight * v.x, sum.y + weight * v.y, sum.z + weight * v.z};
}

Vec3 scaled(const Vec3& v, double by) {
  return {by * v.x, by * v.y, by * v.z};
}

double length(const Vec3& v) {
  return std::hypot(v.x, v.y, v.z);
}

class NullEdgeReport {
 public:
  explicit NullEdgeReport(const Workspace& w) : w_(w) {
    for (int s = 0; s < 2; ++s) {
      site_of_[s].assign(w.patch[s].brep.edge_count(), no_site);
      pulls_[s].resize(w.patch[s].brep.vertex_count());
    }
    find_sites();
    add_cuts();
    add_edges();
    spread();
  }

  std::vector<TraceEvent> events() const {
    std::vector<TraceEvent> events;
    for (const auto& [solid, edge] : w_.null_edges) events.emplace_back(event(solid, edge));
    return events;
  }

 private:
  static constexpr std::uint32_t no_site = 0xFFFFFFFFu;
  struct Pull {
    Vec3 sum, aside, moved;
    bool complete = false;
  };
  struct Centre {
    Vec3 sum;
    double count = 0, farthest = 0;
  };

  bool is_null(const Brep& brep, HalfEdgeId h) const {
    return brep.point_of(brep.from(h)) == brep.point_of(brep.to(h));
  }

  // The first half-edge of each cut's chain; together they are all null edges of the site.
  void find_sites() {
    for (const CutEnd& end : w_.cut_ends)
      if (end.last.valid())
        site_of_[w_.sites[end.site].solid][Brep::edge_of(end.first).value()] = end.site;
  }

  // A cut leaves between the two ends of its chain: the first is on its left.
  void add_cuts() {
    for (const CutEnd& end : w_.cut_ends) {
      if (!end.last.valid()) continue;
      const Segment& segment = w_.segments[end.segment];
      const Carrier& carrier = w_.carriers[end.carrier];
      const int s = carrier.solid;
      const Brep& brep = w_.patch[s].brep;
      Vec3 along = unit_direction(w_, segment);
      if (end.which == 1) along = scaled(along, -1);
      const FaceId face = carrier.entity.is_face()
                              ? carrier.entity.face()
                              : brep.face_of(Brep::half_edge(carrier.entity.edge()));
      const Vec3 left = w_.patch[s].is_real(face)
                            ? unit(cross(unit_normal(w_.geometry, w_.patch[s].plane(face)), along))
                            : Vec3{};
      Pull &first = pulls_[s][brep.from(end.first).value()],
           &last = pulls_[s][brep.to(end.last).value()];
      add(first.sum, along, 0.5);
      add(last.sum, along, 0.5);
      add(first.aside, left, 1);
      add(last.aside, left, -1);
    }
  }

  void add_edges() {
    for (const auto& [solid, edge] : w_.null_edges)
      for (const unsigned side : {0u, 1u}) {
        const Brep& brep = w_.patch[solid].brep;
        const VertexId v = brep.from(Brep::half_edge(edge, side));
        Pull& p = pulls_[solid][v.value()];
        if (std::exchange(p.complete, true)) continue;
        for_each_around(brep, v, [&](HalfEdgeId h) {
          if (!is_null(brep, h)) add(p.sum, direction(brep, h), 1);
        });
      }
  }

  template <class Visit>
  void for_each_around(const Brep& brep, VertexId v, const Visit& visit) const {
    const HalfEdgeId first = brep.vertex_half_edge[v.value()];
    HalfEdgeId h = first;
    do {
      visit(h);
      h = brep.around(h);
    } while (h != first);
  }

  Vec3 direction(const Brep& brep, HalfEdgeId h) const {
    return unit(between(w_.geometry.position(brep.point_of(brep.from(h))),
                        w_.geometry.position(brep.point_of(brep.to(h)))));
  }

  // Cuts that leave in opposite directions say nothing but on which side of them a vertex is.
  Vec3 direction_of(const Pull& p) const { return unit(length(p.sum) < 0.01 ? p.aside : p.sum); }

  // The vertices of a site move apart: relative to their mean direction, the farthest by one.
  void spread() {
    centres_.resize(w_.sites.size());
    for_each_end([&](Pull& p, Centre& centre) {
      p.moved = direction_of(p);
      add(centre.sum, p.moved, 1);
      ++centre.count;
    });
    for_each_end([&](Pull& p, Centre& centre) {
      add(p.moved, centre.sum, -1.0 / centre.count);
      centre.farthest = std::max(centre.farthest, length(p.moved));
    });
    for_each_end([&](Pull& p, Centre& centre) {
      if (centre.farthest < 0.01)
        p.moved = unit(p.aside);
      else
        p.moved = scaled(p.moved, 1 / centre.farthest);
    });
  }

  // Each vertex of null edges that belongs to a site, once.
  template <class Visit>
  void for_each_end(const Visit& visit) {
    std::vector<std::uint8_t> seen[2];
    for (int s = 0; s < 2; ++s) seen[s].assign(pulls_[s].size(), 0);
    for (const auto& [solid, edge] : w_.null_edges) {
      const std::uint32_t site = site_of_[solid][edge.value()];
      if (site == no_site) continue;
      for (const unsigned side : {0u, 1u}) {
        const VertexId v = w_.patch[solid].brep.from(Brep::half_edge(edge, side));
        if (!std::exchange(seen[solid][v.value()], std::uint8_t{1}))
          visit(pulls_[solid][v.value()], centres_[site]);
      }
    }
  }

  NullEdgeEvent event(std::uint8_t s, EdgeId edge) const {
    const Patch& patch = w_.patch[s];
    const HalfEdgeId h = Brep::half_edge(edge);
    const VertexId from = patch.brep.from(h), to = patch.brep.to(h);
    NullEdgeEvent event;
    event.solid = s;
    event.edge = traced(patch, edge);
    event.from = traced(patch, from);
    event.to = traced(patch, to);
    event.place.point = w_.geometry.position(patch.brep.point_of(from));
    event.pulls = {pulls_[s][from.value()].moved, pulls_[s][to.value()].moved};
    const std::uint32_t site = site_of_[s][edge.value()];
    if (site == no_site) {
      if (event.pulls[0] == event.pulls[1])
        event.pulls = {direction_of(pulls_[s][from.value()]), direction_of(pulls_[s][to.value()])};
    } else {
      event.place.number = w_.sites[site].place.value();
      event.site = {traced(patch, w_.sites[site].entity), w_.sites[site].end_count};
    }
    return event;
  }

  const Workspace& w_;
  std::vector<std::uint32_t> site_of_[2];  // per edge
  std::vector<Pull> pulls_[2];             // per vertex
  std::vector<Centre> centres_;            // per site
};

}  // namespace

void report_null_edges(const Workspace& w) {
  w.options.observer->phase_done(Phase::null_edges, NullEdgeReport(w).events());
}

}  // namespace sectile
