// The parts of the boundary classification, pulled apart.
#pragma once

#include "picture/theme.h"
#include "story/story.h"
#include "story/story_record.h"

namespace sectile::viewer {

/// One part, where it belongs when nothing is exploded.
struct Part {
  int solid = 0;
  TraceClass cls = TraceClass::in;
  Mesh mesh;
  Colour colour;
  glm::dvec3 direction{0};             ///< where to it moves, for an explosion of one
  TraceClass lumped = TraceClass::in;  ///< the part of the four to which Table I adds it
  bool kept = false, turned = false;
};

/// AinB, AoutB, BinA, BoutA, or the eight parts.
std::vector<Part> parts_of(const StoryRecord& record, const Theme& theme, bool eight_way);

/// The same surface seen from its other side.
Mesh turned_inside_out(const SurfaceMesh& mesh);

}  // namespace sectile::viewer
