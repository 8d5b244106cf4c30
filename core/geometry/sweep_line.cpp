#include "geometry/sweep_line.h"

namespace sectile {

std::uint32_t SweepLine::next_priority() {
  random_ ^= random_ << 13;
  random_ ^= random_ >> 17;
  random_ ^= random_ << 5;
  return random_;
}

void SweepLine::link(std::uint32_t below, std::uint32_t above) {
  if (below == none) {
    lowest_ = above;
  } else {
    nodes_[below].above = above;
  }
  if (above != none) nodes_[above].below = below;
}

void SweepLine::set_child(std::uint32_t parent, std::uint32_t old_child, std::uint32_t new_child) {
  if (parent == none) {
    root_ = new_child;
  } else if (nodes_[parent].left == old_child) {
    nodes_[parent].left = new_child;
  } else {
    nodes_[parent].right = new_child;
  }
  if (new_child != none) nodes_[new_child].parent = parent;
}

void SweepLine::rotate_up(std::uint32_t edge) {
  Node& node = nodes_[edge];
  const std::uint32_t parent = node.parent;
  Node& old_top = nodes_[parent];
  set_child(old_top.parent, parent, edge);
  std::uint32_t& inner = old_top.left == edge ? node.right : node.left;
  std::uint32_t& outer = old_top.left == edge ? old_top.left : old_top.right;
  outer = inner;
  if (inner != none) nodes_[inner].parent = parent;
  inner = parent;
  old_top.parent = edge;
}

void SweepLine::insert_above(std::uint32_t below, std::uint32_t edge) {
  const std::uint32_t above = below == none ? lowest_ : nodes_[below].above;
  Node& node = nodes_[edge];
  node = Node{};
  node.priority = next_priority();
  // Of two neighbours one has a free place on the side of the other.
  if (below != none && nodes_[below].right == none) {
    nodes_[below].right = edge;
    node.parent = below;
  } else if (above != none) {
    nodes_[above].left = edge;
    node.parent = above;
  } else {
    root_ = edge;
  }
  link(below, edge);
  link(edge, above);
  while (node.parent != none && nodes_[node.parent].priority < node.priority) rotate_up(edge);
}

void SweepLine::replace(std::uint32_t old_edge, std::uint32_t new_edge) {
  const Node node = nodes_[old_edge];
  nodes_[new_edge] = node;
  set_child(node.parent, old_edge, new_edge);
  if (node.left != none) nodes_[node.left].parent = new_edge;
  if (node.right != none) nodes_[node.right].parent = new_edge;
  link(node.below, new_edge);
  link(new_edge, node.above);
}

void SweepLine::remove(std::uint32_t edge) {
  Node& node = nodes_[edge];
  while (node.left != none && node.right != none) {
    const bool left = nodes_[node.left].priority > nodes_[node.right].priority;
    rotate_up(left ? node.left : node.right);
  }
  set_child(node.parent, edge, node.left != none ? node.left : node.right);
  link(node.below, node.above);
}

}  // namespace sectile
