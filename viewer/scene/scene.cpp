#include "scene/scene.h"

#include <algorithm>
#include <set>
#include <stdexcept>

#include "scene/exact_moves.h"
#include "scene/transforms.h"

namespace sectile::viewer {

namespace {

[[noreturn]] void fail(const std::string& message) {
  throw std::invalid_argument(message);
}

// "Block 2" without its number.
std::string stem_of(const std::string& name) {
  const std::size_t end = name.find_last_not_of("0123456789");
  const bool numbered =
      end != std::string::npos && end + 1 < name.size() && name[end] == ' ' && end > 0;
  return numbered ? name.substr(0, end) : name;
}

void require_room(const Node& parent) {
  if (std::holds_alternative<SplitNode>(parent.what) && !parent.children.empty())
    fail("\"" + parent.name + "\" cuts one solid only; group several first.");
  if (std::holds_alternative<Primitive>(parent.what) ||
      std::holds_alternative<Imported>(parent.what))
    fail("\"" + parent.name + "\" is a single solid: nothing can be put into it.");
}

}  // namespace

const Node* Scene::find(NodeId id) const {
  const auto found =
      std::lower_bound(nodes_.begin(), nodes_.end(), id,
                       [](const auto& node, NodeId wanted) { return node->id < wanted; });
  return found != nodes_.end() && (*found)->id == id ? found->get() : nullptr;
}

const Node& Scene::at(NodeId id) const {
  const Node* node = find(id);
  if (!node) throw std::out_of_range("The scene has no node " + std::to_string(id) + ".");
  return *node;
}

std::vector<NodeId> Scene::subtree(NodeId id) const {
  std::vector<NodeId> order, open{id};
  while (!open.empty()) {
    const Node& node = at(open.back());
    open.pop_back();
    order.push_back(node.id);
    open.insert(open.end(), node.children.rbegin(), node.children.rend());
  }
  return order;
}

std::vector<NodeId> Scene::in_order() const {
  std::vector<NodeId> order;
  for (const NodeId root : roots_) {
    const std::vector<NodeId> below = subtree(root);
    order.insert(order.end(), below.begin(), below.end());
  }
  return order;
}

bool Scene::is_below(NodeId id, NodeId ancestor) const {
  for (const Node* node = &at(id); node; node = find(node->parent))
    if (node->id == ancestor) return true;
  return false;
}

std::vector<NodeId> Scene::topmost(const std::vector<NodeId>& ids) const {
  const std::set<NodeId> chosen(ids.begin(), ids.end());
  std::vector<NodeId> kept;
  for (const NodeId id : ids) {
    bool covered = std::find(kept.begin(), kept.end(), id) != kept.end();
    for (const Node* above = find(at(id).parent); above && !covered; above = find(above->parent))
      covered = chosen.contains(above->id);
    if (!covered) kept.push_back(id);
  }
  return kept;
}

Transform Scene::world(NodeId id) const {
  const Node& node = at(id);
  const Transform own = node.placement.transform();
  return node.parent == 0 ? own : world(node.parent) * own;
}

Transform Scene::world_of_parent(NodeId id) const {
  const NodeId parent = at(id).parent;
  return parent == 0 ? Transform() : world(parent);
}

ExactTransform Scene::exact_world(NodeId id) const {
  return exact_world_of_parent(id) * at(id).placement.exact();
}

ExactTransform Scene::exact_world_of_parent(NodeId id) const {
  const NodeId parent = at(id).parent;
  return parent == 0 ? ExactTransform() : exact_world(parent);
}

bool Scene::is_shown(NodeId id) const {
  for (const Node* node = &at(id); node; node = find(node->parent))
    if (!node->visible) return false;
  return true;
}

std::string Scene::free_name(const std::string& wanted) const {
  std::set<std::string> taken;
  for (const auto& node : nodes_) taken.insert(node->name);
  if (!taken.contains(wanted)) return wanted;
  const std::string stem = stem_of(wanted);
  for (std::size_t number = 2;; ++number) {
    std::string name = stem + " " + std::to_string(number);
    if (!taken.contains(name)) return name;
  }
}

Node& Scene::writable(NodeId id) {
  at(id);
  const auto found =
      std::lower_bound(nodes_.begin(), nodes_.end(), id,
                       [](const auto& node, NodeId wanted) { return node->id < wanted; });
  // Always a copy: whether another scene holds the node cannot be asked safely across threads.
  const auto copy = std::make_shared<Node>(**found);
  *found = copy;
  return *copy;
}

Node& Scene::edit(NodeId id) {
  return writable(id);
}

std::vector<NodeId>& Scene::siblings(NodeId parent) {
  return parent == 0 ? roots_ : writable(parent).children;
}

std::size_t Scene::place_of(const Node& node) const {
  const auto& list = node.parent == 0 ? roots_ : at(node.parent).children;
  return static_cast<std::size_t>(std::find(list.begin(), list.end(), node.id) - list.begin());
}

NodeId Scene::add(Node node, NodeId parent, std::size_t at_place) {
  if (parent != 0) require_room(at(parent));
  node.name = free_name(node.name.empty() ? default_name(node) : node.name);
  node.id = next_++;
  node.parent = parent;
  node.children.clear();
  const NodeId id = node.id;
  nodes_.push_back(std::make_shared<Node>(std::move(node)));
  auto& list = siblings(parent);
  list.insert(list.begin() + static_cast<std::ptrdiff_t>(std::min(at_place, list.size())), id);
  return id;
}

void Scene::rename(NodeId id, const std::string& name) {
  if (name.empty()) fail("A name needs at least one character.");
  if (at(id).name == name) return;
  std::string free = free_name(name);
  writable(id).name = std::move(free);
}

void Scene::remove(NodeId id) {
  const std::vector<NodeId> below = subtree(id);
  const std::set<NodeId> gone(below.begin(), below.end());
  std::erase(siblings(at(id).parent), id);
  std::erase_if(nodes_, [&](const auto& node) { return gone.contains(node->id); });
}

NodeId Scene::copy_below(NodeId id, NodeId parent, std::size_t at_place) {
  const Node original = at(id);
  const NodeId copy = add(original, parent, at_place);
  for (const NodeId child : original.children) copy_below(child, copy, SIZE_MAX);
  return copy;
}

NodeId Scene::duplicate(NodeId id) {
  const Node& node = at(id);
  if (node.parent != 0) require_room(at(node.parent));
  return copy_below(id, node.parent, place_of(node) + 1);
}

void Scene::move(NodeId id, NodeId parent, std::size_t at_place) {
  const Node& node = at(id);
  if (parent != 0 && is_below(parent, id)) fail("\"" + node.name + "\" cannot be put into itself.");
  const NodeId old_parent = node.parent;
  if (parent != old_parent) {
    if (parent != 0) require_room(at(parent));
    const ExactTransform from = exact_world_of_parent(id);
    const ExactTransform to = parent == 0 ? ExactTransform() : exact_world(parent);
    if (!(from == to)) {
      const Placement placed = carried_over(node.placement, from, to);
      writable(id).placement = placed;
    }
  } else if (place_of(node) < at_place && at_place != SIZE_MAX) {
    --at_place;
  }
  std::erase(siblings(old_parent), id);
  auto& list = siblings(parent);
  list.insert(list.begin() + static_cast<std::ptrdiff_t>(std::min(at_place, list.size())), id);
  writable(id).parent = parent;
}

NodeId Scene::gather(Node node, const std::vector<NodeId>& members) {
  const std::vector<NodeId> chosen = topmost(members);
  if (chosen.empty()) fail("Nothing is selected.");
  const Node& first = at(chosen.front());
  // In the only place of a cut, the new node takes the place of its member.
  const bool replaces =
      first.parent != 0 && std::holds_alternative<SplitNode>(at(first.parent).what);
  const NodeId parent = first.parent;
  const std::size_t place = place_of(first);
  const NodeId made = add(std::move(node), replaces ? 0 : parent, replaces ? SIZE_MAX : place);
  if (replaces) writable(made).placement = Placement::of(exact_world(parent));
  for (const NodeId id : chosen) move(id, made);
  if (replaces) move(made, parent);
  return made;
}

NodeId Scene::combine(const std::vector<NodeId>& operands, Operation operation) {
  if (topmost(operands).size() < 2) fail("Select two solids or more to combine.");
  Node node;
  node.what = BooleanNode{operation};
  return gather(std::move(node), operands);
}

NodeId Scene::group(const std::vector<NodeId>& members) {
  Node node;
  node.what = Group();
  return gather(std::move(node), members);
}

void Scene::ungroup(NodeId id) {
  const Node group = at(id);
  if (!std::holds_alternative<Group>(group.what)) fail("\"" + group.name + "\" is not a group.");
  if (group.parent != 0 && std::holds_alternative<SplitNode>(at(group.parent).what) &&
      group.children.size() > 1)
    fail("\"" + at(group.parent).name + "\" cuts one solid only; its group must stay.");
  std::size_t place = place_of(group);
  const bool is_cut = group.parent != 0 && std::holds_alternative<SplitNode>(at(group.parent).what);
  // A cut has room for the member only when the group is gone.
  for (const NodeId child : group.children)
    is_cut ? move(child, 0) : move(child, group.parent, ++place);
  remove(id);
  if (is_cut)
    for (const NodeId child : group.children) move(child, group.parent);
}

std::pair<NodeId, NodeId> Scene::split(NodeId id, const HalfSpace& plane) {
  if (plane.a == 0 && plane.b == 0 && plane.c == 0) fail("The plane has no direction.");
  const Node& node = at(id);
  const NodeId parent = node.parent;
  const std::size_t place = place_of(node);
  const std::string name = node.name;
  if (parent != 0) require_room(at(parent));
  const HalfSpace own = pulled_back(plane, world_of_parent(id));
  const NodeId copy = duplicate(id);
  const auto make = [&](bool above, NodeId whole, std::size_t where) {
    Node half;
    half.name = name + (above ? " above" : " below");
    half.what = SplitNode{own, above};
    const NodeId made = add(std::move(half), parent, where);
    move(whole, made);
    return made;
  };
  const NodeId above = make(true, id, place);
  return {above, make(false, copy, place + 1)};
}

Scene Scene::from_nodes(std::vector<Node> nodes, std::vector<NodeId> roots) {
  Scene made;
  std::sort(nodes.begin(), nodes.end(), [](const Node& a, const Node& b) { return a.id < b.id; });
  for (Node& node : nodes) {
    if (node.id == 0 || node.id == UINT32_MAX || made.next_ > node.id)
      fail("Node ids must be different and positive.");
    made.next_ = node.id + 1;
    made.nodes_.push_back(std::make_shared<Node>(std::move(node)));
  }
  made.roots_ = std::move(roots);
  std::set<NodeId> seen;
  const auto visit = [&](const auto& self, NodeId parent, const std::vector<NodeId>& list) -> void {
    for (const NodeId id : list) {
      const Node* node = made.find(id);
      if (!node || node->parent != parent || !seen.insert(id).second)
        fail("Node " + std::to_string(id) + " is not linked into the tree once.");
      self(self, id, node->children);
    }
  };
  visit(visit, 0, made.roots_);
  if (seen.size() != made.nodes_.size()) fail("Some nodes hang nowhere in the tree.");
  return made;
}

bool operator==(const Scene& a, const Scene& b) {
  return a.roots_ == b.roots_ &&
         std::equal(a.nodes_.begin(), a.nodes_.end(), b.nodes_.begin(), b.nodes_.end(),
                    [](const auto& p, const auto& q) { return p == q || *p == *q; });
}

}  // namespace sectile::viewer
