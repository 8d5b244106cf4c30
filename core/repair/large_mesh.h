// Large meshes of triangles whose shells are solids: the short way to what shells_alone.h finds.
#pragma once

#include "import/triangles/triangle_shells.h"
#include "repair/shells_alone.h"

namespace sectile {

struct LargeMesh {
  std::optional<ShellsUnited> united;  ///< of polygons in the order of the curve, `source` of each
  std::vector<std::uint32_t> source;
  std::vector<std::uint32_t> input_vertex;  ///< per point: its first position; empty: the same
  /// Nothing but an arrangement resolves it.
  bool is_tangled = false;
};

/// What a mesh bounds by a rule. Nothing is said of one that is small, or more than triangles with
/// two of them at each edge, one cycle of them around each point and volume in each shell.
LargeMesh resolve_large_mesh(const SoupView& soup, Rule rule, std::uint32_t origin,
                             const arrangement::Steering& steering);

}  // namespace sectile
