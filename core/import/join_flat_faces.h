// Coplanar neighbours become one face: solids cost what their faces cost, and not their triangles.
#pragma once

#include <memory>
#include <span>

#include "geometry/kernel.h"
#include "storage/faces_as_read.h"
#include "storage/solid_data.h"
#include "topology/brep.h"

namespace sectile {

/// A boundary whose edges between coplanar neighbours are gone, with the points and planes that it
/// still needs.
struct JoinedFaces {
  Brep brep;
  Geometry geometry;
  std::shared_ptr<const FacesAsRead> as_read;  ///< none if nothing could be joined: no brep then
};

/// Edges between coplanar faces have an edge_plane. Faces stay apart if their numbers in `groups`
/// (per FaceSource::face; empty: all alike) differ, or if they have a corner where the boundary
/// touches itself. A joined face has the least FaceSource of its parts.
JoinedFaces join_flat_faces(const Brep& brep, const Geometry& geometry, const Kernel& kernel,
                            std::span<const std::uint32_t> groups);

/// The same of a solid in one block: another one, or the same one if nothing could be joined.
std::shared_ptr<SolidData> with_flat_faces_joined(std::shared_ptr<SolidData> data,
                                                  const Kernel& kernel,
                                                  std::span<const std::uint32_t> groups);

}  // namespace sectile
