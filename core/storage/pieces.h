// Of what pieces a block is.
#pragma once

#include <cstdint>
#include <vector>

#include "storage/compact_triangles.h"

namespace sectile {

/// The faces of a block that hang together over its edges.
class Pieces {
 public:
  Pieces() = default;
  /// `border_count`: see storage/block.h.
  Pieces(const Brep& brep, std::uint32_t border_count);
  explicit Pieces(const CompactTriangles& triangles);

  std::uint32_t count() const { return count_; }
  std::uint32_t of(FaceId f) const { return count_ == 1 ? 0 : of_face_[f.value()]; }
  /// Some face of a piece.
  FaceId face_of(std::uint32_t piece) const;

 private:
  void set(std::vector<std::uint32_t> of_face, std::uint32_t count);

  std::vector<std::uint32_t> of_face_;  // none for one piece
  std::uint32_t count_ = 0;
};

}  // namespace sectile
