// What the kinds of primitives share: the checks of their parameters, and the place in the middle.
#pragma once

#include <cstdint>

#include "scene/primitive_kind.h"

namespace sectile::viewer {

/// Throw std::invalid_argument, which says what is wrong.
void require_length(double length, const char* what);
void require_faces(std::uint64_t count);

/// The corner of a box around the origin that lies farthest along all axes; checks its lengths.
Vec3 high_corner(const Primitive& primitive);
/// Of what stands on a regular polygon.
void check_sides_and_height(const Primitive& primitive);
void begin_with_six_sides(Primitive& primitive);

/// What the library makes standing on z = 0.
Solid centred(const Solid& standing, double height);

// Fields that several kinds have.
inline constexpr PrimitiveField size_field{"Size", "size", &Primitive::size};
inline constexpr PrimitiveField radius_field{"Radius", "radius", &Primitive::radius};
inline constexpr PrimitiveField height_field{"Height", "height", &Primitive::height};
inline constexpr PrimitiveField sides_field{"Sides", "segments", &Primitive::segments, 3, 512};
inline constexpr PrimitiveField segments_field{"Segments", "segments", &Primitive::segments, 3,
                                               512};
inline constexpr PrimitiveField rings_field{"Rings", "rings", &Primitive::rings, 3, 256};

}  // namespace sectile::viewer
