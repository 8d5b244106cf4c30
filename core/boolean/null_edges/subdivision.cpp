#include "boolean/null_edges/subdivision.h"

#include <algorithm>

#include "boolean/line.h"
#include "boolean/patch_euler.h"

namespace sectile {
namespace {

class EdgeDivider {
 public:
  EdgeDivider(Workspace& w, const Contacts& contacts, const CutPlan& plan, SiteVertices& found)
      : w_(w), kernel_(w.tests()), contacts_(contacts), plan_(plan), found_(found) {}

  // All sites on one edge.
  void divide(IdRange<SiteId> sites) {
    const Site& any = plan_.sites[sites.front()];
    Patch& patch = w_.patch[any.operand];
    HalfEdgeId h = Brep::half_edge(any.entity.edge());
    sort_along(patch, h, sites);
    PatchEuler euler(patch);
    for (const SiteId s : order_) {
      h = euler.divide(h, point(s));
      found_[s] = {patch.brep.from(h), h};
    }
  }

 private:
  PointId point(SiteId s) const { return contacts_.point(plan_.sites[s].place); }

  void sort_along(const Patch& patch, HalfEdgeId h, IdRange<SiteId> sites) {
    order_.clear();
    for (const SiteId s : sites) order_.push_back(s);
    if (order_.size() < 2) return;
    const auto [a, b] = line_planes(patch, h);
    const int axis = kernel_.cross_axis(a, b);
    const Sign along = kernel_.compare(patch.brep.point_of(patch.brep.from(h)),
                                       patch.brep.point_of(patch.brep.to(h)), axis);
    std::sort(order_.begin(), order_.end(), [&](SiteId s, SiteId t) {
      return kernel_.compare(point(s), point(t), axis) == along;
    });
  }

  Workspace& w_;
  const Kernel& kernel_;
  const Contacts& contacts_;
  const CutPlan& plan_;
  SiteVertices& found_;
  std::vector<SiteId> order_;
};

}  // namespace

SiteVertices subdivide_edges(Workspace& w, const Contacts& contacts, const CutPlan& plan) {
  SiteVertices found(plan.sites.size());
  EdgeDivider divider(w, contacts, plan, found);
  for (SiteId from(0); from != plan.sites.end_id();) {
    const Site& site = plan.sites[from];
    IdRange<SiteId> same(from, from);
    while (plan.sites.has(same.end_id()) && plan.sites[same.end_id()].operand == site.operand &&
           plan.sites[same.end_id()].entity == site.entity)
      same.extend();
    if (site.entity.is_vertex())
      for (const SiteId s : same) found[s].vertex = site.entity.vertex();
    if (site.entity.is_edge()) divider.divide(same);
    from = same.end_id();
  }
  return found;
}

}  // namespace sectile
