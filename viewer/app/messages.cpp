#include "app/messages.h"

#include <algorithm>

namespace sectile::viewer {
namespace {

constexpr std::size_t most_shown = 3;
constexpr std::size_t most_kept = 1000;
constexpr double reading_time = 6;

/// What exceptions say ends without a full stop.
std::string as_sentence(std::string text) {
  while (!text.empty() && (text.back() == ' ' || text.back() == '\n')) text.pop_back();
  const auto ends_in = [&](const char* mark) { return text.ends_with(mark); };
  if (!text.empty() && !ends_in(".") && !ends_in("!") && !ends_in("?") && !ends_in("\u2026"))
    text += '.';
  return text;
}

}  // namespace

void Messages::tell(std::string text) {
  add({as_sentence(std::move(text)), false, reading_time, std::chrono::system_clock::now()});
}

void Messages::error(std::string text) {
  add({as_sentence(std::move(text)), true, 0, std::chrono::system_clock::now()});
}

void Messages::add(Message message) {
  last_ = message.text;
  all_.push_back(message);
  if (all_.size() > most_kept) all_.erase(all_.begin());
  std::erase_if(shown_, [&](const Message& m) { return m.text == message.text; });
  shown_.push_back(std::move(message));
  if (shown_.size() <= most_shown) return;
  // What vanishes by itself gives way first.
  auto least =
      std::find_if(shown_.begin(), shown_.end(), [](const auto& m) { return !m.is_error; });
  if (least == shown_.end()) least = shown_.begin();
  waiting_ += least->is_error;
  shown_.erase(least);
}

void Messages::pass(double seconds) {
  for (Message& message : shown_) message.seconds_left -= seconds;
  std::erase_if(shown_, [](const Message& m) { return !m.is_error && m.seconds_left <= 0; });
}

void Messages::close(std::size_t index) {
  if (index < shown_.size()) shown_.erase(shown_.begin() + static_cast<std::ptrdiff_t>(index));
  if (shown_.empty()) waiting_ = 0;
}

void Messages::close_all() {
  shown_.clear();
  waiting_ = 0;
}

bool Messages::is_fading() const {
  return std::any_of(shown_.begin(), shown_.end(), [](const Message& m) { return !m.is_error; });
}

}  // namespace sectile::viewer
