#include "story/wording.h"

#include <cctype>
#include <cstdio>

namespace sectile::viewer {

std::string with_kind(const TraceEntity& entity) {
  return std::string(word_for(entity.kind)) + " " + name_of(entity);
}

std::string of_solid(int solid, const TraceEntity& entity) {
  return with_kind(entity) + (solid == 0 ? " of A" : " of B");
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

std::string counted(std::size_t number, std::string_view one) {
  const std::string start = std::to_string(number) + " ";
  if (number == 1) return start + std::string(one);
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
