#include "import/diagnosis.h"

#include <charconv>

namespace sectile {

std::string in_words(const Vec3& p) {
  std::string text = "(";
  for (const double v : {p.x, p.y, p.z}) {
    char buffer[32];
    const auto end = std::to_chars(buffer, buffer + sizeof buffer, v).ptr;
    if (text.size() > 1) text += ", ";
    text.append(buffer, end);
  }
  return text + ")";
}

}  // namespace sectile
