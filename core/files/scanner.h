// Goes through a text that is in memory: lines, tokens and numbers, errors with the line's number.
#pragma once

#include <charconv>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

namespace sectile {

class Scanner {
 public:
  static constexpr int no_comments = -1;

  /// A token may not hold `comment_sign`; from there the line is passed over. With `joins_lines` a
  /// backslash before a line's end stands for a blank, and the line goes on in the next.
  Scanner(std::string_view text, std::string_view name, int comment_sign = '#',
          bool joins_lines = false)
      : at_(text.data()),
        end_(at_ + text.size()),
        name_(name),
        comment_sign_(comment_sign),
        joins_lines_(joins_lines) {}

  std::uint64_t line() const { return line_; }
  bool at_line_end() const { return at_ == end_ || is_line_end(*at_); }
  std::string_view rest() const { return {at_, static_cast<std::size_t>(end_ - at_)}; }

  [[noreturn]] void fail(const std::string& what) const { fail_at(line_, what); }
  [[noreturn]] void fail_at(std::uint64_t line, const std::string& what) const;

  /// The next token of this line; empty at its end.
  std::string_view token() {
    do
      while (at_ != end_ && is_blank(*at_)) ++at_;
    while (skip_joint());
    if (at_ != end_ && is_comment_sign(*at_)) skip_line();
    const char* first = at_;
    while (at_ != end_ && !is_blank(*at_) && !is_line_end(*at_) && !is_comment_sign(*at_) &&
           !is_joint())
      ++at_;
    return {first, static_cast<std::size_t>(at_ - first)};
  }

  /// Goes to the next line; lines end with LF, CR LF or CR. False at the end of the text.
  bool next_line() {
    skip_line();
    if (at_ == end_) return false;
    skip_line_end();
    return true;
  }

  /// The next token of this line or of the first later line that has one. `what` is missing if
  /// there is none.
  std::string_view token_on_any_line(const char* what);

  /// Fails if anything but blank lines and comments follows.
  void require_end(const std::string& what_ended);

  /// The finite double next to what the token says.
  double real(std::string_view token, const char* what) const {
    double value = 0;
    const char* end = token.data() + token.size();
    const auto [rest, error] = std::from_chars(without_plus(token), end, value);
    if (error != std::errc() || rest != end || !std::isfinite(value))
      return unusual_real(token, what);
    return value;
  }

  std::int64_t integer(std::string_view token, const char* what) const {
    std::int64_t value = 0;
    const char* end = token.data() + token.size();
    const auto [rest, error] = std::from_chars(token.data(), end, value);
    if (error != std::errc() || rest != end)
      fail_integer(token, what, error == std::errc::result_out_of_range && rest == end);
    return value;
  }

 private:
  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
  static bool is_line_end(char c) { return c == '\n' || c == '\r'; }
  bool is_comment_sign(char c) const { return static_cast<unsigned char>(c) == comment_sign_; }
  bool is_joint() const {
    return *at_ == '\\' && joins_lines_ && (at_ + 1 == end_ || is_line_end(at_[1]));
  }
  bool skip_joint() {
    if (at_ == end_ || !is_joint()) return false;
    ++at_;
    if (at_ != end_) skip_line_end();
    return true;
  }
  void skip_line_end() {
    if (*at_ == '\r' && at_ + 1 != end_ && at_[1] == '\n') ++at_;
    ++at_;
    ++line_;
  }
  void skip_line() {
    while (!at_line_end()) ++at_;
  }
  static const char* without_plus(std::string_view token) {
    const bool plus = token.size() > 1 && token[0] == '+' && token[1] != '-';
    return token.data() + (plus ? 1 : 0);
  }
  double unusual_real(std::string_view token, const char* what) const;
  [[noreturn]] void fail_integer(std::string_view token, const char* what, bool too_large) const;

  const char *at_, *end_;
  std::uint64_t line_ = 1;
  std::string name_;
  int comment_sign_;
  bool joins_lines_;
};

/// A token as messages show it: in quotes, not too long, only printable characters.
std::string in_quotes(std::string_view token);

}  // namespace sectile
