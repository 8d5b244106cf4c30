// The tour of the paper, station by station.
#include "app/command_lists.h"
#include "app/icons.h"

namespace sectile::viewer {

std::vector<Command> tour_commands() {
  const auto on_tour = [](const InterfaceState& i) { return i.tour.is_on(); };
  return {
      {"tour.start",
       "Tour of the paper",
       "Goes through the paper station by station: each figure, each row of its tables, each "
       "phase.",
       icons::flag,
       {},
       [](Session& s) {
         s.after_saving("Start the tour", [&s] { s.interface.tour.go_to(s, 0); });
       }},
      {"tour.next",
       "Next station",
       "Goes on in the tour.",
       icons::step_forward,
       {{Key::right, true}},
       [](Session& s) { s.interface.tour.next(s); },
       [](const InterfaceState& i) {
         return i.tour.is_on() && i.tour.at() + 1 < TourGuide::count();
       }},
      {"tour.previous",
       "Station before",
       "Goes back in the tour.",
       icons::step_back,
       {{Key::left, true}},
       [](Session& s) { s.interface.tour.previous(s); },
       [](const InterfaceState& i) { return i.tour.is_on() && i.tour.at() > 0; }},
      {"tour.answer",
       "Answer",
       "Shows or hides the answer to the station's question.",
       "",
       {{Key::down, true}},
       [](InterfaceState& i) { i.tour.shows_answer = !i.tour.shows_answer; },
       on_tour,
       [](const InterfaceState& i) { return i.tour.shows_answer; }},
      {"tour.end",
       "End the tour",
       "The scene and the steps stay.",
       icons::cross,
       {},
       [](InterfaceState& i) { i.tour.end(); },
       on_tour},
  };
}

}  // namespace sectile::viewer
