#include "viewer/random_person.h"

#include <array>
#include <vector>

namespace sectile::viewer {
namespace {

// Where the scene has grown to this, more of the events take steps back.
constexpr std::size_t many_nodes = 24;

bool leads_elsewhere(const std::string& name) {
  constexpr std::array<const char*, 17> starts{
      "menu.file", "menu:file.",   "file.",         "recent.", "sample:",   "menu.samples",
      "tour.",     "menu:tour.",   "browser",       "record.", "question.", "panel.",
      "handle.",   "menu:select.", "status.cancel", "legend",  "picture"};
  for (const char* start : starts)
    if (name.starts_with(start)) return true;
  return false;
}

}  // namespace

glm::dvec2 RandomPerson::in_picture() {
  const glm::vec4 r = driver_.app().widget("picture");
  // Mostly where the solids are.
  const double wide = one_in(4) ? 0.48 : 0.2;
  std::uniform_real_distribution<double> part(0.5 - wide, 0.5 + wide);
  const double x = part(random_), y = part(random_);
  return {r.x + x * r.z, r.y + y * r.w};
}

void RandomPerson::press_key() {
  constexpr std::array<Key, 12> others{Key::escape, Key::enter, Key::del, Key::tab,
                                       Key::left,   Key::right, Key::up,  Key::down,
                                       Key::space,  Key::home,  Key::end, Key::backspace};
  // Not with Ctrl: New, Open, Save, Quit, Export, Import.
  static constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZ1234567890/";
  static constexpr std::string_view with_control = "ACVXGZYDMHULB13";
  const bool shift = one_in(4), control = one_in(5);
  if (one_in(3)) {
    const Key key = others[below(others.size())];
    last_ = "key " + std::to_string(static_cast<int>(key));
    return driver_.short_key(key, false, shift);
  }
  const std::string_view from = control ? with_control : letters;
  const char letter = from[below(from.size())];
  last_ = std::string("key ") + (control ? "Ctrl+" : "") + (shift ? "Shift+" : "") + letter;
  driver_.short_key(static_cast<Key>(letter), control, shift && !(control && letter != 'Z'));
}

void RandomPerson::press_widget() {
  std::vector<std::string> names;
  for (const auto& [name, widget] : driver_.app().widgets().all())
    if (widget.enabled && !widget.surface && !leads_elsewhere(name)) names.push_back(name);
  if (names.empty()) return;
  const std::string& name = names[below(names.size())];
  last_ = "press " + name;
  const glm::dvec2 at = driver_.middle(name);
  if (name.starts_with("properties.") && one_in(2))
    driver_.short_drag(at, at + glm::dvec2(static_cast<double>(below(41)) - 20, 0),
                       MouseButton::left, false, false);
  else
    driver_.short_click(at, false);
}

void RandomPerson::drag() {
  glm::dvec2 from = in_picture();
  std::vector<std::string> handles;
  for (const auto& [name, widget] : driver_.app().widgets().all())
    if (name.starts_with("handle.")) handles.push_back(name);
  if (!handles.empty() && one_in(2)) from = driver_.middle(handles[below(handles.size())]);
  const glm::dvec2 to = in_picture();
  const std::size_t button = one_in(3) ? below(3) : 0;
  last_ = "drag by button " + std::to_string(button);
  driver_.short_drag(from, to, static_cast<MouseButton>(button), one_in(4), one_in(6));
}

void RandomPerson::undo_or_redo() {
  const bool redo = one_in(3);
  last_ = redo ? "redo" : "undo";
  driver_.short_key(static_cast<Key>(redo ? 'Y' : 'Z'), true, false);
}

void RandomPerson::act() {
  const Session& session = driver_.session();
  if (session.interface.dialogs.is_open() || session.interface.dialogs.recording ||
      session.interface.dialogs.about || session.interface.dialogs.keys) {
    last_ = "close a dialog";
    return driver_.short_key(Key::escape, false, false);
  }
  if (session.scene().size() > many_nodes && !one_in(4)) return undo_or_redo();
  switch (below(12)) {
    case 0:
    case 1:
    case 2:
      last_ = "click";
      return driver_.short_click(in_picture(), one_in(3));
    case 3:
    case 4:
      return drag();
    case 5:
    case 6:
      return press_key();
    case 7:
    case 8:
    case 9:
      return press_widget();
    case 10: {
      constexpr std::array<const char*, 6> words{"1", "2", "-", ".5", "3/2", "45"};
      const char* word = words[below(words.size())];
      last_ = std::string("type ") + word;
      Event event;
      event.kind = Event::Kind::text;
      event.text = word;
      return driver_.app().frame(Input{{event}}, 1.0 / 60);
    }
    default:
      return undo_or_redo();
  }
}

void RandomPerson::come_to_rest() {
  for (int i = 0; i < 8; ++i) driver_.key(Key::escape);
}

}  // namespace sectile::viewer
