#include "boolean/components/steep_face.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/plane_value.h"

namespace sectile {
namespace {

constexpr std::size_t most_faces = 48;

// Zero along x, one across it.
double steepness(const Block& block, FaceId face) {
  const PlaneValue plane = plane_value(block.geometry(), block.brep().plane[face]);
  const double x = std::abs(plane.n[0]), y = std::abs(plane.n[1]), z = std::abs(plane.n[2]);
  return x > 0 ? x / std::max({x, y, z}) : 0;
}

}  // namespace

std::optional<FaceAt> steep_face_near(const SolidData& solid, const FaceAt& start,
                                      const std::function<bool(const FaceAt&)>& free) {
  std::optional<FaceAt> steepest;
  double most = 0;
  std::vector<FaceAt> faces{start};
  const auto add = [&](const FaceAt& at) {
    const bool known = std::ranges::any_of(
        faces, [&](const FaceAt& f) { return f.slot == at.slot && f.face == at.face; });
    if (!known && faces.size() < most_faces && free(at)) faces.push_back(at);
  };
  for (std::size_t i = 0; i < faces.size() && most < 1; ++i) {
    const FaceAt at = faces[i];
    const Block& block = *solid.slot(at.slot).block;
    if (const double steep = steepness(block, at.face); steep > most) most = steep, steepest = at;
    for_each_in_face(block.brep(), at.face, [&](HalfEdgeId h) {
      const SolidData::Neighbour beyond = solid.across(at.slot, h);
      add({beyond.slot, solid.slot(beyond.slot).block->brep().face_of(beyond.local)});
    });
  }
  return steepest;
}

}  // namespace sectile
