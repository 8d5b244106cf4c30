#include "boolean/reduction/tests_on_lines.h"

#include <algorithm>
#include <optional>
#include <span>
#include <tuple>

namespace sectile {
namespace {

// What a face has on lines: a vertex or edge, by its number, at its first half-edge there.
struct OfFace {
  std::uint32_t mine;
  HalfEdgeId h;
  friend auto operator<=>(const OfFace&, const OfFace&) = default;
};

// Of all faces: of many vertices in one place, the one that is tested for them.
class FirstOfFaces {
 public:
  template <class Find>
  FirstOfFaces(const Brep& brep, const Find& find) {
    for (const FaceId f : brep.faces()) {
      const std::size_t first = all_.size();
      for_each_in_face(brep, f, [&](HalfEdgeId h) {
        if (const auto mine = find(h)) all_.push_back({*mine, h});
      });
      keep_first_of_each(first);
      end_.push_back(static_cast<std::uint32_t>(all_.size()));
    }
  }

  std::span<const OfFace> of(FaceId f) const {
    const std::uint32_t from = f.value() == 0 ? 0 : end_[f.value() - 1];
    return std::span(all_).subspan(from, end_[f.value()] - from);
  }

 private:
  void keep_first_of_each(std::size_t first) {
    const auto from = all_.begin() + static_cast<std::ptrdiff_t>(first);
    std::sort(from, all_.end());
    all_.erase(std::unique(from, all_.end(),
                           [](const OfFace& i, const OfFace& j) { return i.mine == j.mine; }),
               all_.end());
  }

  std::vector<OfFace> all_;  // by face
  std::vector<std::uint32_t> end_;
};

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
  const Patch& patch = w_.patch[s];
  const FirstOfFaces vertices(patch.brep, [&](HalfEdgeId h) -> std::optional<std::uint32_t> {
    const VertexId v = patch.brep.from(h);
    if (!has_vertex(s, v)) return {};
    return patch.tested(v).value();
  });
  const FirstOfFaces edges(patch.brep, [&](HalfEdgeId h) -> std::optional<std::uint32_t> {
    if (!has_edge(s, h)) return {};
    return Brep::edge_of(h).value();
  });
  const auto find_tests = [&](const FirstOfFaces& all, std::vector<Test>& tests) {
    std::vector<Possible> possible;
    for (std::uint32_t pair = 0; pair < candidates.size(); ++pair) {
      const auto [f, g] = candidates[pair];
      for (const OfFace& i : all.of(s == Operand::a ? f : g))
        possible.push_back({i.mine, s == Operand::a ? g : f, pair, i.h});
    }
    for (const Possible& p : first_of_each(std::move(possible))) tests.push_back({p.pair, p.h});
    std::ranges::sort(tests);
  };
  find_tests(vertices, vertices_[s]);
  find_tests(edges, edges_[s]);
}

bool TestsOnLines::contains(const std::vector<Test>& tests, std::size_t pair, HalfEdgeId h) {
  return std::ranges::binary_search(tests, Test{static_cast<std::uint32_t>(pair), h});
}

}  // namespace sectile
