// The panels of the window. Each draws itself into its place of the layout.
#pragma once

#include "app/elements.h"

namespace sectile::viewer {

float draw_menu_bar(PanelContext& context);  ///< gives its height
void draw_tool_bar(PanelContext& context);
void draw_scene_tree(PanelContext& context);
void draw_properties(PanelContext& context);
void draw_inspector(PanelContext& context);
void draw_time_line(PanelContext& context);
void draw_splitters(PanelContext& context);
void draw_legend(PanelContext& context);
void draw_view_panel(PanelContext& context);
void draw_tool_banner(PanelContext& context);  ///< what to do with the tool in the picture
void draw_context_menu(PanelContext& context);
void draw_profile_editor(PanelContext& context);
void draw_profile_canvas(PanelContext& context, float width, float height);
void draw_recording(PanelContext& context);
void draw_view_cube(PanelContext& context);
void draw_key_page(PanelContext& context);
void draw_hint_strip(PanelContext& context);
void draw_messages(PanelContext& context);
void draw_status_bar(PanelContext& context);
void draw_file_browser(PanelContext& context);
void draw_questions(PanelContext& context);
void draw_help(PanelContext& context);
void draw_tour(PanelContext& context);
void draw_repair(PanelContext& context);

/// The spherical picture of a step with a caption, as large as it fits.
void draw_sphere(PanelContext& context, const Step& step, float width, float height);

}  // namespace sectile::viewer
