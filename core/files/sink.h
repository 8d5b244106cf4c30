// Collects what a writer writes and hands it on in large pieces.
#pragma once

#include <charconv>
#include <concepts>
#include <cstring>
#include <functional>
#include <string>
#include <string_view>

#include "sectile/mesh.h"

namespace sectile {

class Sink {
 public:
  using HandOn = std::function<void(std::string_view)>;

  explicit Sink(HandOn hand_on) : hand_on_(std::move(hand_on)) { buffer_.reserve(full + 64); }

  /// Hands on what is left.
  void finish() {
    hand_on_(buffer_);
    buffer_.clear();
  }

  Sink& operator<<(std::string_view text) {
    buffer_ += text;
    return relieved();
  }
  Sink& operator<<(char c) {
    buffer_ += c;
    return *this;
  }
  /// The shortest text that reads back as the same double.
  Sink& operator<<(double value) { return number(value); }
  /// The same for floats, which takes fewer digits.
  Sink& operator<<(float value) { return number(value); }
  Sink& operator<<(std::integral auto value) { return number(value); }
  Sink& operator<<(const Vec3& p) { return *this << p.x << ' ' << p.y << ' ' << p.z; }

  /// The value's bytes as they are in memory.
  template <class T>
  Sink& bytes(const T& value) {
    char raw[sizeof(T)];
    std::memcpy(raw, &value, sizeof(T));
    buffer_.append(raw, sizeof(T));
    return relieved();
  }

 private:
  static constexpr std::size_t full = 1 << 16;

  template <class T>
  Sink& number(T value) {
    char digits[40];
    buffer_.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
    return relieved();
  }
  Sink& relieved() {
    if (buffer_.size() >= full) finish();
    return *this;
  }

  HandOn hand_on_;
  std::string buffer_;
};

}  // namespace sectile
