// Presses, drags and types anything anywhere, the same for the same seed.
#pragma once

#include <cstdint>
#include <random>
#include <string>

#include "viewer/app_driver.h"

namespace sectile::viewer {

/// Leaves out what ends the document or asks for a file: another scene has another history.
class RandomPerson {
 public:
  RandomPerson(AppDriver& driver, std::uint64_t seed) : driver_(driver), random_(seed) {}

  void act();           ///< one event: a click, a drag, a key, a word, a widget, the wheel
  void come_to_rest();  ///< gives up tools, menus and dialogs
  const std::string& last() const { return last_; }  ///< what act() did, in words

 private:
  std::size_t below(std::size_t count) {
    return std::uniform_int_distribution<std::size_t>(0, count - 1)(random_);
  }
  bool one_in(std::size_t count) { return below(count) == 0; }
  glm::dvec2 in_picture();
  void press_key();
  void press_widget();
  void drag();
  void undo_or_redo();

  AppDriver& driver_;
  std::mt19937_64 random_;
  std::string last_;
};

}  // namespace sectile::viewer
