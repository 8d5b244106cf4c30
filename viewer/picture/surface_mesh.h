// Surfaces to draw, made from solids and from parts of their boundaries.
#pragma once

#include <memory>

#include "picture/picture.h"
#include "sectile/sectile.h"

namespace sectile::viewer {

/// The boundary of a solid. Hard edges are those between faces of different source or direction;
/// `faces` holds FaceSource::face.
std::shared_ptr<const SurfaceMesh> surface_mesh(const Solid& solid);

/// A part of a boundary: faces with holes, triangulated for the eye only. All edges of its loops
/// are hard but those between faces of one source; `faces` holds the number of the part's face.
std::shared_ptr<const SurfaceMesh> surface_mesh(const SurfacePart& part);

}  // namespace sectile::viewer
