// Neighborhoods as surfaces: fans for the sectors at a place, strips for the half-planes beside a
// segment. One mesh for each class, to be drawn in its colour.
#pragma once

#include <map>
#include <optional>
#include <utility>

#include "story/story_record.h"

namespace sectile::viewer {

/// By solid and class, if known.
using ClassMeshes =
    std::map<std::pair<int, std::optional<TraceClass>>, std::shared_ptr<SurfaceMesh>>;

/// The sectors of both solids at a place.
void add_fans(const StoryRecord& record, std::uint32_t place, double radius, ClassMeshes& meshes);
/// The half-planes of a neighborhood, from `margin` behind its first end to `margin` before its
/// last.
void add_strips(const NeighborhoodEvent& neighborhood, double width, double margin,
                ClassMeshes& meshes);

}  // namespace sectile::viewer
