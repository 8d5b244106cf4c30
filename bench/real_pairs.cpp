// Pairs of real meshes, in places that do not change.
#include <algorithm>
#include <filesystem>

#include "sectile/files.h"
#include "sectile/transform.h"
#include "sequences.h"

namespace sectile::bench {
namespace {

struct Extent {
  Vec3 middle;
  double size = 0;
};

Extent extent(const PolygonMesh& mesh) {
  Vec3 low = mesh.positions.front(), high = low;
  for (const Vec3& p : mesh.positions) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  return {{(low.x + high.x) / 2, (low.y + high.y) / 2, (low.z + high.z) / 2},
          std::max({high.x - low.x, high.y - low.y, high.z - low.z})};
}

// Into a box of edge 2 around the origin, then turned and moved a little: another way for each.
PolygonMesh placed(const PolygonMesh& mesh, int which) {
  const Extent e = extent(mesh);
  const double scale = 2 / e.size;
  const auto centred = Transform::scaling({scale, scale, scale}) *
                       Transform::translation({-e.middle.x, -e.middle.y, -e.middle.z});
  const auto turned = Transform::rotation_degrees({1.0 + which, 2, 3}, 37.0 * which);
  return transformed(
      mesh, Transform::translation({0.11 * which, 0.07 * which, 0.05 * which}) * turned * centred);
}

constexpr const char* pairs[][2] = {
    {"fandisk", "pinion"},
    {"fandisk_large", "anchor"},
    {"couplingdown", "rotor"},
    {"knot1", "knot2"},
    {"armadillo", "fandisk"},
    {"bunny00", "anchor"},
    {"bunny00", "rotor_small"},
    {"homer", "dino"},
    {"armadillo", "handle"},
    {"knot2", "pinion"},
    {"fandisk_large", "rotor_small"},
    {"anchor_dense", "couplingdown"},
};

}  // namespace

std::vector<Sequence> real_pairs(const std::string& folder) {
  std::vector<Sequence> all;
  for (const auto& [first_name, second_name] : pairs) {
    const char *first = first_name, *second = second_name;
    const auto path = [folder](const char* name) {
      return std::filesystem::path(folder) / (std::string(name) + ".off");
    };
    if (!exists(path(first)) || !exists(path(second))) continue;
    all.push_back(
        {std::string(first) + " and " + second, [=]() -> std::function<void(const Boolean&)> {
           const Solid a = Solid::from_mesh(placed(read_mesh(path(first)), 0)),
                       b = Solid::from_mesh(placed(read_mesh(path(second)), 1));
           return [=](const Boolean& boolean) {
             boolean(a, b, Operation::unite);
             boolean(a, b, Operation::subtract);
           };
         }});
  }
  return all;
}

}  // namespace sectile::bench
