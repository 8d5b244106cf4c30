// Winding numbers: how often the surfaces of each operand go around a point.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "arrangement/facets.h"
#include "arrangement/steering.h"
#include "search/box_tree.h"

namespace sectile::arrangement {

/// The operands whose winding number is not zero, ascending, with the number.
using Winding = std::vector<std::pair<std::uint32_t, std::int32_t>>;

/// How surfaces count.
enum class Counting {
  oriented,  ///< each face by its orientation
  parity     ///< each face once, modulo two
};

/// winding += sign · step, for a sign of 1 or -1.
void add(Winding& winding, const Winding& step, int sign, Counting counting);

/// Where a ray starts; the weight of the point is positive.
struct RayStart {
  explicit RayStart(ExactPoint point);
  ExactPoint point;
  Vec3 rounded;  ///< to nearest
};

/// Counts the faces that a ray meets.
class WindingRay {
 public:
  /// In the direction of an axis.
  WindingRay(const Facets& facets, const BoxTree& tree, const Kernel& kernel, int axis)
      : facets_(facets), tree_(tree), kernel_(kernel), axis_(axis) {}

  struct Hit {
    std::uint32_t face;
    std::int32_t sign;
  };
  /// The faces that the ray meets, with the winding number that they add around its start. It
  /// starts beside the point, at an infinitesimal distance: by (ζ, ε, -δ) on the ray's axis and the
  /// two next ones, with δ far greater than ε and ε than ζ, so that it meets no edge.
  std::vector<Hit> hits(const RayStart& start) const;
  /// Those whose boxes it meets, ascending.
  std::vector<std::uint32_t> near_faces(const RayStart& start) const;

  /// The side of a plane on which the start of that ray lies.
  Sign side(const RayStart& start, PlaneId plane) const;

 private:
  bool meets(const RayStart& start, std::uint32_t face) const;

  const Facets& facets_;
  const BoxTree& tree_;
  const Kernel& kernel_;
  int axis_;
};

}  // namespace sectile::arrangement
