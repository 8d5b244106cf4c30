// Consecutive numbers for all entities of an operand: vertices, then edges, then faces.
#pragma once

#include <cstddef>

#include "boolean/entity.h"
#include "topology/brep.h"

namespace sectile {

class EntityNumbers {
 public:
  EntityNumbers() = default;
  explicit EntityNumbers(const Brep& brep)
      : edges_from_(brep.vertex_count()),
        faces_from_(edges_from_ + brep.edge_count()),
        end_(faces_from_ + brep.face_count()) {}

  std::size_t operator[](Entity e) const {
    return e.index() + (e.is_vertex() ? 0 : e.is_edge() ? edges_from_ : faces_from_);
  }
  std::size_t size() const { return end_; }

 private:
  std::size_t edges_from_ = 0, faces_from_ = 0, end_ = 0;
};

}  // namespace sectile
