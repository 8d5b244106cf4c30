#include "import/shell_boxes.h"

#include <numeric>
#include <span>
#include <utility>

#include "search/approximate.h"
#include "search/bundle_order.h"

namespace sectile {
namespace {

bool contains(const Box& outer, const Box& inner) {
  for (int k = 0; k < 3; ++k)
    if (!(outer.low[k] <= inner.low[k] && inner.high[k] <= outer.high[k])) return false;
  return true;
}

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
  find_holding(std::move(tree));
}

// Where boxes are mostly empty, the shells come along a curve.
ShellBoxes::Tree::Tree(const ShellBoxes& shells, std::vector<std::uint32_t> some)
    : all_(&shells), some_(std::move(some)) {
  std::vector<Box> boxes;
  boxes.reserve(some_.size());
  for (const std::uint32_t s : some_) boxes.push_back(all_->boxes_[s]);
  tree_ = BoxTree(boxes, {}, all_->is_oriented());
  if (all_->is_oriented() && !some_.empty())
    oriented_.emplace_back(tree_, [&](std::uint32_t i, const auto& add) {
      for (const Vec3& p : all_->corners_[some_[i]]) add(p);
    });
}

// If a shell lies in another one, so do its corners. Those at its ends tell most.
template <class Visit>
void ShellBoxes::Tree::around(std::uint32_t shell, const Visit& visit) const {
  const Box& own = all_->boxes_[shell];
  bool goes_on = true;
  if (oriented_.empty()) {
    tree_.query([&](const Box& b) { return goes_on && contains(b, own); },
                [&](std::uint32_t i) { goes_on = goes_on && visit(some_[i]); });
    return;
  }
  struct Around {
    const Tree& tree;
    const Box& own;
    const std::array<OrientedBox, 2> ends;
    const bool& goes_on;
    bool operator()(const Box& b) const { return goes_on && contains(b, own); }
    bool operator()(BoxTree::Node n) const {
      return (*this)(tree.tree_.box(n)) && has_ends(tree.oriented_.front()[n]);
    }
    bool has_ends(const OrientedBox& b) const { return !apart(b, ends[0]) && !apart(b, ends[1]); }
  };
  const Around around{*this, own, all_->ends(shell), goes_on};
  tree_.query_in_order(
      around, [](BoxTree::Node, BoxTree::Node) { return false; },
      [&](std::uint32_t i) {
        if (around.has_ends(all_->oriented_[some_[i]])) goes_on = goes_on && visit(some_[i]);
      });
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

// The tree of those that are not known to hold any is made anew as soon as known ones were met in
// it as often as it has members: so nests of many shells take no longer than others.
void ShellBoxes::find_holding(Tree tree) {
  std::size_t met = 0;
  for (std::uint32_t s = 0; s < boxes_.size(); ++s) {
    if (is_held_[s] == 0) continue;
    tree.around(s, [&](std::uint32_t t) {
      met += holds_any_[t];
      if (t != s) holds_any_[t] = 1;
      return true;
    });
    if (met <= tree.size()) continue;
    std::vector<std::uint32_t> unknown = tree.shells();
    std::erase_if(unknown, [&](std::uint32_t t) { return holds_any_[t] != 0; });
    tree = Tree(*this, std::move(unknown));
    met = 0;
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
