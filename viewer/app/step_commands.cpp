// The commands that change to the steps of the algorithm and walk through them.
#include "app/command_lists.h"
#include "app/icons.h"

namespace sectile::viewer {

std::vector<Command> step_commands() {
  const auto in_steps = [](const Session& s) {
    return s.mode() == Mode::steps && s.results.player.story() != nullptr;
  };
  const auto change_phase = [](StoryPlayer& player, int by) {
    const int phase = static_cast<int>(player.phase()) + by;
    if (phase >= 0 && phase <= static_cast<int>(Phase::cleanup))
      player.go_to(static_cast<Phase>(phase), 0);
  };
  return {
      {"mode.model",
       "Model",
       "Place solids and combine them.",
       icons::cubes,
       {},
       [](Session& s) { s.set_mode(Mode::model); },
       {},
       [](const Session& s) { return s.mode() == Mode::model; }},
      {"mode.steps",
       "Steps",
       "Watch how the result of an operation comes about.",
       icons::list,
       {},
       [](Session& s) { s.set_mode(Mode::steps); },
       {},
       [](const Session& s) { return s.mode() == Mode::steps; }},
      {"mode.toggle",
       "Model or steps",
       "Changes between placing solids and watching the steps.",
       "",
       {{Key::tab}},
       [](Session& s) { s.set_mode(s.mode() == Mode::model ? Mode::steps : Mode::model); }},
      Command{"steps.previous",
              "Step back",
              "One step back.",
              icons::step_back,
              {{Key::left}},
              [](Results& r) { r.player.previous(); },
              in_steps}
          .after_line(),
      {"steps.next",
       "Step forward",
       "One step forward.",
       icons::step_forward,
       {{Key::right}},
       [](Results& r) { r.player.next(); },
       in_steps},
      {"steps.play",
       "Play",
       "Plays the steps, or stops.",
       icons::play,
       {{Key::space}},
       [](Results& r) { r.player.play(!r.player.is_playing()); },
       in_steps,
       [](const Results& r) { return r.player.is_playing(); }},
      Command{"steps.next_special",
              "Next special case",
              "To the next step at which something touches instead of crossing.",
              icons::star,
              {{'N'}},
              [](Session& s) {
                if (!s.results.player.next_special(false))
                  s.interface.messages.tell("No further special case.");
              },
              in_steps}
          .after_line(),
      {"steps.previous_special",
       "Previous special case",
       "Back to the special case before.",
       "",
       {{'N', false, true}},
       [](Session& s) {
         if (!s.results.player.next_special(true))
           s.interface.messages.tell("No special case before this one.");
       },
       in_steps},
      {"steps.special_only",
       "Special cases only",
       "Stepping and playing pass over plain crossings.",
       icons::filter,
       {},
       [](Results& r) { r.player.special_only = !r.player.special_only; },
       in_steps,
       [](const Results& r) { return r.player.special_only; }},
      {"steps.next_stop",
       "To the next break point",
       "To the next step that a break point names.",
       icons::flag,
       {{'B'}},
       [](Session& s) {
         if (s.results.player.stops.empty())
           s.interface.messages.tell("Choose break points first: they are in the time line.");
         else if (!s.results.player.next_stop())
           s.interface.messages.tell("No further step matches a break point.");
       },
       in_steps},
      {"steps.next_phase",
       "Next phase",
       "To the first step of the next phase.",
       "",
       {{Key::page_down}},
       [change_phase](Results& r) { change_phase(r.player, 1); },
       in_steps},
      {"steps.previous_phase",
       "Previous phase",
       "To the first step of the phase before.",
       "",
       {{Key::page_up}},
       [change_phase](Results& r) { change_phase(r.player, -1); },
       in_steps},
      {"steps.follow",
       "Camera follows",
       "The camera goes to the place of each step.",
       icons::crosshairs,
       {{'C'}},
       [](ViewState& v) { v.follow_steps = !v.follow_steps; },
       in_steps,
       [](const ViewState& v) { return v.follow_steps; }},
  };
}

}  // namespace sectile::viewer
