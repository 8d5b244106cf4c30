#include "story/wording.h"

#include <cctype>
#include <cstdio>

namespace sectile::viewer {

std::string with_kind(std::string_view entity) {
  const char letter = entity.empty() ? ' ' : entity[0];
  const char* kind = letter == 'v' ? "vertex " : letter == 'e' ? "edge " : "face ";
  return kind + std::string(entity);
}

std::string of_solid(int solid, std::string_view entity) {
  return with_kind(entity) + (solid == 0 ? " of A" : " of B");
}

std::string part_name(int solid, std::string_view code) {
  return (solid == 0 ? "A" : "B") + std::string(code.substr(0, code.starts_with("on") ? 2 : 3)) +
         (solid == 0 ? "B" : "A") + std::string(code.starts_with("on") ? code.substr(2) : "");
}

std::string sign(Operation operation) {
  switch (operation) {
    case Operation::unite:
      return "∪";
    case Operation::intersect:
      return "∩";
    case Operation::subtract:
      break;
  }
  return "\\";
}

std::string formula(Operation operation) {
  return "A " + sign(operation) + " B";
}

std::string equation_4(Operation operation) {
  switch (operation) {
    case Operation::unite:
      return "By equation (4) the boundary of A ∪ B is AoutB glued to BoutA.";
    case Operation::intersect:
      return "By equation (4) the boundary of A ∩ B is AinB glued to BinA.";
    case Operation::subtract:
      break;
  }
  return "By equation (4) the boundary of A \\ B is AoutB glued to BinA turned inside out.";
}

std::string counted(std::string_view number, std::string_view one) {
  const std::string start = std::string(number) + " ";
  if (number == "1") return start + std::string(one);
  return start + (one == "vertex" ? "vertices" : std::string(one) + "s");
}

std::string capital(std::string text) {
  if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

std::string coordinates(const Vec3& point) {
  char text[96];
  std::snprintf(text, sizeof text, "(%.6g, %.6g, %.6g)", point.x, point.y, point.z);
  return text;
}

}  // namespace sectile::viewer
