#include "viewer/app_driver.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <stdexcept>

namespace sectile::viewer {
namespace {

constexpr double time_step = 1.0 / 60;

Event mouse(Event::Kind kind, glm::dvec2 at, MouseButton button, bool shift, bool control) {
  Event event;
  event.kind = kind;
  event.position = at;
  event.button = button;
  event.shift = shift;
  event.control = control;
  return event;
}

bool overlap(const glm::vec4& a, const glm::vec4& b) {
  // What is scrolled out of sight has no height.
  if (a.w <= 0 || b.w <= 0) return false;
  return a.x + 0.5f < b.x + b.z && b.x + 0.5f < a.x + a.z && a.y + 0.5f < b.y + b.w &&
         b.y + 0.5f < a.y + a.w;
}

/// Two scroll bars beside each other: which of them scrolls what?
std::string twin_scroll_bars() {
  std::string found;
  const ImGuiContext& context = *ImGui::GetCurrentContext();
  for (ImGuiWindow* first : context.Windows)
    for (ImGuiWindow* second : context.Windows) {
      if (first == second || !first->WasActive || !second->WasActive) continue;
      if (!first->ScrollbarY || !second->ScrollbarY) continue;
      const ImRect a = ImGui::GetWindowScrollbarRect(first, ImGuiAxis_Y),
                   b = ImGui::GetWindowScrollbarRect(second, ImGuiAxis_Y);
      if (a.Min.x <= b.Min.x && b.Min.x - a.Max.x < 20 && a.Min.y < b.Max.y && b.Min.y < a.Max.y)
        found += std::string("The scroll bars of ") + first->Name + " and " + second->Name +
                 " are side by side. ";
    }
  return found;
}

}  // namespace

AppOptions AppDriver::waiting() {
  AppOptions options;
  options.wait_for_results = options.fast_pictures = options.draw_on_request = true;
  return options;
}

AppOptions AppDriver::drawing() {
  AppOptions options = waiting();
  options.draw_on_request = false;
  return options;
}

AppDriver::AppDriver(int width, int height, float scale)
    : AppDriver(waiting(), width, height, scale) {}

AppDriver::AppDriver(const AppOptions& options, int width, int height, float scale)
    : context_(make_offscreen_context(width, height, scale)) {
  app_ = std::make_unique<App>(*context_, options);
  settle();
}

void AppDriver::send(std::initializer_list<Event> events) {
  app_->frame(Input{events}, time_step);
}

void AppDriver::settle(int frames) {
  for (int i = 0; i < frames; ++i) send({});
  app_->draw();
}

void AppDriver::move(glm::dvec2 to, bool shift, bool control) {
  send({mouse(Event::Kind::mouse_move, to, MouseButton::left, shift, control)});
}

void AppDriver::click(glm::dvec2 at, bool shift) {
  move(at, shift);
  send({mouse(Event::Kind::mouse_down, at, MouseButton::left, shift, false)});
  send({mouse(Event::Kind::mouse_up, at, MouseButton::left, shift, false)});
  // Longer than a double click.
  app_->frame({}, 0.6);
  settle();
}

void AppDriver::drag(glm::dvec2 from, glm::dvec2 to, MouseButton button, bool control, bool shift) {
  move(from, shift, control);
  send({mouse(Event::Kind::mouse_down, from, button, shift, control)});
  for (int i = 1; i <= 8; ++i) move(from + (to - from) * (i / 8.0), shift, control);
  send({mouse(Event::Kind::mouse_up, to, button, shift, control)});
  settle();
}

void AppDriver::hold(glm::dvec2 from, glm::dvec2 to, bool control) {
  move(from, false, control);
  send({mouse(Event::Kind::mouse_down, from, MouseButton::left, false, control)});
  for (int i = 1; i <= 4; ++i) move(from + (to - from) * (i / 4.0), false, control);
}

void AppDriver::let_go(glm::dvec2 at) {
  send({mouse(Event::Kind::mouse_up, at, MouseButton::left, false, false)});
  settle();
}

void AppDriver::short_key(Key key, bool control, bool shift) {
  Event event;
  event.kind = Event::Kind::key_down;
  event.key = key;
  event.control = control;
  event.shift = shift;
  Event up = event;
  up.kind = Event::Kind::key_up;
  send({event});
  send({up});
}

void AppDriver::short_click(glm::dvec2 at, bool shift) {
  send({mouse(Event::Kind::mouse_move, at, MouseButton::left, shift, false),
        mouse(Event::Kind::mouse_down, at, MouseButton::left, shift, false)});
  send({mouse(Event::Kind::mouse_up, at, MouseButton::left, shift, false)});
}

void AppDriver::short_drag(glm::dvec2 from, glm::dvec2 to, MouseButton button, bool control,
                           bool shift) {
  send({mouse(Event::Kind::mouse_move, from, button, shift, control),
        mouse(Event::Kind::mouse_down, from, button, shift, control)});
  for (const double part : {0.4, 1.0})
    send({mouse(Event::Kind::mouse_move, from + (to - from) * part, button, shift, control)});
  send({mouse(Event::Kind::mouse_up, to, button, shift, control)});
}

void AppDriver::drag_and_key(glm::dvec2 from, glm::dvec2 to, char letter, bool control) {
  Event press;
  press.kind = Event::Kind::key_down;
  press.key = static_cast<Key>(letter);
  press.control = control;
  Event release = press;
  release.kind = Event::Kind::key_up;
  using Kind = Event::Kind;
  const auto by_mouse = [](Kind kind, glm::dvec2 at) {
    return mouse(kind, at, MouseButton::left, false, false);
  };
  send({by_mouse(Kind::mouse_move, from), by_mouse(Kind::mouse_down, from),
        by_mouse(Kind::mouse_move, to), by_mouse(Kind::mouse_up, to), press, release});
  settle(8);
}

void AppDriver::double_click(glm::dvec2 at) {
  move(at);
  for (int i = 0; i < 2; ++i) {
    send({mouse(Event::Kind::mouse_down, at, MouseButton::left, false, false)});
    send({mouse(Event::Kind::mouse_up, at, MouseButton::left, false, false)});
  }
  app_->frame({}, 0.6);
  settle();
}

void AppDriver::enter(const std::string& field, const std::string& text, Key end) {
  double_click(middle(field));
  if (!text.empty()) type(text);
  key(end);
}

glm::dvec2 AppDriver::middle(const std::string& name) const {
  const glm::vec4 r = app_->widget(name);
  return {r.x + r.z / 2, r.y + r.w / 2};
}

void AppDriver::key(Key key, bool control, bool shift) {
  Event event;
  event.key = key;
  event.control = control;
  event.shift = shift;
  event.kind = Event::Kind::key_down;
  send({event});
  event.kind = Event::Kind::key_up;
  event.control = event.shift = false;
  send({event});
  settle();
}

void AppDriver::type(const std::string& text) {
  Event event;
  event.kind = Event::Kind::text;
  event.text = text;
  send({event});
  settle(2);
}

void AppDriver::type_file(const std::filesystem::path& file) {
  press("browser.name");
  key('A', true);
  type(file.string());
}

void AppDriver::enter_file(const std::filesystem::path& file) {
  type_file(file);
  key(Key::enter);
}

void AppDriver::accept_file(const std::filesystem::path& file) {
  type_file(file);
  press("browser.accept");
}

void AppDriver::drop(const std::filesystem::path& file) {
  Event event;
  event.kind = Event::Kind::drop;
  event.files = {file};
  send({event});
  settle();
}

void AppDriver::add(const std::string& shape) {
  press("tool.add");
  press("menu:add." + shape);
}

const Story& AppDriver::open_steps(const std::string& sample) {
  app_->open_sample(sample);
  settle();
  key(Key::tab);
  const Story* story = session().results.player.story();
  if (!story) throw std::runtime_error("The steps of " + sample + " were not computed.");
  return *story;
}

std::string AppDriver::faults() const {
  std::string found;
  const auto& all = app_->widgets().all();
  const float right = static_cast<float>(context_->width()) / context_->scale(),
              bottom = static_cast<float>(context_->height()) / context_->scale();
  for (const auto& [name, widget] : all) {
    if (widget.clipped) found += name + " is cut off. ";
    const glm::vec4& r = widget.seen;
    if (!widget.surface && r.w > 0 &&
        (r.x < -0.5f || r.y < -0.5f || r.x + r.z > right + 0.5f || r.y + r.w > bottom + 0.5f))
      found += name + " leaves the window. ";
    for (const auto& [other, second] : all)
      // A text may have a name of its own, too.
      if (name < other && !widget.surface && !second.surface &&
          !(other.starts_with("text:") && widget.rectangle == second.rectangle) &&
          widget.floating == second.floating && overlap(widget.seen, second.seen))
        found += name + " and " + other + " overlap. ";
    // Boxes over the picture.
    for (const char* box : {"panel.tool", "panel.view", "panel.message.0", "panel.message.1"})
      if (const Widget* second = app_->widgets().find(box);
          name == "legend" && second && overlap(widget.seen, second->seen))
        found += name + " and " + box + " overlap. ";
  }
  return found + twin_scroll_bars();
}

}  // namespace sectile::viewer
