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
  std::vector<std::uint32_t> divided, removed;  ///< polygons, ascending
};

/// What polygons bound by a rule, if their edges are plain (`mate` is not empty) and one of the
/// following holds: nothing crosses anything, no shell touches another one, and they bound a solid
/// as they are; or only different shells cross each other, and all are turned outwards: then,
/// unless the rule is `odd`, Booleans unite them. Otherwise nothing. Plane f is that of polygon f,
/// and all points are explicit. May add planes to the geometry.
std::optional<ShellsUnited> shells_alone(const Polygons& polygons,
                                         const std::vector<std::uint32_t>& mate, Geometry& geometry,
                                         const Kernel& kernel, Rule rule, std::uint32_t origin,
                                         const arrangement::Steering& steering);

/// Is every contact a crossing of different shells? `shell_of` has that of each face.
bool only_shells_cross(std::span<const FacePairContact> contacts,
                       std::span<const std::uint32_t> shell_of);

/// Unites solids that are turned outwards and come from one mesh. `contacts` are those of its
/// polygons, `source` has the number of each in FaceSource.
ShellsUnited unite_shells(const std::vector<Solid>& solids,
                          std::span<const FacePairContact> contacts,
                          std::span<const std::uint32_t> source, std::uint32_t origin,
                          const arrangement::Steering& steering);

}  // namespace sectile
