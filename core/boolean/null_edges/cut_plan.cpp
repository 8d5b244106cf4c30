#include "boolean/null_edges/cut_plan.h"

#include "parallel/parallel.h"

namespace sectile {
namespace {

struct Keyed {
  std::uint64_t entity,
      place;  // the operand before the entity; the order of finding after the place
  SegmentId segment;
  CarrierId carrier;
  std::uint8_t which;

  bool same_site(const Keyed& k) const {
    return entity == k.entity && place >> 32 == k.place >> 32;
  }
};

std::vector<Keyed> ends_in_order(const Neighborhoods& n) {
  std::vector<Keyed> ends;
  for (const SegmentId s : n.segments.ids())
    for (const CarrierId id : n.segments[s].carriers) {
      const Carrier& c = n.carriers[id];
      if (!c.cut) continue;
      for (const std::uint8_t which : {std::uint8_t{0}, std::uint8_t{1}})
        ends.push_back({std::uint64_t(c.operand) << 32 | c.end[which].code(),
                        std::uint64_t(n.segments[s].place[which].value()) << 32 | ends.size(), s,
                        id, which});
    }
  parallel::sort(ends.begin(), ends.end(), [](const Keyed& p, const Keyed& q) {
    return p.entity != q.entity ? p.entity < q.entity : p.place < q.place;
  });
  return ends;
}

}  // namespace

CutPlan plan_cuts(const Neighborhoods& neighborhoods) {
  const std::vector<Keyed> ends = ends_in_order(neighborhoods);
  CutPlan plan;
  plan.ends.reserve(ends.size());
  plan.of_carrier.resize(neighborhoods.carriers.size());
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const Keyed& k = ends[i];
    const PlannedEndId end = plan.ends.end_id();
    if (i == 0 || !k.same_site(ends[i - 1])) {
      const Carrier& c = neighborhoods.carriers[k.carrier];
      plan.sites.add({c.operand,
                      c.end[k.which],
                      neighborhoods.segments[k.segment].place[k.which],
                      {end, end}});
    }
    plan.sites.back().ends.extend();
    plan.ends.add({SiteId(plan.sites.size() - 1), k.segment, k.carrier, k.which});
    plan.of_carrier[k.carrier][k.which] = end;
  }
  return plan;
}

}  // namespace sectile
