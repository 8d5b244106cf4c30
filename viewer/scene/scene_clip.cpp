#include "scene/scene_clip.h"

#include "scene/scene_file.h"

namespace sectile::viewer {
namespace {

NodeId copy_below(const Scene& from, NodeId id, Scene& to, NodeId parent) {
  const Node original = from.at(id);
  const NodeId made = to.add(original, parent);
  for (const NodeId child : original.children) copy_below(from, child, to, made);
  return made;
}

}  // namespace

std::string copied_text(const Scene& scene, const std::vector<NodeId>& nodes) {
  Scene clip;
  for (const NodeId id : scene.topmost(nodes)) {
    const NodeId made = copy_below(scene, id, clip, 0);
    if (!scene.exact_world_of_parent(id).is_identity())
      clip.edit(made).placement = Placement::of(scene.exact_world(id));
  }
  return scene_text({clip, {}});
}

Scene copied_scene(std::string_view text) {
  return parse_scene(text, "the clipboard").scene;
}

std::vector<NodeId> insert(Scene& scene, const Scene& added) {
  std::vector<NodeId> made;
  for (const NodeId root : added.roots()) made.push_back(copy_below(added, root, scene, 0));
  return made;
}

}  // namespace sectile::viewer
