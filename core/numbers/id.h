// Typed 32-bit indices: a vertex cannot be taken for a face, and each prints as itself (v12, f7).
#pragma once

#include <compare>
#include <cstdint>
#include <functional>
#include <ostream>

namespace sectile {

template <class Tag>
class Id {
 public:
  constexpr Id() = default;
  constexpr explicit Id(std::uint32_t value) : value_(value) {}
  constexpr explicit Id(std::size_t value) : value_(static_cast<std::uint32_t>(value)) {}
  constexpr explicit Id(int value) : value_(static_cast<std::uint32_t>(value)) {}

  constexpr std::uint32_t value() const { return value_; }
  constexpr bool valid() const { return value_ != none; }
  friend constexpr auto operator<=>(Id, Id) = default;
  friend std::ostream& operator<<(std::ostream& out, Id id) {
    return id.valid() ? out << Tag::letter << id.value_ : out << Tag::letter << '-';
  }

 private:
  static constexpr std::uint32_t none = 0xFFFFFFFFu;
  std::uint32_t value_ = none;
};

struct PointTag {
  static constexpr char letter = 'p';
};
struct PlaneTag {
  static constexpr char letter = 's';
};
struct VertexTag {
  static constexpr char letter = 'v';
};
struct HalfEdgeTag {
  static constexpr char letter = 'h';
};
struct EdgeTag {
  static constexpr char letter = 'e';
};
struct LoopTag {
  static constexpr char letter = 'l';
};
struct FaceTag {
  static constexpr char letter = 'f';
};

using PointId = Id<PointTag>;
using PlaneId = Id<PlaneTag>;
using VertexId = Id<VertexTag>;
using HalfEdgeId = Id<HalfEdgeTag>;
using EdgeId = Id<EdgeTag>;
using LoopId = Id<LoopTag>;
using FaceId = Id<FaceTag>;

}  // namespace sectile
