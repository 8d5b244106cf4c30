// Neighborhoods as surfaces: fans for the sectors at a place, strips for the half-planes beside a
// segment. One mesh for each class, to be drawn in its colour.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <utility>

#include "story/story_record.h"

namespace sectile::viewer {

/// By solid and class, if known.
using ClassMeshes =
    std::map<std::pair<int, std::optional<TraceClass>>, std::shared_ptr<SurfaceMesh>>;

/// The sectors of both solids at a place, drawn there or at another place.
void add_fans(const StoryRecord& record, std::uint32_t place, double radius, ClassMeshes& meshes,
              const std::optional<glm::dvec3>& drawn_at = std::nullopt);
/// One sector.
void add_fan(ClassMeshes& meshes, const SpherePicture::Arc& arc, const glm::dvec3& centre,
             double radius);
/// The direction in the middle of a sector.
glm::dvec3 middle_of(const SpherePicture::Arc& arc);
/// The half-planes of a neighborhood, from `margin` behind its first end to `margin` before its
/// last.
void add_strips(const NeighborhoodEvent& neighborhood, double width, double margin,
                ClassMeshes& meshes);
/// One half-plane beside a segment.
void add_strip(ClassMeshes& meshes, const TraceHalfPlane& half_plane,
               const std::array<TracePlace, 2>& ends, double width, double margin);

}  // namespace sectile::viewer
