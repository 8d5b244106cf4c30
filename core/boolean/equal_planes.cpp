#include "boolean/equal_planes.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <tuple>
#include <vector>

#include "boolean/collect.h"
#include "geometry/same_definition.h"
#include "search/large_sort.h"

namespace sectile {
namespace {

auto doubles(const PlaneValue& s) {
  return std::tie(s.n[0], s.n[1], s.n[2], s.d);
}

// Beyond the doubles nothing can be sorted: such planes stay as they are.
bool is_finite(const PlaneValue& s) {
  return std::isfinite(s.n[0]) && std::isfinite(s.n[1]) && std::isfinite(s.n[2]) &&
         std::isfinite(s.d);
}

bool are_equal(const Workspace& w, PlaneId p, PlaneId q) {
  const PlaneValue &u = w.tests().value(p), &v = w.tests().value(q);
  return p != q && !u.exact && doubles(u) == doubles(v) &&
         have_same_points(w.geometry, w.geometry.definition(p), w.geometry.definition(q));
}

bool operands_share_planes(const Workspace& w, const FacePairs& pairs) {
  const Patch &a = w.patch[Operand::a], &b = w.patch[Operand::b];
  const auto found = collect_ranges<std::uint8_t>(
      w, pairs.size(), 4096, [&](std::size_t first, std::size_t last, std::uint8_t& any) {
        for (const auto& [f, g] : std::span(pairs).subspan(first, last - first))
          any |= are_equal(w, a.plane(f), b.plane(g)) ? 1 : 0;
      });
  return std::ranges::find(found, 1) != found.end();
}

// Per plane: the first one that is equal to it.
Table<PlaneId, PlaneId> first_equal_planes(const Workspace& w) {
  // So many different definitions with equal doubles are told apart; more stay as they are.
  constexpr std::size_t most_definitions = 4;
  Table<PlaneId, PlaneId> first(w.geometry.planes.size());
  std::vector<PlaneId> order;
  for (const PlaneId s : first.ids()) {
    first[s] = s;
    if (const PlaneValue& value = w.tests().value(s); !value.exact && is_finite(value))
      order.push_back(s);
  }
  large_sort(order, [&](PlaneId p, PlaneId q) {
    const auto u = doubles(w.tests().value(p)), v = doubles(w.tests().value(q));
    return u != v ? u < v : p < q;
  });
  std::vector<PlaneId> different;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const PlaneId s = order[i];
    if (i == 0 || doubles(w.tests().value(s)) != doubles(w.tests().value(order[i - 1])))
      different.clear();
    const auto known =
        std::ranges::find_if(different, [&](PlaneId p) { return are_equal(w, p, s); });
    if (known != different.end())
      first[s] = *known;
    else if (different.size() < most_definitions)
      different.push_back(s);
  }
  return first;
}

}  // namespace

void unite_equal_planes(Workspace& w, const FacePairs& pairs) {
  if (!operands_share_planes(w, pairs)) return;
  const Table<PlaneId, PlaneId> first = first_equal_planes(w);
  const auto replace = [&](PlaneId& s) {
    if (s.valid()) s = first[s];
  };
  for (Construction& how : w.geometry.constructions)
    for (PlaneId* s : {&how.a, &how.b, &how.c}) replace(*s);
  for (Patch& patch : w.patch) {
    for (PlaneId& s : patch.brep.plane) replace(s);
    for (PlaneId& s : patch.brep.edge_plane) replace(s);
    for (PlaneId& s : patch.side_plane) replace(s);
  }
}

}  // namespace sectile
