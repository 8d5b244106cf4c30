#include "app/number_field.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <utility>

#include "app/elements.h"
#include "app/interface_input.h"

namespace sectile::viewer {
namespace {

/// Has a click on the last item, without a drag, just ended? Then its number is to be typed.
bool was_clicked() {
  return ImGui::IsItemDeactivated() && !ImGui::IsItemDeactivatedAfterEdit() &&
         ImGui::IsItemHovered();
}

void begin(TypedField& typed, const std::string& name, const std::string& value) {
  typed = {name, value, value, false, false, true};
}

/// Draws the field in which a number is typed, in place of the one that is dragged. True when it
/// was entered; what cannot be read is told, and the field stays.
template <class Take>
bool draw_typing(PanelContext& context, const std::string& name, float width, const Take& take) {
  TypedField& typed = context.session.interface.typed;
  typed.is_drawn = true;
  ImGui::SetNextItemWidth(width);
  const bool entered =
      ImGui::InputText(("##typed" + name).c_str(), &typed.text,
                       ImGuiInputTextFlags_AutoSelectAll | ImGuiInputTextFlags_EnterReturnsTrue);
  context.widgets.record_item(name);
  if (ImGui::IsItemActive())
    typed.has_focus = true;
  else if (!typed.has_focus)
    ImGui::SetKeyboardFocusHere(-1);
  const bool tabbed = ImGui::IsItemActive() && interface_input::was_pressed(Key::tab);
  const bool left = typed.has_focus && ImGui::IsItemDeactivated();
  if (!entered && !tabbed && !left) return false;
  const bool given_up = left && interface_input::was_pressed(Key::escape);
  const bool changed = typed.text != typed.original && !given_up;
  try {
    if (changed) take(typed.text);
  } catch (const std::invalid_argument& error) {
    context.session.interface.messages.error("\"" + typed.text +
                                             "\" was not taken: " + error.what());
    if (entered)
      typed.has_focus = false;  // to be corrected
    else
      typed = {};
    return false;
  }
  typed = {};
  typed.wants_next = tabbed;
  return changed;
}

std::string signed_text(double value) {
  return (value < 0 ? " - " : " + ") + shortest(std::abs(value));
}

std::string written_out(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.15g", value);
  return text;
}

void check_range(double value, NumberRange range) {
  if (value < range.low)
    throw std::invalid_argument("It must be at least " + written_out(range.low) + ".");
  if (value > range.high)
    throw std::invalid_argument("It must be at most " + written_out(range.high) + ".");
}

double typed_in_range(const std::string& text, Quantity quantity, NumberRange range) {
  const double value = typed_number(text, quantity);
  check_range(value, range);
  return value;
}

/// Does the field that is drawn now take over the typing from the one before?
bool takes_over(TypedField& typed) {
  return std::exchange(typed.wants_next, false);
}

}  // namespace

Edited number_field(PanelContext& context, const std::string& name, double& value, double speed,
                    float width, Quantity quantity, NumberRange range, double beside) {
  TypedField& typed = context.session.interface.typed;
  const auto meant = [&] { return shortest(value) + (beside == 0 ? "" : signed_text(beside)); };
  if (takes_over(typed)) begin(typed, name, meant());
  Edited edited;
  if (typed.field == name) {
    edited.changing = edited.done = draw_typing(context, name, width, [&](const std::string& text) {
      value = typed_in_range(text, quantity, range);
    });
    return edited;
  }
  ImGui::SetNextItemWidth(width);
  double shown = value;
  edited.changing = ImGui::DragScalar(("##" + name).c_str(), ImGuiDataType_Double, &shown,
                                      static_cast<float>(speed), &range.low, &range.high, "%.6g",
                                      ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoInput);
  if (edited.changing) value = shown;
  edited.done = ImGui::IsItemDeactivatedAfterEdit();
  if (was_clicked()) begin(typed, name, meant());
  context.widgets.record_item(name);
  return edited;
}

Edited count_field(PanelContext& context, const std::string& name, std::uint32_t& value, int low,
                   int high, float width) {
  TypedField& typed = context.session.interface.typed;
  if (takes_over(typed)) begin(typed, name, std::to_string(value));
  Edited edited;
  if (typed.field == name) {
    edited.changing = edited.done = draw_typing(context, name, width, [&](const std::string& text) {
      const double whole = typed_in_range(text, Quantity::plain,
                                          {static_cast<double>(low), static_cast<double>(high)});
      if (whole != std::floor(whole)) throw std::invalid_argument("It must be a whole number.");
      value = static_cast<std::uint32_t>(whole);
    });
    return edited;
  }
  int whole = static_cast<int>(value);
  ImGui::SetNextItemWidth(width);
  edited.changing = ImGui::DragInt(("##" + name).c_str(), &whole, 0.25f, low, high, "%d",
                                   ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoInput);
  edited.done = ImGui::IsItemDeactivatedAfterEdit();
  if (edited.changing) value = static_cast<std::uint32_t>(whole);
  if (was_clicked()) begin(typed, name, std::to_string(value));
  context.widgets.record_item(name);
  return edited;
}

}  // namespace sectile::viewer
