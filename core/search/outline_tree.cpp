#include "search/outline_tree.h"

#include "numbers/threshold.h"
#include "search/bundle_order.h"
#include "search/curve_order.h"

namespace sectile {
namespace {

// The numbers of the loops so that those that follow each other are near each other.
std::vector<std::uint32_t> order_of_loops(std::span<const Vec3> corners,
                                          std::span<const std::uint32_t> loop_ends,
                                          const Box& all) {
  constexpr std::size_t few_loops = threshold(4, 1);
  std::vector<std::uint32_t> order;
  order.reserve(loop_ends.size());
  if (loop_ends.size() <= few_loops) {
    for (std::uint32_t loop = 0; loop < loop_ends.size(); ++loop) order.push_back(loop);
    return order;
  }
  const auto first_corner = [&](std::size_t loop) {
    return corners[loop > 0 ? loop_ends[loop - 1] : 0];
  };
  return numbers_of(keys_along_curve(loop_ends.size(), all, first_corner));
}

std::vector<std::uint32_t> order_by_place(std::span<const StripTree::Edge> edges) {
  std::vector<OrientedBox> boxes;
  boxes.reserve(edges.size());
  for (const StripTree::Edge& e : edges) {
    const Vec3 ends[] = {e.from, e.to};
    boxes.emplace_back(ends);
  }
  return order_in_bundles(boxes);
}

}  // namespace

// The edges loop after loop.
struct OutlineTree::Loops {
  std::vector<std::uint32_t> order, loop_begin;
  std::vector<StripTree::Edge> edges;
  Target all;

  Loops(std::span<const Vec3> corners, std::span<const std::uint32_t> loop_ends) : all(corners) {
    order.reserve(corners.size());
    loop_begin.reserve(corners.size());
    edges.reserve(corners.size());
    for (const std::uint32_t loop : order_of_loops(corners, loop_ends, all.box)) {
      const std::uint32_t first = loop > 0 ? loop_ends[loop - 1] : 0, end = loop_ends[loop];
      loop_begin.resize(loop_begin.size() + (end - first),
                        static_cast<std::uint32_t>(order.size()));
      for (std::uint32_t c = first; c < end; ++c) {
        order.push_back(c);
        edges.push_back({corners[c], corners[c + 1 < end ? c + 1 : first]});
      }
    }
  }
};

OutlineTree::OutlineTree(std::span<const Vec3> corners, std::span<const std::uint32_t> loop_ends,
                         int axis)
    : OutlineTree(Loops(corners, loop_ends), axis) {}

OutlineTree::OutlineTree(const Loops& loops, int axis)
    : as_target_(loops.all),
      stretches_{loops.order, StripTree(loops.edges, axis)},
      loop_begin_(loops.loop_begin) {
  if (!stretches_.tree.is_crowded()) return;
  std::vector<std::uint32_t> order;
  std::vector<StripTree::Edge> edges;
  order.reserve(loops.edges.size());
  edges.reserve(loops.edges.size());
  for (const std::uint32_t e : order_by_place(loops.edges)) {
    order.push_back(loops.order[e]);
    edges.push_back(loops.edges[e]);
  }
  by_place_ = Edges{std::move(order), StripTree(edges, axis)};
}

}  // namespace sectile
