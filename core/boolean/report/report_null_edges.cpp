// Null edges, and where to their ends are to be moved apart so that they can be seen.
#include <algorithm>
#include <cmath>
#include <utility>

#include "boolean/report/report.h"
#include "boolean/report/report_names.h"
#include "boolean/report/report_places.h"
#include "search/approximate.h"

namespace sectile {
namespace {

void add(Vec3& sum, const Vec3& v, double weight) {
  sum = {sum.x + weight * v.x, sum.y + weight * v.y, sum.z + weight * v.z};
}

Vec3 scaled(const Vec3& v, double by) {
  return {by * v.x, by * v.y, by * v.z};
}

class NullEdgeReport {
 public:
  NullEdgeReport(const Workspace& w, const Contacts& contacts, const Neighborhoods& n,
                 const Cuts& cuts)
      : w_(w), contacts_(contacts), n_(n), cuts_(cuts) {
    for (const Operand s : both_operands) {
      site_of_[s].resize(w.patch[s].brep.edge_count());
      pulls_[s].resize(w.patch[s].brep.vertex_count());
    }
    find_sites();
    add_cuts();
    add_edges();
    spread();
  }

  std::vector<TraceEvent> events() const {
    std::vector<TraceEvent> events;
    for (const NullEdge& e : cuts_.null_edges) events.emplace_back(event(e.operand, e.edge));
    return events;
  }

 private:
  struct Pull {
    Vec3 sum, aside, moved;
    bool complete = false;
  };
  struct Centre {
    Vec3 sum;
    double count = 0, farthest = 0;
  };

  // The first half-edge of each cut's chain; together they are all null edges of the site.
  void find_sites() {
    for (const CutEnd& end : cuts_.ends)
      if (end.last.valid())
        site_of_[cuts_.sites[end.site].operand][Brep::edge_of(end.first)] = end.site;
  }

  // A cut leaves between the two ends of its chain: the first is on its left.
  void add_cuts() {
    for (const CutEnd& end : cuts_.ends) {
      if (!end.last.valid()) continue;
      const Segment& segment = n_.segments[end.segment];
      const Carrier& carrier = n_.carriers[end.carrier];
      const Operand s = carrier.operand;
      const Brep& brep = w_.patch[s].brep;
      Vec3 along = unit_direction(w_, contacts_, segment);
      if (end.which == 1) along = scaled(along, -1);
      const FaceId face = carrier.entity.is_face()
                              ? carrier.entity.face()
                              : brep.face_of(Brep::half_edge(carrier.entity.edge()));
      const Vec3 left =
          w_.patch[s].is_real(face)
              ? unit(approximate::cross(unit_normal(w_.geometry, w_.patch[s].plane(face)), along))
              : Vec3{};
      Pull &first = pulls_[s][brep.from(end.first)], &last = pulls_[s][brep.to(end.last)];
      add(first.sum, along, 0.5);
      add(last.sum, along, 0.5);
      add(first.aside, left, 1);
      add(last.aside, left, -1);
    }
  }

  void add_edges() {
    for (const auto& [operand, edge] : cuts_.null_edges)
      for (const unsigned side : {0u, 1u}) {
        const Patch& patch = w_.patch[operand];
        const VertexId v = patch.brep.from(Brep::half_edge(edge, side));
        Pull& p = pulls_[operand][v];
        if (std::exchange(p.complete, true)) continue;
        for_each_around(patch.brep, patch.brep.vertex_half_edge[v], [&](HalfEdgeId h) {
          if (!patch.is_null(h)) add(p.sum, direction(patch.brep, h), 1);
        });
      }
  }

  Vec3 direction(const Brep& brep, HalfEdgeId h) const {
    return unit(between(w_.geometry.position(brep.point_of(brep.from(h))),
                        w_.geometry.position(brep.point_of(brep.to(h)))));
  }

  // Cuts that leave in opposite directions say nothing but on which side of them a vertex is.
  Vec3 direction_of(const Pull& p) const {
    return unit(approximate::length(p.sum) < 0.01 ? p.aside : p.sum);
  }

  // The vertices of a site move apart: relative to their mean direction, the farthest by one.
  void spread() {
    centres_.resize(cuts_.sites.size());
    for_each_end([&](Pull& p, Centre& centre) {
      p.moved = direction_of(p);
      add(centre.sum, p.moved, 1);
      ++centre.count;
    });
    for_each_end([&](Pull& p, Centre& centre) {
      add(p.moved, centre.sum, -1.0 / centre.count);
      centre.farthest = std::max(centre.farthest, approximate::length(p.moved));
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
    PerOperand<Table<VertexId, std::uint8_t>> seen;
    for (const Operand s : both_operands) seen[s].resize(pulls_[s].size());
    for (const auto& [operand, edge] : cuts_.null_edges) {
      const SiteId site = site_of_[operand][edge];
      if (!site.valid()) continue;
      for (const unsigned side : {0u, 1u}) {
        const VertexId v = w_.patch[operand].brep.from(Brep::half_edge(edge, side));
        if (!std::exchange(seen[operand][v], std::uint8_t{1}))
          visit(pulls_[operand][v], centres_[site]);
      }
    }
  }

  NullEdgeEvent event(Operand s, EdgeId edge) const {
    const Patch& patch = w_.patch[s];
    const HalfEdgeId h = Brep::half_edge(edge);
    const VertexId from = patch.brep.from(h), to = patch.brep.to(h);
    NullEdgeEvent event;
    event.solid = number_of(s);
    event.edge = traced(patch, edge);
    event.from = traced(patch, from);
    event.to = traced(patch, to);
    event.place.point = w_.geometry.position(patch.brep.point_of(from));
    event.pulls = {pulls_[s][from].moved, pulls_[s][to].moved};
    const SiteId site = site_of_[s][edge];
    if (!site.valid()) {
      if (event.pulls[0] == event.pulls[1])
        event.pulls = {direction_of(pulls_[s][from]), direction_of(pulls_[s][to])};
    } else {
      event.place.number = cuts_.sites[site].place.value();
      event.site = {traced(patch, cuts_.sites[site].entity),
                    static_cast<std::uint32_t>(cuts_.sites[site].ends.size())};
    }
    return event;
  }

  const Workspace& w_;
  const Contacts& contacts_;
  const Neighborhoods& n_;
  const Cuts& cuts_;
  PerOperand<Table<EdgeId, SiteId>> site_of_;
  PerOperand<Table<VertexId, Pull>> pulls_;
  Table<SiteId, Centre> centres_;
};

}  // namespace

void report_null_edges(const Workspace& w, const Contacts& contacts,
                       const Neighborhoods& neighborhoods, const Cuts& cuts) {
  w.options.observer->phase_done(Phase::null_edges,
                                 NullEdgeReport(w, contacts, neighborhoods, cuts).events());
}

}  // namespace sectile
