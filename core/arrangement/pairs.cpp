#include "arrangement/pairs.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <optional>
#include <utility>

#include "arrangement/facet_pieces.h"
#include "arrangement/pair_test.h"
#include "boolean/collect.h"
#include "numbers/threshold.h"
#include "parallel/parallel.h"
#include "parallel/sort.h"
#include "search/needles.h"
#include "search/oriented_tree.h"

namespace sectile::arrangement {
namespace {

// Do two edges that follow each other on one line run against each other?
bool turns_back(const Facets& facets, std::uint32_t c, std::uint32_t d, const Kernel& kernel) {
  for (int axis = 0; axis < 3; ++axis)
    if (const Sign way = kernel.compare(facets.from(c), facets.to(c), axis); way != Sign::zero)
      return kernel.compare(facets.from(d), facets.to(d), axis) != way;
  return true;
}

// Of the faces, if many are long, thin and slanted.
std::optional<OrientedTree> oriented_tree_of(const Facets& facets, const BoxTree& tree,
                                             const Geometry& geometry) {
  const auto for_each_corner = [&](std::uint32_t f, const auto& add) {
    for_each_outer_corner(facets, f, [&](PointId p) { add(geometry.position(p)); });
  };
  if (!has_slanted_needles(facets.face_count(), for_each_corner)) return {};
  return OrientedTree(tree, for_each_corner);
}

// There are more pairs than was expected.
struct Crowded {};

class PairFinder {
 public:
  PairFinder(const Facets& facets, const std::vector<std::uint8_t>& convex, const Kernel& kernel,
             const Steering& steering)
      : facets_(facets), kernel_(kernel), steering_(steering), test_(facets, convex, kernel) {}

  /// Throws Crowded if there are more than so many.
  std::vector<FacePair> run(const FacetTree& tree, Crowds crowds, std::size_t most) {
    most_ = most;
    const std::optional<OrientedTree> oriented =
        oriented_tree_of(facets_, tree, kernel_.geometry());
    const OrientedTree* boxes = oriented ? &*oriented : nullptr;
    const OrientedApart apart(tree, boxes, tree, boxes);
    const auto parts = tree.self_parts(512);
    const auto by_boxes = collect<Found>(parts.size(), 1, [&](std::size_t i, Found& out) {
      steering_.check();
      tree.self_overlaps(
          parts[i], [&](std::uint32_t f, std::uint32_t g) { add(f, g, out); }, apart);
      count(out);
    });
    return with_fans(by_boxes, tree.fans(), crowds);
  }

  /// The same with pieces of faces. None if these are hardly less near each other than the faces.
  std::optional<std::vector<FacePair>> run(const PieceSearch& pieces, const HubFans& fans) {
    constexpr std::size_t very_many = threshold(64, 8);
    most_ = std::numeric_limits<std::size_t>::max();
    const std::size_t most_looks = very_many * pieces.pieces();
    std::atomic<std::size_t> looks{0};
    using Faces = std::vector<std::pair<std::uint32_t, std::uint32_t>>;
    const auto parts = pieces.parts(512);
    auto near = joined(collect<Faces>(parts.size(), 1, [&](std::size_t i, Faces& out) {
      steering_.check();
      if (looks > most_looks) return;
      looks += pieces.for_each_pair(parts[i], most_looks, [&](std::uint32_t f, std::uint32_t g) {
        out.push_back(std::minmax(f, g));
      });
      std::sort(out.begin(), out.end());
      out.erase(std::unique(out.begin(), out.end()), out.end());
    }));
    if (looks > most_looks) return {};
    parallel::sort(near.begin(), near.end());
    near.erase(std::unique(near.begin(), near.end()), near.end());
    const auto tested = collect<Found>(near.size(), 256, [&](std::size_t i, Found& out) {
      add(near[i].first, near[i].second, out);
    });
    return with_fans(tested, fans, Crowds::divided);
  }

 private:
  struct Found {
    std::vector<FacePair> pairs;
    std::size_t tests = 0;  // that were not counted yet
  };

  std::vector<FacePair> with_fans(const std::vector<Found>& others, const HubFans& fans,
                                  Crowds crowds) {
    const auto by_directions = collect<Found>(fans.count(), 1, [&](std::size_t i, Found& out) {
      add_pairs_of_fan(fans, i, crowds, out);
    });
    std::vector<FacePair> pairs;
    for (const auto* all : {&others, &by_directions})
      for (const Found& found : *all) append(pairs, found.pairs);
    parallel::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return pairs;
  }

  // Around a corner, or a line of many edges, only boxes of directions tell; and on the line, if
  // edges are to be divided, which corners of some are within edges of others.
  void add_pairs_of_fan(const HubFans& fans, std::size_t fan, Crowds crowds, Found& out) {
    steering_.check();
    const auto for_each_corner = [&](std::uint32_t f, const auto& visit) {
      for_each_outer_corner(facets_, f, visit);
    };
    const auto add_pair = [&](std::uint32_t f, std::uint32_t g) { add(f, g, out); };
    fans.for_each_pair(fan, kernel_.geometry(), for_each_corner, add_pair);
    if (crowds == Crowds::divided)
      fans.for_each_corner_within_edge(fan, kernel_, for_each_corner, add_pair);
    count(out);
  }

  void add(std::uint32_t f, std::uint32_t g, Found& out) {
    constexpr std::size_t counted_at_a_time = 256;
    if (++out.tests == counted_at_a_time) count(out);
    if (f > g) std::swap(f, g);
    if (const auto how = test_(f, g)) out.pairs.push_back({f, g, *how});
  }

  void count(Found& out) {
    if ((tests_ += std::exchange(out.tests, 0)) > most_) throw Crowded();
  }

  const Facets& facets_;
  const Kernel& kernel_;
  const Steering& steering_;
  const PairTest test_;
  std::atomic<std::size_t> tests_{0};
  std::size_t most_ = 0;
};

}  // namespace

std::vector<std::uint8_t> find_convex(const Facets& facets, const Kernel& kernel) {
  std::vector<std::uint8_t> convex(facets.face_count(), 1);
  // Along a slit, too, where a loop goes back on its own line.
  const auto is_bent_inwards = [&](std::size_t f) {
    const int axis = kernel.main_axis(facets.plane[f]);
    const Sign right = -kernel.normal(facets.plane[f], axis);
    for (std::uint32_t c = facets.begin(f); c < facets.end(f); ++c) {
      const std::uint32_t d = facets.next[c];
      const Sign turn = kernel.turn(facets.from(c), facets.from(d), facets.to(d), axis);
      if (turn == right || (turn == Sign::zero && turns_back(facets, c, d, kernel))) return true;
    }
    return false;
  };
  parallel::loop(parallel::Range<std::size_t>(0, convex.size(), 1024), [&](const auto& range) {
    for (std::size_t f = range.begin(); f < range.end(); ++f) {
      if (facets.polygons.is_triangle(f)) continue;
      convex[f] =
          facets.polygons.face_end[f] == facets.polygons.first_loop(f) + 1 && !is_bent_inwards(f);
    }
  });
  return convex;
}

Pairs find_pairs(const Facets& facets, const FacetTree& tree,
                 const std::vector<std::uint8_t>& convex, const Kernel& kernel, Crowds crowds,
                 const Steering& steering) {
  constexpr std::size_t many_of_each = threshold(16, 0);
  constexpr std::size_t no_limit = std::numeric_limits<std::size_t>::max();
  const auto find = [&](const FacetTree& among, Crowds how, std::size_t most) {
    return PairFinder(facets, convex, kernel, steering).run(among, how, most);
  };
  const std::size_t many_pairs = many_of_each * facets.face_count();
  const std::vector<std::uint32_t> hollow = hollow_facets(facets, kernel.geometry());
  // All pairs of few are no more than others.
  const bool may_be_nested = hollow.size() > many_of_each;
  if (crowds == Crowds::in_rows || may_be_nested) {
    try {
      return {find(tree, Crowds::divided, many_pairs), {}};
    } catch (const Crowded&) {
    }
  }
  std::optional<std::vector<FacePair>> by_pieces;
  if (may_be_nested)
    by_pieces =
        PairFinder(facets, convex, kernel, steering)
            .run(PieceSearch(facet_pieces(facets, hollow, kernel), tree.fans().of_polygon()),
                 tree.fans());
  if (by_pieces && by_pieces->size() <= many_pairs) return {*std::move(by_pieces), {}};
  if (crowds == Crowds::in_rows) {
    const FacetTree along_lines = FacetTree::along_crowded_lines(facets, kernel);
    const SpineLines& lines = along_lines.fans().lines();
    if (lines.count() > 0) {
      Pairs found{find(along_lines, Crowds::in_rows, no_limit), {}};
      for (std::uint32_t line = 0; line < lines.count(); ++line)
        found.crowded_lines.push_back(lines.extent(line));
      return found;
    }
  }
  if (by_pieces) return {*std::move(by_pieces), {}};
  return {find(tree, Crowds::divided, no_limit), {}};
}

}  // namespace sectile::arrangement
