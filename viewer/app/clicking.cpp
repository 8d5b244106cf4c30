#include "app/clicking.h"

#include <algorithm>

#include "app/picture_maker.h"

namespace sectile::viewer {
namespace {

NodeId hit_among(const Session& session, Picker& picker, const Ray& ray, bool operands) {
  std::vector<PickTarget> targets;
  for (const Shape& shape : visible_shapes(session))
    if (shape.is_operand == operands)
      targets.push_back({shape.node, shape.surface.mesh, shape.surface.model});
  const SectionPlane section{session.view.section, session.view.section_plane()};
  const std::optional<Hit> hit = picker.pick(ray, targets, section);
  return hit ? hit->node : 0;
}

/// The nodes from the root down to `id`.
std::vector<NodeId> way_to(const Scene& scene, NodeId id) {
  std::vector<NodeId> way;
  for (const Node* node = scene.find(id); node; node = scene.find(node->parent))
    way.push_back(node->id);
  std::reverse(way.begin(), way.end());
  return way;
}

}  // namespace

NodeId clicked_node(const Session& session, Picker& picker, const Ray& ray, Depth depth) {
  // Operands lie within or on their result: they are meant once the result is selected.
  const NodeId hit = hit_among(session, picker, ray, false);
  if (depth == Depth::inner || hit == 0)
    if (const NodeId operand = hit_among(session, picker, ray, true)) return operand;
  const std::vector<NodeId> way = way_to(session.scene(), hit);
  if (way.empty()) return 0;
  if (depth == Depth::outer) return way.front();
  const auto here = std::find(way.begin(), way.end(), session.selected());
  return here == way.end() || std::next(here) == way.end() ? way.back() : *std::next(here);
}

}  // namespace sectile::viewer
