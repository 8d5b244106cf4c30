// Reads text files that are in memory: tokens, numbers and line numbers.
#pragma once

#include <charconv>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

#include "sectile/errors.h"

namespace sectile {

class Scanner {
 public:
  Scanner(std::string_view text, std::string_view name)
      : at_(text.data()), end_(at_ + text.size()), name_(name) {}

  bool at_end() const { return at_ == end_; }
  std::uint64_t line() const { return line_; }

  [[noreturn]] void fail(const std::string& what) const {
    throw FileError(name_ + ":" + std::to_string(line_) + ": " + what);
  }

  /// The next token on this line; empty at its end. `comment` starts a comment.
  std::string_view token(char comment = '#') {
    while (at_ != end_ && is_blank(*at_)) ++at_;
    if (at_ != end_ && *at_ == comment)
      while (at_ != end_ && *at_ != '\n') ++at_;
    const char* first = at_;
    while (at_ != end_ && *at_ != '\n' && !is_blank(*at_) && *at_ != comment) ++at_;
    return {first, static_cast<std::size_t>(at_ - first)};
  }

  /// Goes to the next line. False at the end of the file.
  bool next_line() {
    while (at_ != end_ && *at_ != '\n') ++at_;
    if (at_ == end_) return false;
    ++at_;
    ++line_;
    return true;
  }

  /// The next token, on this or a later line. Fails at the end of the file.
  std::string_view any_token(const char* what) {
    for (;;) {
      if (const std::string_view t = token(); !t.empty()) return t;
      if (!next_line()) fail(std::string("the file ends where ") + what + " is expected");
    }
  }

  double real(std::string_view t, const char* what) const {
    double value = 0;
    const char* first = t.data();
    if (!t.empty() && t[0] == '+') ++first;
    const auto [rest, error] = std::from_chars(first, t.data() + t.size(), value);
    if (t.empty()) fail(std::string(what) + " is missing");
    if (error == std::errc::result_out_of_range)
      fail(std::string(what) + " \"" + std::string(t) + "\" is outside the range of doubles");
    if (error != std::errc() || rest != t.data() + t.size())
      fail(std::string(what) + " \"" + std::string(t) + "\" is not a number");
    if (!std::isfinite(value))
      fail(std::string(what) + " \"" + std::string(t) + "\" is not finite");
    return value;
  }

  std::int64_t integer(std::string_view t, const char* what) const {
    std::int64_t value = 0;
    const auto [rest, error] = std::from_chars(t.data(), t.data() + t.size(), value);
    if (t.empty()) fail(std::string(what) + " is missing");
    if (error != std::errc() || rest != t.data() + t.size())
      fail(std::string(what) + " \"" + std::string(t) + "\" is not an integer");
    return value;
  }

 private:
  static bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
  }

  const char *at_, *end_;
  std::uint64_t line_ = 1;
  std::string name_;
};

}  // namespace sectile
