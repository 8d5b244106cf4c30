#include "boolean/null_edges/cut_plan.h"

#include <optional>
#include <tuple>

#include "boolean/entity_numbers.h"
#include "boolean/side_by_side.h"
#include "search/bucket_sort.h"

namespace sectile {
namespace {

// An end of a cut of one operand. Those of one entity and place form a site.
struct CutEndAt {
  Entity entity;
  PlaceId place;
  SegmentId segment;
  CarrierId carrier;
  std::uint8_t which;
};

// The plan of one operand's cuts. Its sites and ends stand in the plan of both from `first_site`
// and `first_end` on.
class OperandPlan {
 public:
  OperandPlan(const Workspace& w, const Neighborhoods& n, Operand s) : operand_(s) {
    for (const SegmentId segment : n.segments.ids())
      for (const CarrierId id : n.segments[segment].carriers) {
        const Carrier& c = n.carriers[id];
        if (!c.cut || c.operand != s) continue;
        for (const std::uint8_t which : {std::uint8_t{0}, std::uint8_t{1}})
          ends_.push_back({c.end[which], n.segments[segment].place[which], segment, id, which});
      }
    if (ends_.empty()) return;
    const EntityNumbers number(w.patch[s].brep);
    bucket_sort(
        ends_, number.size(), [&](const CutEndAt& e) { return number[e.entity]; },
        [](const CutEndAt& p, const CutEndAt& q) {
          return std::tie(p.place, p.carrier, p.which) < std::tie(q.place, q.carrier, q.which);
        });
    for (std::size_t i = 0; i < ends_.size(); ++i) sites_ += begins_site(i) ? 1 : 0;
  }

  std::size_t sites() const { return sites_; }
  std::size_t ends() const { return ends_.size(); }

  void write(CutPlan& plan, std::size_t first_site, std::size_t first_end) const {
    SiteId next(first_site);
    for (std::size_t i = 0; i < ends_.size(); ++i) {
      const CutEndAt& e = ends_[i];
      const PlannedEndId id(first_end + i);
      if (begins_site(i)) {
        plan.sites[next] = {operand_, e.entity, e.place, {id, id}};
        next = SiteId(next.value() + 1);
      }
      const SiteId site(next.value() - 1);
      plan.sites[site].ends.extend();
      plan.ends[id] = {site, e.segment, e.carrier, e.which};
      plan.of_carrier[e.carrier][e.which] = id;
    }
  }

 private:
  bool begins_site(std::size_t i) const {
    return i == 0 || ends_[i].place != ends_[i - 1].place || ends_[i].entity != ends_[i - 1].entity;
  }

  Operand operand_;
  std::vector<CutEndAt> ends_;  // by entity and place, then as they were found
  std::size_t sites_ = 0;
};

}  // namespace

CutPlan plan_cuts(const Workspace& w, const Neighborhoods& neighborhoods) {
  PerOperand<std::optional<OperandPlan>> of;
  const std::size_t carriers = neighborhoods.carriers.size();
  for_both_operands(carriers, [&](Operand s) { of[s].emplace(w, neighborhoods, s); });
  const OperandPlan &a = *of[Operand::a], &b = *of[Operand::b];
  CutPlan plan;
  plan.sites.resize(a.sites() + b.sites());
  plan.ends.resize(a.ends() + b.ends());
  plan.of_carrier.resize(carriers);
  for_both_operands(carriers, [&](Operand s) {
    s == Operand::a ? a.write(plan, 0, 0) : b.write(plan, a.sites(), a.ends());
  });
  return plan;
}

}  // namespace sectile
