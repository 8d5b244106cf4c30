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

constexpr std::size_t no_limit = std::numeric_limits<std::size_t>::max();

class PairFinder {
 public:
  PairFinder(const Facets& facets, const std::vector<std::uint8_t>& convex, const Kernel& kernel,
             const Steering& steering)
      : facets_(facets), kernel_(kernel), steering_(steering), test_(facets, convex, kernel) {}

  std::vector<FacePair> run(const FacetTree& tree, Crowds crowds) {
    return *run(tree, crowds, no_limit);
  }
  /// None if more than so many have to be tested.
  std::optional<std::vector<FacePair>> run(const FacetTree& tree, Crowds crowds, std::size_t most) {
    begin(most);
    const std::optional<OrientedTree> oriented =
        oriented_tree_of(facets_, tree, kernel_.geometry());
    const OrientedTree* boxes = oriented ? &*oriented : nullptr;
    const Apart apart(tree, boxes, too_many_);
    const auto parts = tree.self_parts(512);
    const auto by_boxes = collect<Found>(parts.size(), 1, [&](std::size_t i, Found& out) {
      steering_.check();
      tree.self_overlaps(
          parts[i], [&](std::uint32_t f, std::uint32_t g) { add(f, g, out); }, apart);
      count(out);
    });
    return with_fans(by_boxes, tree.fans(), crowds);
  }

  /// With pieces of faces. None if these are hardly less near each other than the faces.
  std::optional<std::vector<FacePair>> run(const PieceSearch& pieces, const HubFans& fans) {
    constexpr std::size_t very_many = threshold(64, 8);
    begin(no_limit);
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

  // Of what comes when there are too many, everything is.
  class Apart : public OrientedApart {
   public:
    Apart(const FacetTree& tree, const OrientedTree* boxes, const std::atomic<bool>& too_many)
        : OrientedApart(tree, boxes, tree, boxes), too_many_(too_many) {}
    bool nodes(BoxTree::Node p, BoxTree::Node q) const {
      return too_many_.load(std::memory_order_relaxed) || OrientedApart::nodes(p, q);
    }

   private:
    const std::atomic<bool>& too_many_;
  };

  void begin(std::size_t most) {
    most_ = most;
    tests_ = 0;
    too_many_ = false;
  }

  std::optional<std::vector<FacePair>> with_fans(const std::vector<Found>& others,
                                                 const HubFans& fans, Crowds crowds) {
    const auto by_directions = collect<Found>(fans.count(), 1, [&](std::size_t i, Found& out) {
      add_pairs_of_fan(fans, i, crowds, out);
    });
    if (too_many_) return {};
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
    if (too_many_) return;
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
    if (too_many_.load(std::memory_order_relaxed)) return;
    if (f > g) std::swap(f, g);
    if (const auto how = test_(f, g)) out.pairs.push_back({f, g, *how});
  }

  void count(Found& out) {
    if ((tests_ += std::exchange(out.tests, 0)) > most_) too_many_ = true;
  }

  const Facets& facets_;
  const Kernel& kernel_;
  const Steering& steering_;
  const PairTest test_;
  std::atomic<std::size_t> tests_{0};
  std::atomic<bool> too_many_{false};
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
  constexpr std::size_t many_of_each = threshold(16, 0), few = threshold(1 << 12, 0);
  const std::size_t many = std::max(many_of_each * facets.face_count(), few);
  PairFinder finder(facets, convex, kernel, steering);
  if (auto all = finder.run(tree, Crowds::divided, many)) return {*std::move(all), {}, {}};
  const CrossingFans crossings = crossing_fans(facets, kernel);
  std::optional<FacetTree> beside_crossings;
  if (crossings.count() > 0) beside_crossings.emplace(facets, kernel, crossings);
  const FacetTree& beside = beside_crossings ? *beside_crossings : tree;
  Pairs found{{}, {}, crowded_points(crossings)};
  std::optional<std::vector<FacePair>> by_pieces;
  if (const auto hollow = hollow_facets(facets, kernel.geometry()); hollow.size() > many_of_each)
    by_pieces =
        finder.run(PieceSearch(facet_pieces(facets, hollow, kernel), beside.fans().of_polygon()),
                   beside.fans());
  if (crowds == Crowds::in_rows && !(by_pieces && by_pieces->size() <= many)) {
    const FacetTree along_lines = FacetTree::along_crowded_lines(facets, kernel, crossings);
    const SpineLines& lines = along_lines.fans().lines();
    for (std::uint32_t line = 0; line < lines.count(); ++line)
      found.crowded_lines.push_back(lines.extent(line));
    if (lines.count() > 0) {
      found.pairs = finder.run(along_lines, Crowds::in_rows);
      return found;
    }
  }
  found.pairs = by_pieces ? *std::move(by_pieces) : finder.run(beside, Crowds::divided);
  return found;
}

}  // namespace sectile::arrangement
