// A tour of the paper in stations: each shows one thing with a scene, a step of it, the paper's own
// figure and a question.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sectile/trace.h"
#include "story/story.h"
#include "tour/figure.h"

namespace sectile::viewer {

struct Station {
  std::string title;
  /// Of the paper: "figure 5", "Table I, ∪", "Table II, row 4", "Table III, row 2", and phases as
  /// name_of() has them.
  std::vector<std::string> covers;
  std::string sample;
  Phase phase = Phase::reduction;
  std::string step;  ///< what the step's texts say; empty: the phase's last
  std::string text;  ///< at most 60 words
  Figure figure;
  std::string question, answer;
  double exploded = 0.2;
  bool eight_way = false;
};

/// In the order of the paper.
const std::vector<Station>& stations();

/// The step of a station in the story of its sample, counted from the story's first; nothing if
/// its phase has no step of which its words are true.
std::optional<std::size_t> step_of(const Station& station, const Story& story);

// The parts of stations().
std::vector<Station> stations_of_sections_1_to_3();
std::vector<Station> stations_of_sections_4_to_6();
std::vector<Station> stations_of_table_2();
std::vector<Station> stations_of_coincidences();

}  // namespace sectile::viewer
