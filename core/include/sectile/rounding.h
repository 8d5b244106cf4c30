// Exact solids as meshes whose coordinates are numbers of a file.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

#include "sectile/errors.h"
#include "sectile/files.h"
#include "sectile/mesh.h"
#include "sectile/solid.h"

namespace sectile {

/// Which coordinates a mesh may have.
struct Rounding {
  enum class Numbers : std::uint8_t {
    doubles,  ///< any double: OBJ, OFF, PLY, text
    floats,   ///< doubles that are floats: binary STL, 3MF
    grid      ///< multiples of `spacing`, as the nearest doubles
  };
  Numbers numbers = Numbers::doubles;
  double spacing = 1;
  /// No corner of the solid may move farther than this.
  double max_move = std::numeric_limits<double>::infinity();
  /// Where solids or parts of one touch in a vertex or an edge only, move them apart by one step or
  /// a few: each edge of the mesh has two triangles, and the triangles around each place hang
  /// together.
  bool separate_touching = false;
  const std::atomic<bool>* cancel = nullptr;  ///< Cancelled is thrown soon after it is set
  std::function<void(double)> progress;       ///< is told the part done, by one thread at a time
};

/// The numbers that files of a format hold.
Rounding::Numbers numbers_of(FileFormat format);

/// What rounding did to the corners.
struct RoundingReport {
  std::size_t corners = 0;    ///< of the solid
  std::size_t moved = 0;      ///< those whose exact place the mesh cannot have
  std::size_t displaced = 0;  ///< those that could not go to the nearest place
  std::size_t merged = 0;     ///< those that went to the place of a neighbour
  std::size_t flipped = 0;    ///< edges between two triangles that are flat together but for
                              ///< rounding, replaced by the other diagonal
  std::size_t separated = 0;  ///< corners moved from where the solid touches itself
  std::size_t resolved = 0;   ///< how often corners went to a coarser grid, because faces could not
                              ///< be kept apart otherwise, and what crossed then was united
  double largest_move = 0;    ///< of a corner, or of the surface where an edge was replaced
  double median_move = 0;     ///< of the corners that moved
  Vec3 largest_at;
};

struct RoundedMesh {
  PolygonMesh mesh;                 ///< triangles
  std::vector<FaceSource> sources;  ///< per triangle
  RoundingReport report;
};

/// A solid cannot be written within the displacement that is allowed, or a coordinate is larger
/// than the numbers of the mesh.
class RoundingFailed : public Error {
 public:
  RoundingFailed(const std::string& message, const Vec3& where) : Error(message), where_(where) {}
  const Vec3& where() const { return where_; }

 private:
  Vec3 where_;
};

/// Triangles that, read back, are a legal solid: closed and oriented, none without area, no two of
/// them crossing or lying on each other. Corners go to the nearest place that the numbers allow;
/// where that would make faces meet, corners beside it, or edges are replaced by other diagonals,
/// or corners joined with neighbours; where that does not help, corners go to a coarser grid. All
/// else stays as it is. What is thinner than the numbers can tell vanishes, and all of the solid
/// may: then the mesh is empty. Throws RoundingFailed, Cancelled.
RoundedMesh rounded_mesh(const Solid& solid, const Rounding& rounding = {});

}  // namespace sectile
