// What the benchmarks of the viewer turn and drag.
#pragma once

#include "scene/scene.h"

namespace sectile::bench {

inline viewer::Node ball(const char* name, std::uint32_t segments, std::uint32_t rings,
                         double radius) {
  viewer::Primitive p;
  p.shape = viewer::Primitive::Shape::sphere;
  p.radius = radius;
  p.segments = segments;
  p.rings = rings;
  viewer::Node node;
  node.name = name;
  node.what = p;
  return node;
}

}  // namespace sectile::bench
