// Balls and cavities in turn, close around each other: their triangles are in each other's boxes,
// layer by layer. One corner that reaches into the next layer is found.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "cases.h"
#include "sectile/errors.h"
#include "sectile/primitives.h"
#include "sectile/solid.h"

namespace sectile {
namespace {

constexpr std::size_t layers = cases(60);

double radius_of(std::size_t layer) {
  return 1 + static_cast<double>(layer) / layers;
}

// Shell by shell from the innermost one on; the outermost one is a ball.
PolygonMesh balls_in_layers(const PolygonMesh& ball) {
  PolygonMesh mesh;
  for (std::size_t layer = 0; layer < layers; ++layer) {
    const double r = radius_of(layer);
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const Vec3& p : ball.positions) mesh.positions.push_back({r * p.x, r * p.y, r * p.z});
    const bool turned = (layers - layer) % 2 == 0;
    for (std::size_t t = 0; t < ball.indices.size(); t += 3) {
      mesh.face_sizes.push_back(3);
      for (const std::size_t c : {t, turned ? t + 2 : t + 1, turned ? t + 1 : t + 2})
        mesh.indices.push_back(first + ball.indices[c]);
    }
  }
  return mesh;
}

// A corner goes towards the middle, by so much of what is between two layers.
void push_in(PolygonMesh& mesh, const PolygonMesh& ball, std::size_t corner, double share) {
  const double r = radius_of(corner / ball.positions.size()), to = (r - share / layers) / r;
  Vec3& p = mesh.positions[corner];
  p = {to * p.x, to * p.y, to * p.z};
}

TEST(Layers, OfBallsAreLegalUntilACornerReachesTheNextOne) {
  const PolygonMesh ball = sphere(1, 12, 6).to_mesh();
  const PolygonMesh mesh = balls_in_layers(ball);
  double volume = 0;
  for (std::size_t layer = 0; layer < layers; ++layer)
    volume += ((layers - layer) % 2 == 0 ? -1 : 1) * std::pow(radius_of(layer), 3);
  volume *= sphere(1, 12, 6).volume();
  EXPECT_NEAR(Solid::from_mesh(mesh).volume(), volume, 1e-9);
  std::mt19937 random(3);
  for (int i = 0; i < cases(4); ++i) {
    const std::size_t in_first = ball.positions.size(),
                      corner = in_first + random() % (mesh.positions.size() - in_first);
    PolygonMesh bent = mesh;
    push_in(bent, ball, corner, 0.4);
    EXPECT_NO_THROW(Solid::from_mesh(bent));
    push_in(bent, ball, corner, 0.8);
    EXPECT_THROW(Solid::from_mesh(bent), InvalidSolid);
  }
}

}  // namespace
}  // namespace sectile
