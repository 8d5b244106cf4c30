#include "trace/json_text.h"

#include <charconv>
#include <cmath>
#include <string>

namespace sectile {

void JsonText::new_line() {
  out_ << '\n' << std::string(static_cast<std::size_t>(depth_), ' ');
}

void JsonText::before_value() {
  if (!is_member_ && depth_ > 0) {
    if (!is_first_) out_ << ',';
    new_line();
  }
  is_first_ = is_member_ = false;
}

void JsonText::begin(char bracket) {
  before_value();
  out_ << bracket;
  ++depth_;
  is_first_ = true;
}

void JsonText::end(char bracket) {
  --depth_;
  if (!is_first_) new_line();
  out_ << bracket;
  is_first_ = false;
}

void JsonText::name(std::string_view text) {
  before_value();
  quoted(text);
  out_ << ": ";
  is_member_ = true;
}

void JsonText::value(std::string_view text) {
  before_value();
  quoted(text);
}

void JsonText::value(double number) {
  if (!std::isfinite(number)) return plain("null");
  char digits[40];
  const char* end = std::to_chars(digits, digits + sizeof digits, number).ptr;
  const std::string_view text(digits, static_cast<std::size_t>(end - digits));
  plain(text);
  // Readers that tell integers from other numbers shall not see an integer by chance.
  if (text.find_first_of(".e") == std::string_view::npos) out_ << ".0";
}

void JsonText::value(int number) {
  plain(std::to_string(number));
}

void JsonText::value(std::size_t number) {
  plain(std::to_string(number));
}

void JsonText::plain(std::string_view text) {
  before_value();
  out_ << text;
}

void JsonText::quoted(std::string_view text) {
  constexpr char hexadecimal[] = "0123456789abcdef";
  out_ << '"';
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (code < 0x20)
      out_ << "\\u00" << hexadecimal[code / 16] << hexadecimal[code % 16];
    else if (c == '"' || c == '\\')
      out_ << '\\' << c;
    else
      out_ << c;
  }
  out_ << '"';
}

}  // namespace sectile
