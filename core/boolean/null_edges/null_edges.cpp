#include "boolean/null_edges/null_edges.h"

#include "boolean/check_links.h"
#include "boolean/collect.h"
#include "boolean/null_edges/bridging.h"
#include "boolean/null_edges/cut_order.h"
#include "boolean/null_edges/subdivision.h"
#include "boolean/patch_euler.h"
#include "boolean/side_by_side.h"

namespace sectile {
namespace {

// Splits each site of an operand and attaches the cuts to its null edges.
class SiteSplitter {
 public:
  SiteSplitter(Patch& patch, const Contacts& contacts, Cuts& cuts,
               std::vector<NullEdge>& null_edges)
      : patch_(patch), contacts_(contacts), cuts_(cuts), null_edges_(null_edges) {}

  void split(const SplitSite& site, const CutOrder& order) {
    site_ = &site;
    if (site.entity.is_face())
      split_face();
    else
      split_vertex(order);
  }

 private:
  std::size_t cut_count() const { return site_->ends.size(); }
  void attach(std::size_t cut, HalfEdgeId first, HalfEdgeId last) {
    CutEnd& end = cuts_.ends[site_->ends[cut]];
    end.first = first;
    end.last = last;
  }

  // The first null edge is an inner loop of the face, and further ones extend it. Cut 0 faces its
  // twin; the last cut faces the whole chain.
  void split_face() {
    PatchEuler euler(patch_);
    const std::size_t k = cut_count();
    const HalfEdgeId out = euler.mevvr(site_->entity.face(), contacts_.point(site_->place));
    keep(out);
    HalfEdgeId last_out = out, end = Brep::twin(out);
    attach(0, k == 1 ? out : end, k == 1 ? out : end);
    for (std::size_t i = 1; i + 1 < k; ++i) {
      last_out = euler.mev(end, end);
      keep(last_out);
      end = Brep::twin(last_out);
      attach(i, end, end);
    }
    if (k > 1) attach(k - 1, out, last_out);
  }

  // The last cut in counter-clockwise order comes before all other edges: what lies between it and
  // the first one stays with the old vertex.
  void split_vertex(const CutOrder& order) {
    const std::size_t k = cut_count();
    const auto corner = [&](std::size_t cut) { return order.ends[site_->ends[cut]].corner; };
    if (k == 0) return;  // all its cuts leave other vertices at its place
    if (k == 1) return attach(0, corner(0), {});
    // The run after each cut moves on, with all further ones.
    runs_.clear();
    made_.clear();
    for (std::size_t i = 0; i + 1 < k; ++i) {
      const bool moves = corner(i) != corner(k - 1);
      runs_.push_back(moves ? patch_.brep.around(corner(i)) : HalfEdgeId());
    }
    PatchEuler(patch_).mev_chain(runs_, patch_.brep.around(corner(k - 1)), made_);
    for (std::size_t i = 0; i + 1 < k; ++i) {
      keep(made_[i]);
      attach(i, Brep::twin(made_[i]), Brep::twin(made_[i]));
    }
    attach(k - 1, made_.front(), made_.back());
  }

  void keep(HalfEdgeId made) { null_edges_.push_back({site_->operand, Brep::edge_of(made)}); }

  Patch& patch_;
  const Contacts& contacts_;
  Cuts& cuts_;
  std::vector<NullEdge>& null_edges_;
  const SplitSite* site_ = nullptr;
  std::vector<HalfEdgeId> runs_, made_;
};

// A site may divide an edge, and a cut is two null edges and one between them.
void reserve(Workspace& w, const CutPlan& plan) {
  PerOperand<std::size_t> more_edges;
  for (const Site& site : plan.sites) more_edges[site.operand] += 1 + 2 * site.ends.size();
  for (const Operand s : both_operands) w.patch[s].reserve(more_edges[s]);
}

Cuts in_order(const Workspace& w, const CutPlan& plan, const CutOrder& order) {
  Cuts cuts;
  cuts.sites.resize_unwritten(plan.sites.size());
  cuts.ends.resize_unwritten(order.ends.size());
  cuts.of_carrier.resize(plan.of_carrier.size());
  for_each(w, plan.sites.size(), 1024, [&](std::size_t i) {
    const SiteId s(i);
    const Site& site = plan.sites[s];
    cuts.sites[s] = {site.operand, site.entity, site.place, order.at[s]};
    for (const CutEndId end : order.at[s]) {
      const PlannedEnd& planned = plan.ends[order.ends[end].planned];
      cuts.ends[end] = {s, planned.segment, planned.carrier, planned.which, {}, {}};
      cuts.of_carrier[planned.carrier][planned.which] = end;
    }
  });
  return cuts;
}

}  // namespace

Cuts insert_null_edges(Workspace& w, const Contacts& contacts, const Neighborhoods& neighborhoods,
                       const CutPlan& plan) {
  reserve(w, plan);
  const SiteVertices vertices = subdivide_edges(w, contacts, plan);
  check_links(w, "subdivision");
  const SitesByPlace places(plan, contacts.places.size());
  PerOperand<OperandBridges> bridges = bridge_touching_corners(w, plan, places, vertices);
  const CutOrder order = order_cuts(w, neighborhoods, plan, places, vertices);
  Cuts cuts = in_order(w, plan, order);
  for_both_operands(cuts.sites.size(), [&](Operand s) {
    SiteSplitter splitter(w.patch[s], contacts, cuts, bridges[s].null_edges);
    for (const SplitSite& site : cuts.sites) {
      if (site.operand != s) continue;
      w.check_cancelled();
      splitter.split(site, order);
    }
  });
  for (const Operand s : both_operands) {
    append(cuts.null_edges, std::move(bridges[s].null_edges));
    cuts.bridged[s] = std::move(bridges[s].faces);
  }
  return cuts;
}

}  // namespace sectile
