#include "boolean/reduction/tests_on_lines.h"

#include <algorithm>
#include <tuple>

namespace sectile {
namespace {

// A vertex or edge, by its number, and a face of the other solid.
struct Possible {
  std::uint32_t mine;
  FaceId across;
  std::uint32_t pair;
  HalfEdgeId h;
};

std::vector<Possible> first_of_each(std::vector<Possible> all) {
  const auto what = [](const Possible& p) { return std::tie(p.mine, p.across); };
  std::ranges::sort(all, [](const Possible& p, const Possible& q) {
    return std::tie(p.mine, p.across, p.pair, p.h) < std::tie(q.mine, q.across, q.pair, q.h);
  });
  const auto same = [&](const Possible& p, const Possible& q) { return what(p) == what(q); };
  all.erase(std::unique(all.begin(), all.end(), same), all.end());
  return all;
}

}  // namespace

TestsOnLines::TestsOnLines(const Workspace& w, const FacePairs& candidates)
    : w_(w), any_(!w.patch[Operand::a].on_crowded_line.empty()) {
  if (!any_) return;
  for (const Operand s : both_operands) find(s, candidates);
}

void TestsOnLines::find(Operand s, const FacePairs& candidates) {
  const Brep& brep = w_.patch[s].brep;
  std::vector<Possible> vertices, edges;
  for (std::uint32_t pair = 0; pair < candidates.size(); ++pair) {
    const auto [f, g] = candidates[pair];
    const FaceId across = s == Operand::a ? g : f;
    for_each_in_face(brep, s == Operand::a ? f : g, [&](HalfEdgeId h) {
      if (has_vertex(s, brep.from(h))) vertices.push_back({brep.from(h).value(), across, pair, h});
      if (has_edge(s, h)) edges.push_back({Brep::edge_of(h).value(), across, pair, h});
    });
  }
  for (const Possible& p : first_of_each(std::move(vertices)))
    vertices_[s].push_back({p.pair, p.h});
  for (const Possible& p : first_of_each(std::move(edges))) edges_[s].push_back({p.pair, p.h});
  std::ranges::sort(vertices_[s]);
  std::ranges::sort(edges_[s]);
}

bool TestsOnLines::contains(const std::vector<Test>& tests, std::size_t pair, HalfEdgeId h) {
  return std::ranges::binary_search(tests, Test{static_cast<std::uint32_t>(pair), h});
}

}  // namespace sectile
