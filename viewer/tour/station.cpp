#include "tour/station.h"

#include <iterator>

namespace sectile::viewer {
namespace {

std::string all_texts(const Step& step) {
  std::string text = step.title + "\n" + step.words;
  for (const std::string& bullet : step.bullets) text += "\n" + bullet;
  return text;
}

}  // namespace

const std::vector<Station>& stations() {
  static const std::vector<Station> all = [] {
    std::vector<Station> made;
    for (auto* part : {stations_of_sections_1_to_3, stations_of_sections_4_to_6,
                       stations_of_table_2, stations_of_coincidences}) {
      std::vector<Station> some = part();
      made.insert(made.end(), std::make_move_iterator(some.begin()),
                  std::make_move_iterator(some.end()));
    }
    return made;
  }();
  return all;
}

std::optional<std::size_t> step_of(const Station& station, const Story& story) {
  const auto [first, last] = story.range(station.phase);
  if (first == last) return std::nullopt;
  if (station.step.empty()) return last - 1;
  for (std::size_t i = first; i < last; ++i)
    if (all_texts(story.step(i)).find(station.step) != std::string::npos) return i;
  return std::nullopt;
}

}  // namespace sectile::viewer
