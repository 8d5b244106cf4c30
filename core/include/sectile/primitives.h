// Primitive solids. Lengths must be positive and finite, segment counts at least three; otherwise
// std::invalid_argument is thrown and says what is wrong.
//
// Points that are mirror images of each other in exact arithmetic are mirror images as doubles, and
// so are the triangles of curved sides: quadrilaterals that are not exactly planar are halved along
// a diagonal that leaves the wider ring, at its first corner in even octants and at its second in
// odd ones.
#pragma once

#include <cstdint>
#include <vector>

#include "sectile/solid.h"

namespace sectile {

struct Vec2 {
  double x = 0, y = 0;
};

/// A planar region: an outer polygon and holes inside it, each simple; orientations are mended and
/// repeated points dropped.
struct Profile {
  std::vector<Vec2> outer;
  std::vector<std::vector<Vec2>> holes;
};

Solid block(const Vec3& low, const Vec3& high);
/// Half of a block: its cross-section in xz is the triangle low, (high.x, low.z), (low.x, high.z).
Solid wedge(const Vec3& low, const Vec3& high);
/// A regular prism along z from z = 0; its first corner lies on the x axis.
Solid prism(double radius, double height, std::uint32_t sides);
Solid pyramid(double radius, double height, std::uint32_t sides);
Solid cylinder(double radius, double height, std::uint32_t segments = 64);
/// A cone or, with a positive top radius, a frustum.
Solid cone(double bottom_radius, double top_radius, double height, std::uint32_t segments = 64);
/// Triangles around the origin, 2·segments·(rings - 1) of them, poles on the z axis; at least two
/// rings.
Solid sphere(double radius, std::uint32_t segments = 64, std::uint32_t rings = 32);
/// The same as a mesh that was not imported yet (for benchmarks and tests).
PolygonMesh sphere_mesh(const Vec3& centre, double radius, std::uint32_t segments,
                        std::uint32_t rings);
/// Around the z axis. The minor radius must be smaller than the major radius.
Solid torus(double major_radius, double minor_radius, std::uint32_t major_segments = 64,
            std::uint32_t minor_segments = 32);
/// Sweeps a profile in the xy plane along z from 0 to height.
Solid extrude(const Profile& profile, double height);
/// Turns a profile (x >= 0 is the radius, y becomes z) around the z axis. Holes become cavities;
/// edges of the profile on the axis make no faces, horizontal ones make one face each.
Solid revolve(const Profile& profile, std::uint32_t segments = 64);

}  // namespace sectile
