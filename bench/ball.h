// What the benchmarks of the viewer turn and drag.
#pragma once

#include "scene/primitive_kind.h"

namespace sectile::bench {

inline viewer::Node ball(const char* name, std::uint32_t segments, std::uint32_t rings,
                         double radius) {
  viewer::Primitive p = viewer::first_primitive(viewer::primitive_kind("sphere"));
  p.radius = radius;
  p.segments = segments;
  p.rings = rings;
  viewer::Node node;
  node.name = name;
  node.what = p;
  return node;
}

}  // namespace sectile::bench
