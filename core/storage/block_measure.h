// What the faces of a block add to the volume and the area of a solid, in pairs of doubles with a
// bound of their error.
#pragma once

#include <span>

#include "geometry/geometry.h"
#include "numbers/bounded.h"
#include "topology/brep.h"

namespace sectile {

/// Six times the volume between the faces and the plane z = level, and twice the signed area of
/// their projection along z: by it the volume goes over to another level.
struct BlockVolume {
  Bounded below, shadow;
  double level = 0;
};

/// Of a block with faces; the level is one of its own, so that few digits cancel.
BlockVolume volume_of_faces(const Brep& brep, const Geometry& geometry);
/// Twice their area.
Bounded two_areas_of_faces(const Brep& brep, const Geometry& geometry);
/// Twice the area of some of them.
Bounded two_areas_of_faces(const Brep& brep, const Geometry& geometry,
                           std::span<const FaceId> faces);

}  // namespace sectile
