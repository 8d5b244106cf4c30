#include "app/results.h"

#include "scene/transforms.h"

namespace sectile::viewer {
namespace {

/// A box around the moved corners of a box.
Bounds moved(const Bounds& bounds, const glm::dmat4& by) {
  Bounds result;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec4 p(corner & 1 ? bounds.high.x : bounds.low.x,
                       corner & 2 ? bounds.high.y : bounds.low.y,
                       corner & 4 ? bounds.high.z : bounds.low.z, 1);
    result.add(glm::dvec3(by * p));
  }
  return result;
}

}  // namespace

bool Results::ask(const Document& document) {
  if (knows(document)) return false;
  seen_revision_ = document.revision();
  newest_request_ = evaluator_.request(document.scene());
  return true;
}

bool Results::take(bool wait) {
  if (wait) evaluator_.wait();
  const std::shared_ptr<const Evaluation> latest = evaluator_.latest();
  if (!latest || latest == evaluation_) return false;
  evaluation_ = latest;
  return true;
}

std::vector<std::string> Results::new_errors(const Scene& scene) {
  std::vector<std::string> made;
  std::map<NodeId, std::string> errors;
  for (const auto& [id, entry] : evaluation_->nodes) {
    const Node* node = scene.find(id);
    if (entry.error.empty() || !node) continue;
    errors[id] = entry.error;
    const auto told = told_errors_.find(id);
    if (told == told_errors_.end() || told->second != entry.error)
      made.push_back(node->name + ": " + entry.error);
  }
  told_errors_ = std::move(errors);
  return made;
}

const Solid* Results::solid(NodeId id) const {
  const Evaluation::Entry* entry = evaluation_ ? evaluation_->find(id) : nullptr;
  return entry && entry->error.empty() && entry->is_computed ? &entry->solid : nullptr;
}

const Solid* Results::inside(NodeId id) const {
  const Evaluation::Entry* entry = evaluation_ ? evaluation_->find(id) : nullptr;
  return entry && entry->error.empty() && !entry->inside.is_empty() ? &entry->inside : nullptr;
}

std::string Results::error_of(NodeId id) const {
  const Evaluation::Entry* entry = evaluation_ ? evaluation_->find(id) : nullptr;
  return entry ? entry->error : std::string();
}

std::vector<Solid> Results::members_of(const Scene& scene, NodeId id) const {
  const Solid* own = solid(id);
  const Node& node = scene.at(id);
  if (own && !own->is_empty()) return {*own};
  std::vector<Solid> members;
  if (own || !std::holds_alternative<Group>(node.what)) return members;
  for (const NodeId child : node.children) {
    const std::vector<Solid> more = members_of(scene, child);
    // What is left out in silence would be missed.
    if (more.empty()) return {};
    members.insert(members.end(), more.begin(), more.end());
  }
  return members;
}

std::vector<Solid> Results::operands_of(const Scene& scene, const Node& node) const {
  std::vector<Solid> operands;
  for (const NodeId child : node.children) {
    const Solid* operand = solid(child);
    if (!scene.find(child) || !operand) return {};
    operands.push_back(*operand);
  }
  const std::size_t needed = std::holds_alternative<SplitNode>(node.what) ? 1 : 2;
  return operands.size() < needed ? std::vector<Solid>() : operands;
}

const SolidNumbers& Results::numbers(NodeId id, const Solid& solid) {
  SolidNumbers& known = numbers_[id];
  if (known.of.data() != solid.data())
    known = {solid, solid.volume(), solid.area(), solid.counts()};
  return known;
}

Bounds Results::bounds_of(const Scene& scene, NodeId id) const {
  Bounds bounds;
  const Node* node = scene.find(id);
  if (!node) return bounds;
  const Evaluation::Entry* entry = evaluation_ ? evaluation_->find(id) : nullptr;
  if (entry && entry->surface && !entry->surface->bounds.is_empty())
    return moved(entry->surface->bounds, matrix_of(scene.world(id)));
  for (const NodeId child : node->children) bounds.add(bounds_of(scene, child));
  return bounds;
}

Bounds Results::bounds_of_all(const Scene& scene) const {
  Bounds bounds;
  for (const NodeId root : scene.roots())
    if (scene.find(root)->visible) bounds.add(bounds_of(scene, root));
  return bounds;
}

bool Results::is_current() const {
  return !evaluator_.is_busy() && evaluation_ && evaluation_->request == newest_request_;
}

void Results::cancel() {
  evaluator_.cancel();
  player.cancel();
}

}  // namespace sectile::viewer
