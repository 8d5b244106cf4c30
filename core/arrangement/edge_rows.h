// What is around a line along which very many edges run, all with ends of their own.
#pragma once

#include <vector>

#include "arrangement/sub_faces.h"

namespace sectile::arrangement {

/// The half-planes around such a line. Where an edge ends, nearly all that is around the line stays
/// as it is.
struct EdgeRow {
  struct Side {
    std::uint32_t corner;
    bool forward;             ///< runs along the line: what is before the sub-face comes after it
    std::uint32_t from, to;   ///< places; from < to
    std::uint32_t direction;  ///< the number of the first side that has this direction
  };
  std::vector<PointId> places;  ///< along the line
  std::vector<Side> sides;      ///< counter-clockwise
};

/// The rows of all edges of sub-faces that belong to one; `face_of` has the sub-face of each
/// corner.
std::vector<EdgeRow> find_rows(const SubFaces& faces, const std::vector<std::uint32_t>& face_of,
                               const Kernel& kernel);

/// A side and the next one, counter-clockwise, from one place to another.
struct Neighbours {
  std::uint32_t side, next;
  std::uint32_t from, to;
};

/// All that there are among the sides that are marked, each as long as possible. A side with no
/// other one is its own neighbour. As many as there are sides, or a few times as many.
std::vector<Neighbours> neighbours(const EdgeRow& row, const std::vector<std::uint8_t>& marked);

}  // namespace sectile::arrangement
