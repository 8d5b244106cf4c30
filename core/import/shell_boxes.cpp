#include "import/shell_boxes.h"

#include <numeric>
#include <span>
#include <utility>

#include "search/approximate.h"
#include "search/bundle_order.h"

namespace sectile {
namespace {

std::vector<std::uint32_t> numbers(std::size_t count) {
  std::vector<std::uint32_t> all(count);
  std::iota(all.begin(), all.end(), 0u);
  return all;
}

}  // namespace

ShellBoxes::ShellBoxes(std::vector<Box> boxes,
                       const std::function<std::vector<Vec3>(std::uint32_t)>& corners)
    : boxes_(std::move(boxes)), is_held_(boxes_.size(), 0), holds_any_(boxes_.size(), 0) {
  std::vector<std::uint32_t> all = numbers(boxes_.size());
  if (are_mostly_empty(boxes_)) {
    for (const std::uint32_t s : all) {
      corners_.push_back(corners(s));
      oriented_.push_back(OrientedBox(corners_.back()));
    }
    all = order_in_bundles(oriented_);
  }
  Tree tree(*this, std::move(all));
  find_held(tree);
  find_holding(tree);
}

// Where boxes are mostly empty, the shells come along a curve.
ShellBoxes::Tree::Tree(const ShellBoxes& shells, std::vector<std::uint32_t> order)
    : all_(shells), order_(std::move(order)), place_(order_.size()), is_gone_(order_.size(), 0) {
  std::vector<Box> boxes;
  boxes.reserve(order_.size());
  for (const std::uint32_t s : order_) boxes.push_back(all_.boxes_[s]);
  tree_ = BoxTree(boxes, {}, all_.is_oriented());
  if (tree_.empty()) return;
  if (all_.is_oriented())
    oriented_.emplace(tree_, [&](std::uint32_t i, const auto& add) {
      for (const Vec3& p : all_.corners_[order_[i]]) add(p);
    });
  const auto items = tree_.items(tree_.root());
  for (std::uint32_t i = 0; i < items.size(); ++i) place_[order_[items[i]]] = i;
  for (std::uint32_t level = 0; level < tree_.level_count(); ++level) {
    left_.emplace_back();
    for (std::uint32_t i = 0; i < tree_.node_count(level); ++i)
      left_.back().push_back(tree_.box({level, i}));
  }
}

// If a shell lies in another one, so do its corners. Those at its ends tell most.
template <class Visit>
void ShellBoxes::Tree::around(std::uint32_t shell, const Visit& visit) const {
  struct Around {
    const Tree& tree;
    const Box& own;
    std::array<OrientedBox, 2> ends;
    bool goes_on = true;
    bool operator()(const Box& b) const { return goes_on && b.contains(own); }
    bool operator()(BoxTree::Node n) const {
      return (*this)(tree.left_[n.level][n.index]) &&
             (!tree.oriented_ || has_ends((*tree.oriented_)[n]));
    }
    bool has_ends(const OrientedBox& b) const { return !apart(b, ends[0]) && !apart(b, ends[1]); }
  } around{*this, all_.boxes_[shell], {}};
  if (oriented_) around.ends = all_.ends(shell);
  tree_.query_in_order(
      around, [](BoxTree::Node, BoxTree::Node) { return false; },
      [&](std::uint32_t i) {
        const std::uint32_t t = order_[i];
        if (is_gone_[t] == 0 && (!oriented_ || around.has_ends(all_.oriented_[t])))
          around.goes_on = around.goes_on && visit(t);
      });
}

void ShellBoxes::Tree::remove(std::uint32_t shell) {
  is_gone_[shell] = 1;
  BoxTree::Node n{0, place_[shell] / BoxTree::width};
  for (; n.level < tree_.level_count(); n = {n.level + 1, n.index / BoxTree::width}) {
    Box box;
    if (n.level == 0)
      for (const std::uint32_t i : tree_.items(n)) {
        if (is_gone_[order_[i]] == 0) box.add(all_.boxes_[order_[i]]);
      }
    else
      for (std::uint32_t i = 0; i < tree_.child_count(n); ++i)
        box.add(left_[n.level - 1][BoxTree::child(n, i).index]);
    left_[n.level][n.index] = box;
  }
}

std::array<OrientedBox, 2> ShellBoxes::ends(std::uint32_t shell) const {
  const Vec3& way = oriented_[shell].axis[0];
  const auto [first, last] = std::minmax_element(
      corners_[shell].begin(), corners_[shell].end(), [&](const Vec3& p, const Vec3& q) {
        return approximate::dot(way, p) < approximate::dot(way, q);
      });
  const auto around = [](const Vec3& p) { return OrientedBox(std::span<const Vec3>(&p, 1)); };
  return {around(*first), around(*last)};
}

void ShellBoxes::find_held(const Tree& all) {
  for (std::uint32_t s = 0; s < boxes_.size(); ++s)
    all.around(s, [&](std::uint32_t t) {
      is_held_[s] = t != s ? 1 : 0;
      return t == s;
    });
}

// What is known to hold any is removed, so that in nests of many shells each is found once.
void ShellBoxes::find_holding(Tree& all) {
  for (std::uint32_t s = 0; s < boxes_.size(); ++s) {
    if (is_held_[s] == 0) continue;
    all.around(s, [&](std::uint32_t t) {
      if (t == s) return true;
      holds_any_[t] = 1;
      all.remove(t);
      return true;
    });
  }
}

std::vector<std::uint32_t> ShellBoxes::farthest_first() const {
  std::vector<std::uint32_t> order = numbers(boxes_.size());
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t s, std::uint32_t t) {
    return boxes_[s].high[0] > boxes_[t].high[0];
  });
  return order;
}

}  // namespace sectile
