// What changes the scene: adding, combining, grouping, removing.
#include <algorithm>
#include <cmath>

#include "app/session.h"
#include "app/words.h"
#include "scene/primitive_kind.h"

namespace sectile::viewer {
void Session::add(const PrimitiveKind& kind) {
  NodeId added = 0;
  const bool done = change("Add " + std::string(kind.name), [&](Scene& changed) {
    Node node;
    node.what = first_primitive(kind);
    // Beside what is there, so that the new solid can be seen; on the grid.
    const Bounds bounds = bounds_of_all();
    if (!bounds.is_empty()) node.placement.position.x = std::ceil(bounds.high.x + 1.5);
    added = changed.add(std::move(node));
  });
  if (!done) return;
  select(added);
  frame_next_ = true;
}

void Session::combine(Operation operation) {
  std::vector<NodeId> operands = topmost_selected();
  // Without a choice, the two solids of a scene of two are meant.
  if (operands.size() < 2 && scene().roots().size() == 2) operands = scene().roots();
  if (operands.size() < 2) {
    interface.messages.error(
        "Select two solids first: click one, then hold Shift and click the other.");
    return;
  }
  NodeId made = 0;
  if (change(capitalised(name_of(operation)),
             [&](Scene& changed) { made = changed.combine(operands, operation); }))
    select(made);
}

void Session::split() {
  const std::vector<NodeId> chosen = topmost_selected();
  if (chosen.size() != 1) {
    interface.messages.error(
        "Select the one solid to split. The section plane says where it is cut.");
    return;
  }
  if (!view.section) {
    view.section = true;
    view.section_axis = 2;
    view.section_oblique = false;
    const Bounds bounds = bounds_of(chosen.front());
    view.section_place = bounds.is_empty() ? 0 : bounds.centre().z;
    interface.messages.tell("Place the section plane under View, then split again.");
    return;
  }
  const glm::dvec4 plane = view.section_plane();
  std::pair<NodeId, NodeId> made;
  if (change("Split", [&](Scene& changed) {
        made = changed.split(chosen.front(), {plane.x, plane.y, plane.z, plane.w});
      })) {
    select({made.first, made.second});
    view.section = false;
  }
}

void Session::duplicate_selected() {
  const std::vector<NodeId> chosen = topmost_selected();
  std::vector<NodeId> made;
  if (!chosen.empty() && change("Duplicate", [&](Scene& changed) {
        for (const NodeId id : chosen) made.push_back(changed.duplicate(id));
      }))
    select(made);
}

void Session::remove_selected() {
  const std::vector<NodeId> chosen = topmost_selected();
  const Scene before = scene();
  if (chosen.empty() || !change("Delete", [&](Scene& changed) {
        for (const NodeId id : chosen) changed.remove(id);
      }))
    return;
  select(Selection());
  tell_new_first_operands(before);
}

// Without the solid that others are cut out of, the next one takes its place: another solid.
void Session::tell_new_first_operands(const Scene& before) {
  for (const NodeId id : scene().in_order()) {
    const Node& node = scene().at(id);
    const auto* operation = std::get_if<BooleanNode>(&node.what);
    if (!operation || operation->operation != Operation::subtract) continue;
    if (before.at(id).children.empty()) continue;
    const NodeId was = before.at(id).children.front();
    if (scene().find(was)) continue;
    interface.messages.tell(
        "\"" + before.at(was).name + "\", from which \"" + node.name + "\" was cut, is deleted: " +
        (node.children.empty()
             ? "nothing is left to cut."
             : "now \"" + scene().at(node.children.front()).name + "\" stands in its place.") +
        " Ctrl+Z takes this back.");
  }
}

void Session::group_selected() {
  const std::vector<NodeId> chosen = topmost_selected();
  NodeId made = 0;
  if (!chosen.empty() && change("Group", [&](Scene& changed) { made = changed.group(chosen); }))
    select(made);
}

void Session::ungroup_selected() {
  const Node* node = scene().find(selected());
  if (!node || !std::holds_alternative<Group>(node->what)) {
    interface.messages.error("Select a group to take apart.");
    return;
  }
  const std::vector<NodeId> members = node->children;
  const NodeId id = node->id;
  if (change("Ungroup", [&](Scene& changed) { changed.ungroup(id); })) select(members);
}

void Session::hide_selected() {
  const Selection chosen = selection();
  const bool any_visible = std::any_of(chosen.begin(), chosen.end(), [&](NodeId id) {
    const Node* node = scene().find(id);
    return node && node->visible;
  });
  if (!chosen.empty())
    change(any_visible ? "Hide" : "Show", [&](Scene& changed) {
      for (const NodeId id : chosen) changed.edit(id).visible = !any_visible;
    });
}

void Session::take_profile() {
  Primitive primitive = interface.profile.primitive;
  primitive.profile = interface.profile.sketch.profile();
  NodeId made = interface.profile.node;
  if (change(made ? "Edit profile" : "Draw profile", [&](Scene& changed) {
        if (made) {
          changed.edit(made).what = primitive;
          return;
        }
        Node node;
        node.what = primitive;
        node.placement = interface.profile.placement;
        made = changed.add(std::move(node));
      }))
    select(made);
  interface.profile.open = false;
}

void Session::rename(NodeId id, const std::string& name) {
  const Node* node = scene().find(id);
  if (!node || name.empty() || node->name == name) return;
  change("Rename", [&](Scene& changed) { changed.rename(id, name); });
}

}  // namespace sectile::viewer
