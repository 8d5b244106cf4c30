#include "boolean/null_edges/cut_plan.h"

#include <optional>
#include <tuple>
#include <utility>

#include "boolean/collect.h"
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
  OperandPlan(const Workspace& w, const Neighborhoods& n, Operand s)
      : w_(w), operand_(s), ends_(ends_of_cuts(w, n, s)) {
    if (ends_.empty()) return;
    const EntityNumbers number(w.patch[s].brep);
    bucket_sort(
        ends_, number.size(), [&](const CutEndAt& e) { return number[e.entity]; },
        [](const CutEndAt& p, const CutEndAt& q) {
          return std::tie(p.place, p.carrier, p.which) < std::tie(q.place, q.carrier, q.which);
        });
    first_site_ = collect_ranges<std::size_t>(
        w, ends_.size(), chunk, [&](std::size_t first, std::size_t last, std::size_t& sites) {
          for (std::size_t i = first; i < last; ++i) sites += begins_site(i) ? 1 : 0;
        });
    for (std::size_t& first : first_site_) sites_ += std::exchange(first, sites_);
  }

  std::size_t sites() const { return sites_; }
  std::size_t ends() const { return ends_.size(); }

  void write(CutPlan& plan, std::size_t first_site, std::size_t first_end) const {
    for_each_range(w_, ends_.size(), chunk, [&](std::size_t first, std::size_t last) {
      std::size_t next = first_site + first_site_[first / chunk];
      for (std::size_t i = first; i < last; ++i) {
        const CutEndAt& e = ends_[i];
        const PlannedEndId id(first_end + i);
        if (begins_site(i)) {
          const PlannedEndId end(first_end + end_of_site(i));
          plan.sites[SiteId(next++)] = {operand_, e.entity, e.place, {id, end}};
        }
        plan.ends[id] = {SiteId(next - 1), e.segment, e.carrier, e.which};
        plan.of_carrier[e.carrier][e.which] = id;
      }
    });
  }

 private:
  using Ends = UnsetVector<CutEndAt>;
  static constexpr std::size_t chunk = threshold(4096, 4);

  static Ends ends_of_cuts(const Workspace& w, const Neighborhoods& n, Operand s) {
    return joined(collect<Ends>(w, n.segments.size(), chunk, [&](std::size_t i, Ends& out) {
      const SegmentId segment(i);
      for (const CarrierId id : n.segments[segment].carriers) {
        const Carrier& c = n.carriers[id];
        if (!c.cut || c.operand != s) continue;
        for (const std::uint8_t which : {std::uint8_t{0}, std::uint8_t{1}})
          out.push_back({c.end[which], n.segments[segment].place[which], segment, id, which});
      }
    }));
  }

  bool begins_site(std::size_t i) const {
    return i == 0 || ends_[i].place != ends_[i - 1].place || ends_[i].entity != ends_[i - 1].entity;
  }

  // Of the one that begins there.
  std::size_t end_of_site(std::size_t i) const {
    do ++i;
    while (i < ends_.size() && !begins_site(i));
    return i;
  }

  const Workspace& w_;
  Operand operand_;
  Ends ends_;                            // by entity and place, then as they were found
  std::vector<std::size_t> first_site_;  // per chunk of them: how many sites begin before
  std::size_t sites_ = 0;
};

}  // namespace

CutPlan plan_cuts(const Workspace& w, const Neighborhoods& neighborhoods) {
  PerOperand<std::optional<OperandPlan>> of;
  const std::size_t carriers = neighborhoods.carriers.size();
  for_both_operands(carriers, [&](Operand s) { of[s].emplace(w, neighborhoods, s); });
  const OperandPlan &a = *of[Operand::a], &b = *of[Operand::b];
  CutPlan plan;
  plan.sites.resize_unwritten(a.sites() + b.sites());
  plan.ends.resize_unwritten(a.ends() + b.ends());
  plan.of_carrier.resize(carriers);
  for_both_operands(carriers, [&](Operand s) {
    s == Operand::a ? a.write(plan, 0, 0) : b.write(plan, a.sites(), a.ends());
  });
  return plan;
}

}  // namespace sectile
