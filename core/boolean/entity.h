// A vertex, an edge or a face of one operand, as one number; contacts are pairs of them.
#pragma once

#include <compare>
#include <cstdint>
#include <ostream>

#include "numbers/id.h"

namespace sectile {

class Entity {
 public:
  enum class Kind : std::uint32_t { vertex, edge, face, nothing };

  constexpr Entity() = default;
  constexpr Entity(VertexId v) : code_(v.value()) {}
  constexpr Entity(EdgeId e) : code_(e.value() | 1u << 30) {}
  constexpr Entity(FaceId f) : code_(f.value() | 2u << 30) {}

  constexpr Kind kind() const { return static_cast<Kind>(code_ >> 30); }
  constexpr bool is_vertex() const { return kind() == Kind::vertex; }
  constexpr bool is_edge() const { return kind() == Kind::edge; }
  constexpr bool is_face() const { return kind() == Kind::face; }
  constexpr bool is_nothing() const { return kind() == Kind::nothing; }
  constexpr VertexId vertex() const { return VertexId(index()); }
  constexpr EdgeId edge() const { return EdgeId(index()); }
  constexpr FaceId face() const { return FaceId(index()); }
  constexpr std::uint32_t index() const { return code_ & 0x3FFFFFFFu; }
  constexpr std::uint32_t code() const { return code_; }
  friend constexpr auto operator<=>(Entity, Entity) = default;

 private:
  std::uint32_t code_ = 3u << 30;
};

inline std::ostream& operator<<(std::ostream& out, Entity e) {
  switch (e.kind()) {
    case Entity::Kind::vertex:
      return out << e.vertex();
    case Entity::Kind::edge:
      return out << e.edge();
    case Entity::Kind::face:
      return out << e.face();
    case Entity::Kind::nothing:
      break;
  }
  return out << "nothing";
}

}  // namespace sectile
