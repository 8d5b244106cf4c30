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

// The boxes of so many nodes above others.
std::vector<FourBoxes> in_fours(std::size_t count, const auto& box) {
  std::vector<FourBoxes> fours((count + BoxTree::width - 1) / BoxTree::width);
  for_range(fours.size(), [&](std::size_t from, std::size_t to) {
    for (std::size_t i = from * BoxTree::width; i < std::min(count, to * BoxTree::width); ++i)
      fours[i / BoxTree::width].set(i % BoxTree::width, box(i));
  });
  return fours;
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
  if (!group.empty()) put_groups_together(items_, boxes, group);
  boxes_ = in_fours(boxes.size(), [&](std::size_t i) -> const Box& { return boxes[items_[i]]; });
  first_ = {0, static_cast<std::uint32_t>(boxes_.size())};
  while (node_count(level_count() - 1) > 1) {
    const std::uint32_t from = first_[level_count() - 1];
    const std::vector<FourBoxes> above = in_fours(
        node_count(level_count() - 1), [&](std::size_t i) { return boxes_[from + i].all(); });
    boxes_.insert(boxes_.end(), above.begin(), above.end());
    first_.push_back(static_cast<std::uint32_t>(boxes_.size()));
  }
  bounds_ = boxes_.back().all();
  if (!group.empty()) build_groups(group);
}

void BoxTree::build_groups(const std::vector<std::uint32_t>& group) {
  item_groups_.reserve(items_.size());
  for (const std::uint32_t item : items_) item_groups_.push_back(group[item]);
  groups_.reserve(boxes_.size());
  const auto add_common = [&](const std::vector<std::uint32_t>& of, std::size_t from,
                              std::size_t to) {
    const std::uint32_t first = of[from];
    while (from < to && of[from] == first) ++from;
    groups_.push_back(from == to ? first : no_group);
  };
  for (std::uint32_t leaf = 0; leaf < node_count(0); ++leaf)
    add_common(item_groups_, leaf * width,
               std::min<std::size_t>(item_groups_.size(), (leaf + 1) * width));
  for (std::uint32_t level = 1; level < level_count(); ++level)
    for (std::uint32_t n = 0; n < node_count(level); ++n) {
      const std::uint32_t from = first_[level - 1] + n * width;
      add_common(groups_, from, from + child_count({level, n}));
    }
}

std::vector<BoxTree::SelfPart> BoxTree::self_parts(std::size_t least) const {
  std::vector<SelfPart> parts;
  if (empty()) return parts;
  parts.push_back(SelfPart(root(), root()));
  for (std::uint32_t level = root().level; level > 0 && parts.size() < least; --level) {
    std::vector<SelfPart> finer;
    for (const SelfPart& part : parts)
      for (std::uint32_t i = 0; i < child_count(part.p); ++i)
        for (std::uint32_t j = part.p.index == part.q.index ? i : 0; j < child_count(part.q); ++j) {
          const Node p = child(part.p, i), q = child(part.q, j);
          if (box(p).overlaps(box(q))) finer.push_back(SelfPart(p, q));
        }
    parts = std::move(finer);
  }
  return parts;
}

}  // namespace sectile
