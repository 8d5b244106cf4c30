#include "search/box_tree.h"

#include <numeric>

#include "numbers/threshold.h"
#include "parallel/parallel.h"
#include "parallel/sort.h"
#include "search/hilbert.h"

namespace sectile {
namespace {

constexpr std::size_t parallel_from = threshold(8192, 8);

template <class Body>
void for_range(std::size_t count, const Body& body) {
  if (count < parallel_from) {
    body(std::size_t(0), count);
  } else {
    parallel::loop(parallel::Range<std::size_t>(0, count, 2048),
                   [&](const auto& range) { body(range.begin(), range.end()); });
  }
}

std::vector<Box> pairs_above(const std::vector<Box>& below) {
  std::vector<Box> level((below.size() + 1) / 2);
  for_range(level.size(), [&](std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i) {
      level[i] = below[2 * i];
      if (2 * i + 1 < below.size()) level[i].add(below[2 * i + 1]);
    }
  });
  return level;
}

std::vector<std::uint32_t> as_given(std::size_t count) {
  std::vector<std::uint32_t> items(count);
  std::iota(items.begin(), items.end(), 0u);
  return items;
}

std::vector<std::uint32_t> sorted_along_curve(const std::vector<Box>& boxes) {
  Box all;
  for (const Box& b : boxes) all.add(b);
  const HilbertCurve curve(all);
  std::vector<std::uint64_t> keys(boxes.size());
  for_range(boxes.size(), [&](std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i) keys[i] = std::uint64_t(curve(boxes[i])) << 32 | i;
  });
  if (keys.size() < parallel_from) {
    std::sort(keys.begin(), keys.end());
  } else {
    parallel::sort(keys.begin(), keys.end());
  }
  std::vector<std::uint32_t> items(boxes.size());
  for (std::size_t i = 0; i < items.size(); ++i) items[i] = static_cast<std::uint32_t>(keys[i]);
  return items;
}

// Puts each group where the box around it is on the curve.
void put_groups_together(std::vector<std::uint32_t>& items, const std::vector<Box>& boxes,
                         const std::vector<std::uint32_t>& group) {
  Box all;
  std::uint32_t groups = 0;
  for (const std::uint32_t g : group)
    if (g != BoxTree::no_group) groups = std::max(groups, g + 1);
  std::vector<Box> of_group(groups);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    all.add(boxes[i]);
    if (group[i] != BoxTree::no_group) of_group[group[i]].add(boxes[i]);
  }
  const HilbertCurve curve(all);
  std::vector<std::uint64_t> keys(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const Box& box = group[i] != BoxTree::no_group ? of_group[group[i]] : boxes[i];
    keys[i] = std::uint64_t(curve(box)) << 32 | group[i];
  }
  std::stable_sort(items.begin(), items.end(),
                   [&](std::uint32_t i, std::uint32_t j) { return keys[i] < keys[j]; });
}

}  // namespace

BoxTree::BoxTree(const std::vector<Box>& boxes, const std::vector<std::uint32_t>& group,
                 bool along_curve) {
  if (boxes.empty()) return;
  items_ = along_curve ? as_given(boxes.size()) : sorted_along_curve(boxes);
  if (!group.empty() && !along_curve) put_groups_together(items_, boxes, group);
  std::vector<Box> leaves((boxes.size() + leaf_size - 1) / leaf_size);
  leaf_boxes_.resize(leaves.size());
  for_range(leaves.size(), [&](std::size_t from, std::size_t to) {
    for (std::size_t leaf = from; leaf < to; ++leaf) {
      const auto [begin, end] = range(static_cast<std::uint32_t>(leaf));
      for (std::uint32_t i = begin; i < end; ++i) {
        const Box& box = boxes[items_[i]];
        leaf_boxes_[leaf].set(i - begin, box);
        leaves[leaf].add(box);
      }
    }
  });
  levels_.push_back(std::move(leaves));
  while (levels_.back().size() > 1) levels_.push_back(pairs_above(levels_.back()));
  if (!group.empty()) build_groups(group);
}

void BoxTree::build_groups(const std::vector<std::uint32_t>& group) {
  item_groups_.reserve(items_.size());
  for (const std::uint32_t item : items_) item_groups_.push_back(group[item]);
  const auto common = [](std::uint32_t g, std::uint32_t h) { return g == h ? g : no_group; };
  std::vector<std::uint32_t> leaves(levels_[0].size());
  for (std::uint32_t leaf = 0; leaf < leaves.size(); ++leaf) {
    const auto [begin, end] = range(leaf);
    leaves[leaf] = item_groups_[begin];
    for (std::uint32_t i = begin; i < end; ++i)
      leaves[leaf] = common(leaves[leaf], item_groups_[i]);
  }
  group_levels_.push_back(std::move(leaves));
  while (group_levels_.size() < levels_.size()) {
    const std::vector<std::uint32_t>& below = group_levels_.back();
    std::vector<std::uint32_t> level((below.size() + 1) / 2);
    for (std::size_t i = 0; i < level.size(); ++i)
      level[i] = common(below[2 * i], below[std::min(2 * i + 1, below.size() - 1)]);
    group_levels_.push_back(std::move(level));
  }
}

std::vector<BoxTree::SelfPart> BoxTree::self_parts(std::size_t least) const {
  std::vector<SelfPart> parts;
  if (empty()) return parts;
  parts.push_back(SelfPart(root(), root()));
  for (std::uint32_t level = root().level; level > 0 && parts.size() < least; --level) {
    std::vector<SelfPart> finer;
    for (const SelfPart& part : parts)
      for (std::uint32_t i = 0; i < 2; ++i) {
        const bool same = part.p.index == part.q.index;
        if (i == 1 && !has_second_child(part.p)) continue;
        for (std::uint32_t j = same ? i : 0; j < 2; ++j) {
          if (j == 1 && !has_second_child(part.q)) continue;
          const Node p = child(part.p, i), q = child(part.q, j);
          if (box(p).overlaps(box(q))) finer.push_back(SelfPart(p, q));
        }
      }
    parts = std::move(finer);
  }
  return parts;
}

}  // namespace sectile
