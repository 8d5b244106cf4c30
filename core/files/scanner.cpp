#include "files/scanner.h"

#include <locale.h>

#include <cstdlib>

#include "sectile/errors.h"

namespace sectile {

void Scanner::fail_at(std::uint64_t line, const std::string& what) const {
  throw FileError(name_ + ":" + std::to_string(line) + ": " + what);
}

std::string_view Scanner::token_on_any_line(const char* what) {
  for (;;) {
    if (const std::string_view found = token(); !found.empty()) return found;
    if (!next_line()) fail(std::string("the file ends where ") + what + " is expected");
  }
}

void Scanner::require_end(const std::string& what_ended) {
  do {
    if (const std::string_view more = token(); !more.empty())
      fail(in_quotes(more) + " follows after " + what_ended);
  } while (next_line());
}

// What from_chars does not take as it is: missing, junk, not finite, too large or next to zero.
double Scanner::unusual_real(std::string_view token, const char* what) const {
  if (token.empty()) fail(std::string(what) + " is missing");
  double value = 0;
  const char* end = token.data() + token.size();
  const auto [rest, error] = std::from_chars(without_plus(token), end, value);
  if (error == std::errc::invalid_argument || rest != end)
    fail(std::string(what) + " " + in_quotes(token) + " is not a number");
  if (error == std::errc::result_out_of_range) {
    // from_chars does not tell numbers that round to zero from those that are too large.
    static const locale_t plain = newlocale(LC_ALL_MASK, "C", nullptr);
    value = strtod_l(std::string(token).c_str(), nullptr, plain);
    if (!std::isfinite(value))
      fail(std::string(what) + " " + in_quotes(token) + " is outside the range of doubles");
  }
  if (!std::isfinite(value)) fail(std::string(what) + " " + in_quotes(token) + " is not finite");
  return value;
}

void Scanner::fail_integer(std::string_view token, const char* what, bool too_large) const {
  if (token.empty()) fail(std::string(what) + " is missing");
  fail(std::string(what) + " " + in_quotes(token) +
       (too_large ? " is too large" : " is not an integer"));
}

std::string in_quotes(std::string_view token) {
  constexpr std::size_t longest = 40;
  std::string text = "\"";
  for (const char c : token.substr(0, longest)) text += c >= ' ' && c <= '~' ? c : '?';
  return text + (token.size() > longest ? "...\"" : "\"");
}

}  // namespace sectile
