// The borders of a surface that is not closed, and faces that contradict each other.
#pragma once

#include <vector>

#include "import/polygons.h"

namespace sectile {

/// How the half-edges between two points have to add up.
enum class Balance {
  oriented,  ///< as many one way as the other
  parity     ///< an even number
};

/// A border: closed paths run with the hole on their left, so that a face in it would have them as
/// its loop.
struct BorderLoop {
  std::vector<PointId> corners;
  std::uint32_t face;  ///< of the polygons, beside its first edge
};

/// The corners of half-edges between points where they do not add up.
std::vector<std::uint32_t> open_corners(const Polygons& polygons, Balance balance);

/// All borders, as loops that visit no point twice.
std::vector<BorderLoop> border_loops(const Polygons& polygons, Balance balance);

/// Removes faces with the corners of another one all of whose edges are open, so that removing them
/// closes edges and opens none. Returns their numbers.
std::vector<std::uint32_t> remove_copies(Polygons& polygons, Balance balance);

/// Turns faces around so that two that meet in an edge run along it in different ways, as far as
/// the surface allows it; most faces of each piece stay as they are. Returns the faces turned.
std::vector<std::uint32_t> orient(Polygons& polygons);

}  // namespace sectile
