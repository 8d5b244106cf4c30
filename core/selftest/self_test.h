// Does a surface meet itself in more than points and edges?
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <vector>

#include "geometry/kernel.h"
#include "selftest/triangle_surface.h"

namespace sectile {

/// Two triangles that do not meet as those of a solid do.
struct SelfContact {
  enum class Kind : std::uint8_t {
    crossing,  ///< their interiors cross, or an edge runs through an interior
    overlap,   ///< they lie on each other
    wedges     ///< around a line of their edges, material is on both sides, or on none, of a face
  };
  std::uint32_t first = 0, second = 0;  ///< triangles
  Kind kind = Kind::crossing;
  Vec3 where;  ///< a place near it
};

struct SelfTestControl {
  const std::atomic<bool>* cancel = nullptr;  ///< Cancelled is thrown soon after it is set
  std::function<void(double)> progress;       ///< is told the part done, by one thread at a time
  /// Faces of several triangles that lie on each other need not be found more than once.
  bool overlaps_once = false;
  /// If given: the search ends soon after it holds for two faces that meet. Such a pair is found
  /// then; which others are, is left to chance. Asked by several threads at a time.
  std::function<bool(std::uint32_t face, std::uint32_t other)> is_enough = {};
};

/// All such pairs, in ascending order: the same for any number of threads. None: the interiors of
/// the faces are disjoint, and the material alternates with the outside around every line.
std::vector<SelfContact> self_contacts(const TriangleSurface& surface, const Kernel& kernel,
                                       const SelfTestControl& control = {});

}  // namespace sectile
