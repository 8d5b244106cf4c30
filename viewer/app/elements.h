// Buttons, fields and panels as the whole interface uses them: each records its rectangle under its
// name.
#pragma once

#include <imgui.h>

#include <string>

#include "app/commands.h"
#include "app/fonts.h"
#include "app/layout.h"
#include "app/style.h"
#include "app/widgets.h"
#include "picture/theme.h"

namespace sectile::viewer {

/// What every panel needs to draw itself.
struct PanelContext {
  Session& session;
  const Commands& commands;
  Widgets& widgets;
  const Layout& layout;
  const Fonts& fonts;
  const Theme& theme;
};

/// A panel at a fixed place. Always followed by end_panel().
void begin_panel(PanelContext& context, const char* name, const Rectangle& place,
                 ImGuiWindowFlags flags = 0);
void end_panel();
void title(PanelContext& context, const char* text);

bool button(PanelContext& context, const std::string& name, const std::string& text,
            const std::string& help = {}, bool enabled = true, float width = 0, bool on = false);
/// A small square with an icon.
bool icon_button(PanelContext& context, const std::string& name, const char* icon,
                 const std::string& help, bool enabled = true, bool on = false);
/// The button of a command: icon and, if asked, its title.
void command_button(PanelContext& context, std::string_view command, bool with_title);
/// The item of a command in a menu; it is called "menu:" and the command's name.
void command_item(PanelContext& context, std::string_view command);
bool checkbox(PanelContext& context, const std::string& name, const char* text, bool& value,
              const std::string& help = {});

/// How a slider's value is written beside it; the room is that of the widest one, so that the
/// slider keeps its length.
struct SliderText {
  const char* format;
  std::string widest;
};
/// Of a width with its text; 0: fills the rest of the line.
bool slider(PanelContext& context, const std::string& name, double& value, double low, double high,
            const SliderText& text, float width = 0);
bool slider(PanelContext& context, const std::string& name, int& value, int low, int high,
            const SliderText& text, float width = 0);

/// Of the last item, when the mouse has rested on it for a moment.
void tooltip(const std::string& text);
bool is_tooltip_pending();  ///< the mouse rests on something, but not for long enough yet
std::string tooltip_of(const Command& command);
/// Wrapped text in the small font and a faint colour.
void note(PanelContext& context, const std::string& text);
float text_width(const std::string& text);

}  // namespace sectile::viewer
