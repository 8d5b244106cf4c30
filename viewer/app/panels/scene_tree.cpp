#include <imgui.h>
#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cstring>
#include <optional>

#include "app/icons.h"
#include "app/interface_input.h"
#include "app/panels/panels.h"
#include "app/words.h"

namespace sectile::viewer {
namespace {

constexpr const char* payload_name = "node";

/// Where a dragged node is to go.
struct Drop {
  NodeId node = 0, parent = 0;
  std::size_t at = 0;
};

bool takes_children(const Node& node) {
  return std::holds_alternative<BooleanNode>(node.what) ||
         std::holds_alternative<Group>(node.what) || std::holds_alternative<Pattern>(node.what);
}

std::size_t place_among_siblings(const Scene& scene, const Node& node) {
  const Node* parent = scene.find(node.parent);
  const std::vector<NodeId>& siblings = parent ? parent->children : scene.roots();
  return static_cast<std::size_t>(std::find(siblings.begin(), siblings.end(), node.id) -
                                  siblings.begin());
}

class Tree {
 public:
  explicit Tree(PanelContext& context) : context_(context), session_(context.session) {}

  void draw() {
    const std::vector<NodeId> roots = session_.scene().roots();
    for (const NodeId id : roots) draw_node(id, 0);
    drop_on_the_rest();
    if (drop_) apply_drop();
  }

 private:
  void draw_node(NodeId id, std::size_t place) {
    const Node* found = session_.scene().find(id);
    if (!found) return;  // removed by a command of this very frame
    const Node node = *found;
    ImGui::PushID(static_cast<int>(id));
    draw_eye(node);
    const bool open = draw_row(node, place);
    ImGui::PopID();
    if (!open) return;
    for (std::size_t i = 0; i < node.children.size(); ++i) draw_node(node.children[i], i);
    ImGui::TreePop();
  }

  void draw_eye(const Node& node) {
    const float size = ImGui::GetFrameHeight();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    // The eyes stand in one column whatever the depth of the node.
    const ImVec2 column{ImGui::GetWindowPos().x + 6, at.y};
    ImGui::SetCursorScreenPos(column);
    if (ImGui::InvisibleButton("eye", {size, size}))
      session_.change(node.visible ? "Hide" : "Show",
                      [&](Scene& changed) { changed.edit(node.id).visible = !node.visible; });
    context_.widgets.record_item("tree.eye:" + std::to_string(node.id));
    const bool hovered = ImGui::IsItemHovered();
    tooltip(node.visible ? "Hide" : "Show");
    const char* icon = node.visible ? icons::eye : icons::eye_slash;
    const ImVec2 text = ImGui::CalcTextSize(icon);
    ImGui::GetWindowDrawList()->AddText(
        {column.x + (size - text.x) / 2, column.y + (size - text.y) / 2},
        ImGui::GetColorU32(node.visible || hovered ? ImGuiCol_Text : ImGuiCol_TextDisabled,
                           node.visible && !hovered ? 0.6f : 1.0f),
        icon);
    ImGui::SameLine(0, 0);
    ImGui::SetCursorScreenPos({std::max(at.x, column.x) + size, at.y});
  }

  bool draw_row(const Node& node, std::size_t place) {
    ImGuiTreeNodeFlags flags = ImGuiTreeNodeFlags_OpenOnArrow | ImGuiTreeNodeFlags_SpanAvailWidth |
                               ImGuiTreeNodeFlags_FramePadding | ImGuiTreeNodeFlags_DefaultOpen;
    if (node.children.empty()) flags |= ImGuiTreeNodeFlags_Leaf;
    if (session_.is_selected(node.id)) flags |= ImGuiTreeNodeFlags_Selected;
    const bool renaming = session_.interface.renaming.node == node.id;
    const std::string whole = label(node),
                      text = renaming ? std::string() : fitted(whole, has_badge(node));
    if (!node.visible)
      ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
    const bool open = ImGui::TreeNodeEx("row", flags, "%s", text.c_str());
    if (!node.visible) ImGui::PopStyleColor();
    context_.widgets.record_item("tree:" + std::to_string(node.id));
    if (renaming) {
      draw_name_field(node);
      return open;
    }
    if (text != whole) tooltip(node.name);
    react(node);
    draw_badge(node, place);
    return open;
  }

  /// Far inside of others a name is not to run into the badge at the right.
  static std::string fitted(std::string text, bool with_badge) {
    const float badge = with_badge ? 26 : 4;
    const float room = std::max(
        40.0f, ImGui::GetContentRegionAvail().x - ImGui::GetTreeNodeToLabelSpacing() - badge);
    if (text_width(text) <= room) return text;
    while (!text.empty() && text_width(text + "\u2026") > room) {
      // The bytes of a character go together.
      while (text.size() > 1 && (text.back() & 0xC0) == 0x80) text.pop_back();
      text.pop_back();
    }
    return text + "\u2026";
  }

  bool has_badge(const Node& node) const {
    const Node* parent = session_.scene().find(node.parent);
    return !session_.results.error_of(node.id).empty() ||
           (parent && std::holds_alternative<BooleanNode>(parent->what));
  }

  std::string label(const Node& node) const {
    std::string sign;
    if (const auto* b = std::get_if<BooleanNode>(&node.what)) sign = icon_of(b->operation) + "  ";
    if (std::holds_alternative<SplitNode>(node.what)) sign = std::string(icons::scissors) + "  ";
    if (std::holds_alternative<Pattern>(node.what)) sign = std::string(icons::grid) + "  ";
    if (std::holds_alternative<Group>(node.what)) sign = std::string(icons::group) + "  ";
    return sign + node.name + role_in_story(node);
  }

  /// Of several operands: which are A and B of the steps that are told.
  std::string role_in_story(const Node& node) const {
    if (session_.mode() != Mode::steps || node.parent != session_.story_node()) return {};
    const Node* parent = session_.scene().find(node.parent);
    const std::size_t told = session_.told_operand();
    if (!parent || parent->children.size() < 3) return {};
    const auto place = static_cast<std::size_t>(
        std::find(parent->children.begin(), parent->children.end(), node.id) -
        parent->children.begin());
    return place < told ? "   (in A)" : place == told ? "   (B)" : "   (later)";
  }

  void react(const Node& node) {
    if (ImGui::IsItemHovered() && ImGui::IsMouseReleased(ImGuiMouseButton_Left) &&
        !ImGui::IsItemToggledOpen() && ImGui::GetMouseDragDelta().x == 0)
      session_.select(node.id, ImGui::GetIO().KeyShift || ImGui::GetIO().KeyCtrl);
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left))
      session_.interface.renaming = {node.id, false, {}};
    drag_and_drop(node);
    if (ImGui::BeginPopupContextItem("menu")) {
      if (!session_.is_selected(node.id)) session_.select(node.id);
      for (const char* name : {"edit.rename", "edit.hide", "edit.duplicate", "edit.delete",
                               "edit.group", "edit.ungroup", "view.frame", "file.export"})
        command_item(context_, name);
      ImGui::EndPopup();
    }
  }

  void drag_and_drop(const Node& node) {
    if (ImGui::BeginDragDropSource(ImGuiDragDropFlags_SourceNoDisableHover)) {
      ImGui::SetDragDropPayload(payload_name, &node.id, sizeof node.id);
      ImGui::TextUnformatted(node.name.c_str());
      ImGui::EndDragDropSource();
    }
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    if (!ImGui::BeginDragDropTarget()) return;
    const ImGuiPayload* payload =
        ImGui::AcceptDragDropPayload(payload_name, ImGuiDragDropFlags_AcceptBeforeDelivery |
                                                       ImGuiDragDropFlags_AcceptNoDrawDefaultRect);
    if (payload) {
      const float part = (ImGui::GetMousePos().y - low.y) / (high.y - low.y);
      const bool into = takes_children(node) && part > 0.3f && part < 0.7f;
      const bool after = part >= 0.5f;
      mark_drop(low, high, into, after);
      if (payload->IsDelivery()) {
        NodeId dragged = 0;
        std::memcpy(&dragged, payload->Data, sizeof dragged);
        drop_ = into ? Drop{dragged, node.id, node.children.size()}
                     : Drop{dragged, node.parent,
                            place_among_siblings(session_.scene(), node) + (after ? 1 : 0)};
      }
    }
    ImGui::EndDragDropTarget();
  }

  static void mark_drop(ImVec2 low, ImVec2 high, bool into, bool after) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const ImU32 colour = ImGui::GetColorU32(ImGuiCol_DragDropTarget);
    const float y = after ? high.y : low.y;
    if (into)
      draw.AddRect(low, high, colour, 3, 0, 2);
    else
      draw.AddLine({low.x, y}, {high.x, y}, colour, 3);
  }

  /// Below the last row: to the end of the scene.
  void drop_on_the_rest() {
    const ImVec2 rest = ImGui::GetContentRegionAvail();
    if (rest.y < 4 || rest.x < 4) return;
    ImGui::Dummy(rest);
    if (ImGui::IsItemHovered() && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) session_.select(0);
    if (!ImGui::BeginDragDropTarget()) return;
    if (const ImGuiPayload* payload = ImGui::AcceptDragDropPayload(payload_name)) {
      NodeId dragged = 0;
      std::memcpy(&dragged, payload->Data, sizeof dragged);
      drop_ = Drop{dragged, 0, session_.scene().roots().size()};
    }
    ImGui::EndDragDropTarget();
  }

  void apply_drop() {
    Drop drop = *drop_;
    const Node* node = session_.scene().find(drop.node);
    if (!node) return;
    if (drop.parent != 0 && session_.scene().is_below(drop.parent, drop.node)) {
      session_.interface.messages.error("A solid cannot go below itself.");
      return;
    }
    session_.change("Move in the tree",
                    [&](Scene& changed) { changed.move(drop.node, drop.parent, drop.at); });
  }

  void draw_name_field(const Node& node) {
    Renaming& renaming = session_.interface.renaming;
    const bool begins = !renaming.begun;
    if (!renaming.begun) {
      renaming.begun = true;
      renaming.text = node.name;
    }
    const ImVec2 low = ImGui::GetItemRectMin();
    ImGui::SameLine(0, 0);
    ImGui::SetCursorScreenPos({low.x + ImGui::GetTreeNodeToLabelSpacing() - 4, low.y});
    ImGui::SetNextItemWidth(-1);
    const bool entered =
        ImGui::InputText("##name", &renaming.text,
                         ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
    context_.widgets.record_item("tree.name");
    // Of the item before: asked for the next one, ImGui 1.90 looks for it in the window outside.
    if (begins) ImGui::SetKeyboardFocusHere(-1);
    const bool left = ImGui::IsItemDeactivated();
    if (!entered && !left) return;
    if (!interface_input::was_pressed(Key::escape)) session_.rename(node.id, renaming.text);
    renaming = {};
  }

  /// At the right: a warning, or the role in the operation above.
  void draw_badge(const Node& node, std::size_t place) {
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const std::string error = session_.results.error_of(node.id);
    if (!error.empty()) {
      draw.AddText({high.x - 20, low.y + 3}, IM_COL32(214, 60, 30, 255), icons::warning);
      tooltip(error);
      return;
    }
    const Node* parent = session_.scene().find(node.parent);
    if (!parent || !std::holds_alternative<BooleanNode>(parent->what)) return;
    const Colour colour = place == 0 ? context_.theme.a : context_.theme.b;
    draw.AddCircleFilled({high.x - 12, (low.y + high.y) / 2}, 5, packed(with_alpha(colour, 1)));
  }

  PanelContext& context_;
  Session& session_;
  std::optional<Drop> drop_;
};

}  // namespace

void draw_scene_tree(PanelContext& context) {
  begin_panel(context, "tree", context.layout.tree);
  title(context, "Scene");
  if (context.session.scene().size() == 0) {
    note(context, "Nothing here yet. Add a solid, drop a file into the window, or open a sample.");
  } else {
    ImGui::BeginChild("nodes");
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {4, 1});
    Tree(context).draw();
    ImGui::PopStyleVar();
    ImGui::EndChild();
  }
  end_panel();
}

}  // namespace sectile::viewer
