// Triangles edge to edge.
#pragma once

#include "geometry/kernel.h"
#include "selftest/triangle_surface.h"

namespace sectile {

/// Divides triangles whose edge is divided on its other side, where a corner of a face touches an
/// edge of the same face. Afterwards no mate is partial. Points are those of the kernel's geometry.
void make_conforming(TriangleSurface& surface, const Kernel& kernel);

}  // namespace sectile
