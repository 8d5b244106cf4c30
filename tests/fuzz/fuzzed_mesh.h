// Bytes to meshes of which many are solids: cells, tetrahedra, boxes and soups on a small lattice,
// then changed here and there.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "sectile/mesh.h"

namespace sectile {

/// The bytes in order; zeros when there are none left.
class Bytes {
 public:
  explicit Bytes(std::span<const std::uint8_t> data) : data_(data) {}
  bool empty() const { return next_ == data_.size(); }
  unsigned take() { return empty() ? 0u : data_[next_++]; }
  /// 0 … count - 1
  unsigned below(unsigned count) { return take() % count; }

 private:
  std::span<const std::uint8_t> data_;
  std::size_t next_ = 0;
};

PolygonMesh fuzzed_mesh(Bytes& bytes);

}  // namespace sectile
