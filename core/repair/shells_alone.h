// Meshes whose shells are solids, each of them, whatever they do to each other.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "arrangement/steering.h"
#include "geometry/kernel.h"
#include "import/contacts.h"
#include "import/polygons.h"
#include "sectile/repair.h"

namespace sectile {

/// What was done to such a mesh.
struct ShellsUnited {
  std::shared_ptr<const SolidData> data;
  std::vector<std::uint32_t> divided;  ///< polygons, ascending
  /// Polygons, ascending; those that were joined to one face only if nothing of it is left.
  std::vector<std::uint32_t> removed;
  std::size_t overlaps = 0;         ///< pairs of polygons that lie on each other
  std::uint32_t first_overlap = 0;  ///< the one with the least source
};

/// What polygons bound by a rule, if their edges are plain (`mate` is not empty) and one of the
/// following holds: nothing crosses anything, no shell touches another one, and they bound a solid
/// as they are; or only different shells cross each other or lie on each other, and all are turned
/// outwards: then, unless the rule is `odd`, Booleans unite them. Otherwise nothing. Plane f is
/// that of polygon f, and all points are explicit. May add planes to the geometry.
std::optional<ShellsUnited> shells_alone(const Polygons& polygons,
                                         const std::vector<std::uint32_t>& mate, Geometry& geometry,
                                         const Kernel& kernel, Rule rule, std::uint32_t origin,
                                         const arrangement::Steering& steering);

/// Is any contact one of a shell with itself? `shell_of` has the shell of each face.
bool any_crosses_itself(std::span<const FacePairContact> contacts,
                        std::span<const std::uint32_t> shell_of);

/// Unites solids that are turned outwards and come from one mesh. `contacts` are those of its
/// polygons, `source` has the number of each in FaceSource, `as_read` says what was joined, if
/// anything was.
ShellsUnited unite_shells(const std::vector<Solid>& solids,
                          std::span<const FacePairContact> contacts,
                          std::span<const std::uint32_t> source, const FacesAsRead* as_read,
                          std::uint32_t origin, const arrangement::Steering& steering);

}  // namespace sectile
