#include "import/diagnosis.h"

#include <charconv>

namespace sectile {

namespace {

void append_number(std::string& text, double value) {
  char buffer[32];
  for (const char *c = buffer, *end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
       c != end; ++c)
    text += *c;
}

}  // namespace

std::string in_words(double value) {
  std::string text;
  append_number(text, value);
  return text;
}

std::string in_words(const Vec3& p) {
  std::string text = "(";
  for (const double v : {p.x, p.y, p.z}) {
    if (text.size() > 1) text += ", ";
    append_number(text, v);
  }
  return text + ")";
}

}  // namespace sectile
