#include "app/messages.h"

#include <algorithm>

namespace sectile::viewer {
namespace {
constexpr std::size_t most_shown = 3;
constexpr double reading_time = 6;
}  // namespace

void Messages::tell(std::string text) {
  add({std::move(text), false, reading_time});
}

void Messages::error(std::string text) {
  add({std::move(text), true, 0});
}

void Messages::add(Message message) {
  last_ = message.text;
  std::erase_if(shown_, [&](const Message& m) { return m.text == message.text; });
  shown_.push_back(std::move(message));
  if (shown_.size() > most_shown) shown_.erase(shown_.begin());
}

void Messages::pass(double seconds) {
  for (Message& message : shown_) message.seconds_left -= seconds;
  std::erase_if(shown_, [](const Message& m) { return !m.is_error && m.seconds_left <= 0; });
}

void Messages::close(std::size_t index) {
  if (index < shown_.size()) shown_.erase(shown_.begin() + static_cast<std::ptrdiff_t>(index));
}

bool Messages::is_fading() const {
  return std::any_of(shown_.begin(), shown_.end(), [](const Message& m) { return !m.is_error; });
}

}  // namespace sectile::viewer
