#include "boolean/loading/equal_planes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "boolean/collect.h"
#include "geometry/same_definition.h"
#include "search/large_sort.h"

namespace sectile {
namespace {

bool are_equal(const Workspace& w, PlaneId p, PlaneId q) {
  return p != q && !w.tests().value(p).exact &&
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

// A plane with its coefficients in doubles, which are equal where definitions are. Those that are
// beyond the doubles are left to their definitions.
struct Keyed {
  std::array<double, 4> doubles;
  PlaneId plane;
};

Keyed keyed(const Workspace& w, PlaneId plane) {
  const PlaneValue& s = w.tests().value(plane);
  const std::array<double, 4> doubles{s.n[0], s.n[1], s.n[2], s.d};
  const bool finite = std::ranges::all_of(doubles, [](double x) { return std::isfinite(x); });
  return {finite ? doubles : std::array<double, 4>{}, plane};
}

// Per plane: the first one that is equal to it.
Table<PlaneId, PlaneId> first_equal_planes(const Workspace& w) {
  Table<PlaneId, PlaneId> first(w.geometry.planes.size());
  std::vector<Keyed> order;
  for (const PlaneId s : first.ids()) {
    first[s] = s;
    if (!w.tests().value(s).exact) order.push_back(keyed(w, s));
  }
  large_sort(order, [&](const Keyed& p, const Keyed& q) {
    if (p.doubles != q.doubles) return p.doubles < q.doubles;
    const PlaneDefinition &u = w.geometry.definition(p.plane), &v = w.geometry.definition(q.plane);
    if (is_defined_before(w.geometry, u, v)) return true;
    return !is_defined_before(w.geometry, v, u) && p.plane < q.plane;
  });
  for (std::size_t i = 1; i < order.size(); ++i)
    if (are_equal(w, order[i - 1].plane, order[i].plane))
      first[order[i].plane] = first[order[i - 1].plane];
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
