// What can be done with what the right button clicked.
#include "app/panels/panels.h"

namespace sectile::viewer {
namespace {

/// "-" stands for a line. What cannot be run is left out.
constexpr const char* of_selection[] = {"transform.move",
                                        "transform.rotate",
                                        "transform.scale",
                                        "-",
                                        "edit.duplicate_move",
                                        "edit.copy",
                                        "edit.paste",
                                        "edit.delete",
                                        "edit.rename",
                                        "edit.hide",
                                        "view.isolate",
                                        "-",
                                        "operation.unite",
                                        "operation.intersect",
                                        "operation.subtract",
                                        "operation.split",
                                        "-",
                                        "place.ground",
                                        "place.face_on_face",
                                        "place.edge_on_edge",
                                        "-",
                                        "edit.group",
                                        "edit.ungroup",
                                        "view.frame"};
constexpr const char* of_nothing[] = {
    "tool.add", "edit.paste",   "edit.select_all",   "select.box",   "-",
    "view.all", "view.isolate", "view.orthographic", "view.section", "view.panel"};

template <std::size_t Count>
void draw_items(PanelContext& context, const char* const (&names)[Count]) {
  bool line = false, any = false;
  for (const char* name : names) {
    if (*name == '-') {
      line = any;
      continue;
    }
    if (!is_enabled(context.commands.get(name), context.session)) continue;
    if (line) ImGui::Separator();
    line = false, any = true;
    command_item(context, name);
  }
}

}  // namespace

void draw_context_menu(PanelContext& context) {
  Session& session = context.session;
  constexpr const char* name = "context menu";
  if (session.interface.context_menu) {
    session.interface.context_menu = false;
    ImGui::OpenPopup(name);
  }
  if (!ImGui::BeginPopup(name)) return;
  context.widgets.record_window("panel.context_menu");
  if (session.selection().empty())
    draw_items(context, of_nothing);
  else
    draw_items(context, of_selection);
  ImGui::EndPopup();
}

}  // namespace sectile::viewer
