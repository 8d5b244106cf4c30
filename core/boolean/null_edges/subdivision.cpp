#include "boolean/null_edges/subdivision.h"

#include <algorithm>

#include "boolean/line.h"
#include "boolean/patch_euler.h"
#include "boolean/side_by_side.h"

namespace sectile {
namespace {

class EdgeDivider {
 public:
  EdgeDivider(Workspace& w, const Contacts& contacts, const CutPlan& plan, SiteVertices& found)
      : w_(w), kernel_(w.tests()), contacts_(contacts), plan_(plan), found_(found) {}

  // At sites of one operand, ascending by entity.
  void divide_all(IdRange<SiteId> sites) {
    for (SiteId from = sites.front(); from != sites.end_id();) {
      const Entity entity = plan_.sites[from].entity;
      IdRange<SiteId> same(from, from);
      while (same.end_id() != sites.end_id() && plan_.sites[same.end_id()].entity == entity)
        same.extend();
      if (entity.is_vertex())
        for (const SiteId s : same) found_[s].vertex = entity.vertex();
      if (entity.is_edge()) divide(same);
      from = same.end_id();
    }
  }

 private:
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
  const SiteId first_of_b(static_cast<std::uint32_t>(
      std::partition_point(plan.sites.begin(), plan.sites.end(),
                           [](const Site& s) { return s.operand == Operand::a; }) -
      plan.sites.begin()));
  for_both_operands(plan.sites.size(), [&](Operand s) {
    const bool a = s == Operand::a;
    EdgeDivider(w, contacts, plan, found)
        .divide_all(
            IdRange<SiteId>(a ? SiteId(0) : first_of_b, a ? first_of_b : plan.sites.end_id()));
  });
  return found;
}

}  // namespace sectile
