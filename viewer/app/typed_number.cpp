#include "app/typed_number.h"

#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string_view>

namespace sectile::viewer {
namespace {

struct Unit {
  std::string_view name;
  Quantity quantity;
  long double factor;
};
// Longer names first: "mm" is not "m".
constexpr long double degrees_of_radian = 180 / std::numbers::pi_v<long double>;
constexpr std::array units{
    Unit{"mm", Quantity::length, 1},       Unit{"cm", Quantity::length, 10},
    Unit{"inch", Quantity::length, 25.4L}, Unit{"in", Quantity::length, 25.4L},
    Unit{"\"", Quantity::length, 25.4L},   Unit{"ft", Quantity::length, 304.8L},
    Unit{"m", Quantity::length, 1000},     Unit{"\u00B0", Quantity::angle, 1},
    Unit{"deg", Quantity::angle, 1},       Unit{"rad", Quantity::angle, degrees_of_radian},
    Unit{"%", Quantity::plain, 0.01L}};

/// Reads from left to right:
///   sum = product {(+|-) product}, product = factor {(*|/) factor},
///   factor = (+|-) factor | (number | pi | "(" sum ")") [unit]
class Reader {
 public:
  Reader(std::string_view text, Quantity quantity) : rest_(text), quantity_(quantity) {}

  double run() {
    skip_blanks();
    if (rest_.empty()) fail("A number is missing.");
    const long double value = sum();
    if (!rest_.empty()) fail("\"" + std::string(rest_) + "\" cannot be read.");
    const double made = static_cast<double>(value);
    if (!std::isfinite(made)) fail("That is no finite number.");
    return made;
  }

 private:
  [[noreturn]] static void fail(const std::string& what) { throw std::invalid_argument(what); }

  void skip_blanks() {
    while (!rest_.empty() && (rest_.front() == ' ' || rest_.front() == '\t'))
      rest_.remove_prefix(1);
  }

  bool take(std::string_view what) {
    if (!rest_.starts_with(what)) return false;
    rest_.remove_prefix(what.size());
    skip_blanks();
    return true;
  }

  long double sum() {
    long double value = product();
    for (;;) {
      if (take("+"))
        value += product();
      else if (take("-") || take("\u2212"))
        value -= product();
      else
        return value;
    }
  }

  long double product() {
    long double value = factor();
    for (;;) {
      if (take("*") || take("\u00D7")) {
        value *= factor();
      } else if (take("/")) {
        const long double by = factor();
        if (by == 0) fail("Nothing can be divided by zero.");
        value /= by;
      } else {
        return value;
      }
    }
  }

  long double factor() {
    // Not to the end of the stack for a line of a million brackets.
    if (++depth_ > 100) fail("That is too many brackets or signs.");
    long double value = 0;
    if (take("+"))
      value = factor();
    else if (take("-") || take("\u2212"))
      value = -factor();
    else
      value = with_unit(atom());
    --depth_;
    return value;
  }

  long double atom() {
    if (take("(")) {
      const long double value = sum();
      if (!take(")")) fail("A closing bracket is missing.");
      return value;
    }
    if (take("pi") || take("\u03C0")) return std::numbers::pi_v<long double>;
    return number();
  }

  long double number() {
    std::string digits;
    int marks = 0;
    const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
    while (!rest_.empty() &&
           (is_digit(rest_.front()) || rest_.front() == '.' || rest_.front() == ',')) {
      const bool is_mark = !is_digit(rest_.front());
      marks += is_mark;
      digits += is_mark ? '.' : rest_.front();
      rest_.remove_prefix(1);
    }
    if (marks > 1) fail("Use one decimal point or comma, and no marks between thousands.");
    if (digits.empty() || digits == ".")
      fail(rest_.empty() ? "A number is missing at the end."
                         : "\"" + std::string(rest_) + "\" is not a number.");
    digits += exponent();
    skip_blanks();
    long double value = 0;
    const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (read.ec != std::errc() || read.ptr != digits.data() + digits.size())
      fail("\"" + digits + "\" is not a number that can be held.");
    return value;
  }

  /// "e-12", if there is one.
  std::string exponent() {
    if (rest_.empty() || (rest_.front() != 'e' && rest_.front() != 'E')) return {};
    std::size_t length = 1;
    if (length < rest_.size() && (rest_[length] == '+' || rest_[length] == '-')) ++length;
    const std::size_t first = length;
    while (length < rest_.size() && rest_[length] >= '0' && rest_[length] <= '9') ++length;
    if (length == first) return {};
    std::string text(rest_.substr(0, length));
    rest_.remove_prefix(length);
    return text;
  }

  long double with_unit(long double value) {
    for (const Unit& unit : units) {
      if (!take(unit.name)) continue;
      if (unit.quantity != quantity_)
        fail("\"" + std::string(unit.name) + "\" is not a unit of " + name_of_quantity() + ".");
      return value * unit.factor;
    }
    return value;
  }

  const char* name_of_quantity() const {
    return quantity_ == Quantity::length  ? "length"
           : quantity_ == Quantity::angle ? "angles"
                                          : "a number without dimension";
  }

  std::string_view rest_;
  Quantity quantity_;
  int depth_ = 0;
};

}  // namespace

double typed_number(const std::string& text, Quantity quantity) {
  return Reader(text, quantity).run();
}

std::string shortest(double value) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value).ptr;
  return std::string(text, end);
}

}  // namespace sectile::viewer
