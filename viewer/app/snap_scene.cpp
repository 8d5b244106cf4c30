#include "app/snap_scene.h"

#include <algorithm>
#include <cmath>

#include "scene/transforms.h"

namespace sectile::viewer {
namespace {

bool computes(const Node& node) {
  return std::holds_alternative<BooleanNode>(node.what) ||
         std::holds_alternative<SplitNode>(node.what) || std::holds_alternative<Pattern>(node.what);
}

/// The nearest operation above all of the nodes; 0 if there is none, or not the same.
NodeId operation_above(const Scene& scene, const Selection& nodes) {
  std::optional<NodeId> common;
  for (const NodeId id : nodes) {
    const Node* node = scene.find(scene.at(id).parent);
    while (node && !computes(*node)) node = scene.find(node->parent);
    const NodeId found = node ? node->id : 0;
    if (common && *common != found) return 0;
    common = found;
  }
  return common.value_or(0);
}

/// From a node's coordinates to those of a node above it (0: the world's).
ExactTransform way_up(const Scene& scene, NodeId id, NodeId top) {
  if (id == top) return {};
  const Node& node = scene.at(id);
  return way_up(scene, node.parent, top) * node.placement.exact();
}

bool come_near(const Bounds& a, const Bounds& b, double reach) {
  return glm::all(glm::lessThanEqual(a.low - reach, b.high)) &&
         glm::all(glm::lessThanEqual(b.low - reach, a.high));
}

double average_scale(const Transform& transform) {
  return std::cbrt(std::abs(glm::determinant(glm::dmat3(matrix_of(transform)))));
}

}  // namespace

std::shared_ptr<const SnapTargets> KnownTargets::of(const Solid& inside,
                                                    const ExactTransform& place) {
  const Transform rounded = place.nearest();
  Known& known = known_[{inside.data().get(), rounded.m}];
  if (!known.targets || !(known.targets->place() == place))
    known = {inside, std::make_shared<const SnapTargets>(snap_features(inside, rounded), place)};
  known.used = true;
  return known.targets;
}

void KnownTargets::forget_unused() {
  std::erase_if(known_, [](const auto& item) { return !item.second.used; });
  for (auto& [key, known] : known_) known.used = false;
}

SnapScene::SnapScene(const Scene& scene, const Results& results, const Selection& nodes,
                     KnownTargets& known)
    : known_(known), nodes_(nodes), operation_(operation_above(scene, nodes)) {
  if (operation_ != 0) frame_ = scene.world(operation_);
  into_frame_ =
      operation_ != 0 ? scene.exact_world(operation_).inverse() : std::optional(ExactTransform());
  known_.forget_unused();
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    parents_.push_back(way_up(scene, scene.at(nodes[i]).parent, operation_));
    bounds_.add(results.bounds_of(scene, nodes[i]));
    add_dragged(scene, results, nodes[i], i, {});
  }
  for (const NodeId root : scene.roots()) add_others(scene, results, root, operation_ == 0);
}

void SnapScene::add_dragged(const Scene& scene, const Results& results, NodeId id, std::size_t node,
                            const ExactTransform& way) {
  if (const Solid* inside = results.inside(id)) {
    const ExactTransform place = parents_[node] * scene.at(nodes_[node]).placement.exact() * way;
    dragged_.add(snap_features(*inside, place.nearest()),
                 static_cast<std::uint32_t>(parts_.size()));
    parts_.push_back({node, way});
    return;
  }
  for (const NodeId child : scene.at(id).children)
    add_dragged(scene, results, child, node, way * scene.at(child).placement.exact());
}

ExactTransform SnapScene::place_in_frame(const Scene& scene, NodeId id, bool in_frame) const {
  if (in_frame) return way_up(scene, id, operation_);
  if (into_frame_) return *into_frame_ * scene.exact_world(id);
  return inverse(frame_) * scene.world(id);
}

void SnapScene::add_others(const Scene& scene, const Results& results, NodeId id, bool in_frame) {
  const Node& node = scene.at(id);
  if (!node.visible || std::count(nodes_.begin(), nodes_.end(), id)) return;
  const bool leads_to_dragged = std::any_of(
      nodes_.begin(), nodes_.end(), [&](NodeId dragged) { return scene.is_below(dragged, id); });
  const Solid* inside = leads_to_dragged ? nullptr : results.inside(id);
  if (inside) {
    others_.push_back({*inside, place_in_frame(scene, id, in_frame), results.bounds_of(scene, id),
                       in_frame || into_frame_.has_value(), nullptr});
    return;
  }
  for (const NodeId child : node.children)
    add_others(scene, results, child, in_frame || id == operation_);
}

std::vector<DraggedNode> SnapScene::dragged_nodes(const Scene& scene) const {
  std::vector<DraggedNode> made;
  for (std::size_t node = 0; node < nodes_.size(); ++node) {
    made.push_back({scene.at(nodes_[node]).placement, parents_[node], {}});
    for (const Part& part : parts_)
      made.back().ways.push_back(part.node == node ? std::optional(part.way) : std::nullopt);
  }
  return made;
}

glm::dvec3 SnapScene::to_world(const Vec3& vector) const {
  return glm::dmat3(matrix_of(frame_)) * to_glm(vector);
}

glm::dvec3 SnapScene::from_world(const glm::dvec3& vector) const {
  return glm::dmat3(matrix_of(inverse(frame_))) * vector;
}

Snaps SnapScene::find(const glm::dvec3& offset, double reach, const SnapDirections& directions) {
  const Bounds moved{bounds_.low + offset, bounds_.high + offset};
  std::vector<const SnapTargets*> targets;
  searched_.clear();
  for (std::size_t i = 0; i < others_.size(); ++i) {
    Other& other = others_[i];
    if (!come_near(moved, other.bounds, 2 * reach)) continue;
    if (!other.targets) other.targets = known_.of(other.inside, other.place);
    targets.push_back(other.targets.get());
    searched_.push_back(i);
  }
  SnapDirections free;
  for (const Vec3& direction : directions) {
    glm::dvec3 d = from_world(to_glm(direction));
    for (const Vec3& before : free) d -= to_glm(before) * glm::dot(to_glm(before), d);
    const double length = glm::length(d);
    if (length > 0) free.push_back(from_glm(is_identity(frame_) ? d : d / length));
  }
  return snap(dragged_, targets, from_glm(from_world(offset)), reach / average_scale(frame_), free);
}

bool SnapScene::is_known(const Snap& contact) const {
  return others_[searched_.at(contact.target)].is_known;
}

}  // namespace sectile::viewer
