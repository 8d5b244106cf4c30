// Surfaces to draw, made from solids and from parts of their boundaries.
#pragma once

#include <memory>

#include "picture/picture.h"
#include "sectile/sectile.h"

namespace sectile::viewer {

/// Faces that meet at a smaller angle than this look like one bent surface: the edge between them
/// is smooth. (Twelve sides are still a round thing, ten a decagon.)
inline constexpr double cosine_of_sharpest_smooth_edge = 0.855;

/// The boundary of a solid. What comes from different operands never looks like one surface, unless
/// it is flush. Diagonals within one face are no edges. `faces` holds FaceSource::face.
std::shared_ptr<const SurfaceMesh> surface_mesh(const Solid& solid);

/// A part of a boundary: faces with holes, triangulated for the eye only. Its rims are hard; other
/// edges as above. `faces` holds the number of the part's face.
std::shared_ptr<const SurfaceMesh> surface_mesh(const SurfacePart& part);

}  // namespace sectile::viewer
