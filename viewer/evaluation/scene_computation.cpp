#include "evaluation/scene_computation.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <new>
#include <numeric>
#include <stdexcept>

#include "picture/surface_mesh.h"
#include "scene/primitive_kind.h"
#include "scene/transforms.h"

namespace sectile::viewer {

namespace {

// Solids that nothing shows any more are kept for undo and for going back in a drag.
constexpr std::size_t unused_faces_kept = 500'000;

/// A mesh that is of no file is a sample, whose figure shows each of its faces.
Solid solid_of(const Imported& imported) {
  std::vector<std::uint32_t> each;
  ImportOptions options;
  if (imported.path.empty()) {
    each.resize(imported.mesh->face_sizes.size());
    std::iota(each.begin(), each.end(), 0u);
    options.face_groups = each;
  }
  return Solid::from_mesh(*imported.mesh, options);
}

Value value_of(Solid solid, std::size_t faces) {
  Value value;
  value.solid = std::move(solid);
  value.faces = faces;
  return value;
}

}  // namespace

void SceneComputation::tell(double part_of_current) {
  if (*progress_)
    (*progress_)((static_cast<double>(steps_done_) +
                  (static_cast<double>(part_) + part_of_current) / static_cast<double>(parts_)) /
                 static_cast<double>(steps_));
  if (cancel_ && *cancel_) throw Cancelled();
}

BooleanOptions SceneComputation::options() {
  BooleanOptions made;
  made.cancel = cancel_;
  made.progress = [this](double part) { tell(part); };
  return made;
}

ValuePointer SceneComputation::failed(const ValueKey& key, std::string error) {
  Value value;
  value.error = std::move(error);
  return values_.add(key, std::move(value));
}

template <class Make>
ValuePointer SceneComputation::known_or_made(const ValueKey& key, Make&& make) {
  if (ValuePointer known = values_.find(key)) return known;
  tell(0);
  try {
    return values_.add(key, make());
  } catch (const Cancelled&) {
    throw;
  } catch (const std::bad_alloc&) {
    return failed(key, "There is not enough memory for this solid.");
  } catch (const std::exception& error) {
    return failed(key, error.what());
  }
}

ValuePointer SceneComputation::placed(const ValuePointer& value, const Transform& by) {
  if (is_identity(by) || !value->error.empty() || value->solid.is_empty()) return value;
  return known_or_made(ValueKey('t').add(value->id).add(by),
                       [&] { return value_of(transformed(value->solid, by), value->faces); });
}

ValuePointer SceneComputation::placed(const ValuePointer& value, const Placement& by) {
  const Transform rounded = by.transform();
  if (by.remainder == Vec3{0, 0, 0}) return placed(value, rounded);
  if (!value->error.empty() || value->solid.is_empty()) return value;
  return known_or_made(
      ValueKey('r').add(value->id).add(rounded).add(by.position).add(by.remainder),
      [&] { return value_of(transformed(value->solid, by.exact()), value->faces); });
}

// Moved step by step, and so exactly as the operands of operations are.
ValuePointer SceneComputation::in_world(const Node& node) {
  ValuePointer value = inside(node);
  for (const Node* at = &node; at; at = scene_->find(at->parent))
    value = placed(value, at->placement);
  return value;
}

std::vector<ValuePointer> SceneComputation::placed_children(const Node& node) {
  std::vector<ValuePointer> made;
  for (const NodeId child : node.children)
    made.push_back(placed(inside(scene_->at(child)), scene_->at(child).placement));
  return made;
}

ValuePointer SceneComputation::combined(const ValuePointer& a, const ValuePointer& b,
                                        Operation operation) {
  return known_or_made(ValueKey('2').add(operation).add(a->id).add(b->id), [&] {
    return value_of(boolean(a->solid, b->solid, operation, options()), a->faces + b->faces);
  });
}

// Operands that are not new come first, so that while one of many is dragged the others are
// combined only once. The first of a difference stays the first.
ValuePointer SceneComputation::fold(std::vector<ValuePointer> operands, Operation operation) {
  std::stable_partition(operands.begin() + (operation == Operation::subtract ? 1 : 0),
                        operands.end(), [&](const auto& v) { return !values_.is_new(*v); });
  ValuePointer result = operands.front();
  parts_ = std::max<std::size_t>(1, operands.size() - 1);
  for (std::size_t i = 1; i < operands.size() && result->error.empty(); ++i) {
    part_ = i - 1;
    result = combined(result, operands[i], operation);
  }
  part_ = 0, parts_ = 1;
  return result;
}

ValuePointer SceneComputation::operation(const Node& node, Operation operation) {
  const std::vector<ValuePointer> operands = placed_children(node);
  ValueKey key('b');
  key.add(operation);
  for (const ValuePointer& operand : operands) key.add(operand->id);
  for (std::size_t i = 0; i < operands.size(); ++i)
    if (!operands[i]->error.empty())
      return failed(
          key, "\"" + scene_->at(node.children[i]).name + "\" is no solid: " + operands[i]->error);
  return known_or_made(key, [&] {
    if (operands.empty()) return Value();
    const ValuePointer result = fold(operands, operation);
    if (!result->error.empty()) throw std::runtime_error(result->error);
    return value_of(result->solid, result->faces);
  });
}

// Halves before the whole, so that no copy is carried through many unions.
ValuePointer SceneComputation::united(std::span<const ValuePointer> parts) {
  if (parts.size() == 1) return parts.front();
  const std::size_t half = parts.size() / 2;
  const ValuePointer a = united(parts.first(half)), b = united(parts.subspan(half));
  if (!a->error.empty()) return a;
  return b->error.empty() ? combined(a, b, Operation::unite) : b;
}

ValuePointer SceneComputation::repeated(const Node& node, const Pattern& pattern) {
  const ValuePointer one = operation(node, Operation::unite);
  if (!one->error.empty()) return failed(ValueKey('A').add(one->id), one->error);
  std::vector<Transform> places;
  try {
    places = copies_of(pattern);
  } catch (const std::invalid_argument& error) {
    return failed(ValueKey('A').add(one->id), error.what());
  }
  ValueKey key('a');
  key.add(one->id);
  for (const Transform& place : places) key.add(place);
  return known_or_made(key, [&] {
    std::vector<ValuePointer> copies;
    for (const Transform& place : places) copies.push_back(placed(one, place));
    const ValuePointer result = united(copies);
    if (!result->error.empty()) throw std::runtime_error(result->error);
    return value_of(result->solid, result->faces);
  });
}

ValuePointer SceneComputation::cut(const Node& node, const SplitNode& split) {
  const std::vector<ValuePointer> operands = placed_children(node);
  const HalfSpace& plane = split.plane;
  const auto key_of = [&](bool above) {
    ValueKey key('s');
    key.add(plane.a).add(plane.b).add(plane.c).add(plane.d).add(above);
    return operands.empty() ? key : key.add(operands.front()->id);
  };
  if (!operands.empty() && !operands.front()->error.empty())
    return failed(key_of(split.above), "\"" + scene_->at(node.children.front()).name +
                                           "\" is no solid: " + operands.front()->error);
  return known_or_made(key_of(split.above), [&] {
    if (operands.empty()) return Value();
    auto [above, below] = sectile::split(operands.front()->solid, plane, options());
    // The other part is wanted as a rule, too.
    const std::size_t faces = operands.front()->faces;
    values_.add(key_of(!split.above), value_of(split.above ? below : above, faces));
    return value_of(split.above ? above : below, faces);
  });
}

ValuePointer SceneComputation::make_inside(const Node& node) {
  if (const auto* primitive = std::get_if<Primitive>(&node.what))
    return known_or_made(ValueKey('p').add(*primitive), [&] {
      Solid solid = solid_of(*primitive);
      const std::size_t faces = solid.counts().faces;
      return value_of(std::move(solid), faces);
    });
  if (const auto* imported = std::get_if<Imported>(&node.what))
    return known_or_made(ValueKey('m').add(imported->mesh.get()), [&] {
      if (!imported->mesh) throw std::runtime_error("The mesh is missing.");
      Value value = value_of(solid_of(*imported), imported->mesh->face_sizes.size());
      value.source = imported->mesh;
      return value;
    });
  if (const auto* split = std::get_if<SplitNode>(&node.what)) return cut(node, *split);
  if (const auto* made = std::get_if<BooleanNode>(&node.what))
    return operation(node, made->operation);
  if (const auto* pattern = std::get_if<Pattern>(&node.what)) return repeated(node, *pattern);
  return operation(node, Operation::unite);
}

ValuePointer SceneComputation::inside(const Node& node) {
  const ValuePointer known = insides_[node.id];
  if (known) return known;
  const ValuePointer made = make_inside(node);
  if (!node.children.empty()) ++steps_done_;
  return insides_[node.id] = made;
}

void SceneComputation::fill(const Node& node, bool is_shown, Evaluation::Entry& entry) {
  const ValuePointer value = inside(node);
  const ValuePointer moved = in_world(node);
  entry.error = moved->error;
  entry.solid = moved->solid;
  if (entry.error.empty()) entry.inside = value->solid;
  const bool is_group = std::holds_alternative<Group>(node.what);
  if (is_shown && !is_group && entry.error.empty() && !value->solid.is_empty())
    to_draw_.push_back(value);
}

// Groups are united only where an operation needs them.
void SceneComputation::enter(NodeId id, const Transform& parent_world, bool is_needed,
                             bool is_shown, Evaluation& made) {
  const Node& node = scene_->at(id);
  const Transform own = node.placement.transform();
  const Transform world = is_identity(parent_world) ? own : parent_world * own;
  const bool is_group = std::holds_alternative<Group>(node.what);
  Evaluation::Entry& entry = made.nodes[id];
  entry.model = matrix_of(world);
  is_shown = is_shown && node.visible;
  entry.is_computed = !is_group || is_needed;
  if (entry.is_computed) fill(node, is_shown, entry);
  for (const NodeId child : node.children)
    enter(child, world, is_needed || !is_group, is_shown, made);
}

void SceneComputation::make_surfaces() {
  std::erase_if(to_draw_, [](const ValuePointer& value) { return value->surface != nullptr; });
  std::sort(to_draw_.begin(), to_draw_.end());
  to_draw_.erase(std::unique(to_draw_.begin(), to_draw_.end()), to_draw_.end());
  tbb::parallel_for(std::size_t{0}, to_draw_.size(), [&](std::size_t i) {
    to_draw_[i]->surface = surface_mesh(to_draw_[i]->solid);
  });
  to_draw_.clear();
}

namespace {

Bounds moved(const SurfaceMesh& mesh, const glm::dmat4& by) {
  Bounds made;
  const auto add = [&](const glm::dvec3& p) { made.add(glm::dvec3(by * glm::dvec4(p, 1))); };
  int entries = 0;
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row) entries += by[column][row] != 0;
  if (entries == 3) {  // boxes stay boxes
    if (!mesh.bounds.is_empty()) add(mesh.bounds.low), add(mesh.bounds.high);
  } else {
    for (const glm::vec3& p : mesh.positions) add(p);
  }
  return made;
}

}  // namespace

Evaluation SceneComputation::run(const Scene& scene, const std::atomic<bool>* cancel,
                                 const std::function<void(double)>& progress) {
  scene_ = &scene;
  cancel_ = cancel;
  progress_ = &progress;
  insides_.clear();
  to_draw_.clear();
  values_.begin();
  values_.mark_all_old();
  steps_ = 1;  // the surfaces
  for (const NodeId id : scene.in_order()) steps_ += !scene.at(id).children.empty();
  steps_done_ = part_ = 0;
  parts_ = 1;
  Evaluation made;
  for (const NodeId root : scene.roots()) enter(root, Transform(), false, true, made);
  make_surfaces();
  tell(0);
  for (auto& [id, entry] : made.nodes) {
    const auto value = insides_.find(id);
    if (value == insides_.end() || !entry.error.empty() || !scene.is_shown(id)) continue;
    if (std::holds_alternative<Group>(scene.at(id).what)) continue;
    entry.surface = value->second->surface;
    if (entry.surface) entry.bounds = moved(*entry.surface, entry.model);
  }
  values_.forget_unused(unused_faces_kept);
  return made;
}

}  // namespace sectile::viewer
