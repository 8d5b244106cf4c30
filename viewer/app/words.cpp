#include "app/words.h"

#include <cctype>
#include <cstdio>

#include "app/icons.h"
#include "scene/primitive_kind.h"

namespace sectile::viewer {

std::string name_of(Operation operation) {
  switch (operation) {
    case Operation::unite:
      return "unite";
    case Operation::intersect:
      return "intersect";
    case Operation::subtract:
      return "subtract";
  }
  return {};
}

std::string sign_of(Operation operation) {
  switch (operation) {
    case Operation::unite:
      return "\u222A";
    case Operation::intersect:
      return "\u2229";
    case Operation::subtract:
      return "\\";
  }
  return {};
}

std::string icon_of(Operation operation) {
  switch (operation) {
    case Operation::unite:
      return icons::venn_union;
    case Operation::intersect:
      return icons::venn_intersection;
    case Operation::subtract:
      return icons::venn_difference;
  }
  return {};
}

std::string kind_of(const Node& node) {
  struct Kind {
    std::string operator()(const Primitive& p) const { return std::string(p.kind->name); }
    std::string operator()(const Imported&) const { return "mesh"; }
    std::string operator()(const BooleanNode& b) const {
      switch (b.operation) {
        case Operation::unite:
          return "union";
        case Operation::intersect:
          return "intersection";
        case Operation::subtract:
          return "difference";
      }
      return {};
    }
    std::string operator()(const SplitNode& s) const {
      return s.above ? "part above a plane" : "part below a plane";
    }
    std::string operator()(const Group&) const { return "group"; }
    std::string operator()(const Pattern& p) const {
      return p.kind == Pattern::Kind::mirror ? "mirror image" : "copies";
    }
  };
  return std::visit(Kind{}, node.what);
}

std::string title_of(Phase phase) {
  switch (phase) {
    case Phase::reduction:
      return "Contacts";
    case Phase::vertex_face:
      return "Vertex in face";
    case Phase::vertex_vertex:
      return "Vertex on vertex";
    case Phase::null_edges:
      return "Null edges";
    case Phase::joining:
      return "Joining";
    case Phase::components:
      return "Parts";
    case Phase::gluing:
      return "Gluing";
    case Phase::cleanup:
      return "Result";
  }
  return {};
}

std::string capitalised(std::string text) {
  if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.7g", value);
  return text;
}

std::string count(std::size_t n) {
  std::string digits = std::to_string(n);
  for (std::size_t at = digits.size(); at > 3;) {
    at -= 3;
    digits.insert(at, "\u00A0");
  }
  return digits;
}

std::string counted(std::size_t n, const std::string& thing) {
  return count(n) + " " + thing + (n == 1 ? "" : "s");
}

}  // namespace sectile::viewer
