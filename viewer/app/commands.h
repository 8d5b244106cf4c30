// Everything that menus, tool bar and keys can do, once: name, words, icon, key, condition, action.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "app/session.h"
#include "events/input.h"

namespace sectile::viewer {

struct Shortcut {
  constexpr Shortcut(Key of, bool with_control = false, bool with_shift = false)
      : key(of), control(with_control), shift(with_shift) {}
  /// A printable key by its upper-case character.
  constexpr Shortcut(char of, bool with_control = false, bool with_shift = false)
      : Shortcut(static_cast<Key>(of), with_control, with_shift) {}

  Key key;
  bool control, shift;
};

/// A function of a session, or of those of its parts alone that it takes: so a command says what it
/// needs.
template <class Result, class SessionType>
class OfSession {
  template <class Part>
  using Like = std::conditional_t<std::is_const_v<SessionType>, const Part, Part>;

 public:
  OfSession() = default;
  template <class Function>
  requires(!std::is_same_v<std::decay_t<Function>, OfSession>) OfSession(Function function) {
    if constexpr (std::is_invocable_v<Function, SessionType&>)
      call_ = function;
    else if constexpr (std::is_invocable_v<Function, Like<Document>&>)
      call_ = [function](SessionType& s) { return function(s.document); };
    else if constexpr (std::is_invocable_v<Function, Like<Results>&>)
      call_ = [function](SessionType& s) { return function(s.results); };
    else if constexpr (std::is_invocable_v<Function, Like<ViewState>&>)
      call_ = [function](SessionType& s) { return function(s.view); };
    else
      call_ = [function](SessionType& s) { return function(s.interface); };
  }
  explicit operator bool() const { return static_cast<bool>(call_); }
  Result operator()(SessionType& session) const { return call_(session); }

 private:
  std::function<Result(SessionType&)> call_;
};

struct Command {
  std::string name;   ///< "edit.undo"; also the widget's name
  std::string title;  ///< in menus and on the tool bar
  std::string help;   ///< one sentence for the tooltip
  std::string icon;   ///< UTF-8
  std::vector<Shortcut> keys;
  OfSession<void, Session> run;
  OfSession<bool, const Session> can_run = {};  ///< empty: always
  OfSession<bool, const Session> is_on = {};    ///< empty: not a switch
  bool in_menu = true;
  bool begins_group = false;  ///< a line before it in the menu
  std::string submenu = {};   ///< neighbours with the same one stand in it together

  /// The same, with a line before it in the menu.
  Command after_line() &&;
  Command hidden() &&;  ///< the same, in no menu
};

/// The commands of one menu, in its order.
struct CommandMenu {
  std::string name;  ///< of the widget: "menu.edit"
  std::string title;
  std::vector<Command> commands;
};

class Commands {
 public:
  Commands();
  const std::vector<CommandMenu>& menus() const { return menus_; }
  const Command& get(std::string_view name) const;  ///< throws std::out_of_range
  /// Runs what the key stands for; false if it stands for nothing.
  bool press(Session& session, const Event& key_down) const;
  void run(Session& session, const Command& command) const;

 private:
  std::vector<CommandMenu> menus_;
};

/// "Ctrl+Shift+Z"; empty if there is no key.
std::string key_name(const Command& command);
std::string key_names(const Command& command);  ///< all of them: "Ctrl+Shift+Z, Ctrl+Y"
bool is_enabled(const Command& command, const Session& session);

}  // namespace sectile::viewer
