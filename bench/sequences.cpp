#include "sequences.h"

#include <cmath>
#include <memory>
#include <numbers>

#include "cases.h"
#include "needles.h"
#include "sectile/primitives.h"
#include "sectile/transform.h"
#include "terrain.h"

namespace sectile::bench {
namespace {

using Operands = std::pair<Solid, Solid>;
using Work = std::function<void(const Boolean&)>;

Sequence single(std::string name, Operation operation, std::function<Operands()> make) {
  return {std::move(name), [operation, make = std::move(make)]() -> Work {
            return [operation, operands = make()](const Boolean& boolean) {
              boolean(operands.first, operands.second, operation);
            };
          }};
}

Solid trusted(const PolygonMesh& mesh) {
  ImportOptions options;
  options.trusted = true;
  return Solid::from_mesh(mesh, options);
}

Solid sphere_at(const Vec3& centre, double radius, std::uint32_t segments, std::uint32_t rings) {
  return trusted(sphere_mesh(centre, radius, segments, rings));
}

Sequence near_coincident() {
  return single("two 100,000 spheres turned by 1e-3", Operation::unite, [] {
    const PolygonMesh mesh = sphere_mesh({0, 0, 0}, 1, 250, 201);
    const auto turn = Transform::rotation_degrees({1, 2, 3}, 1e-3 * 180 / std::numbers::pi);
    return Operands(trusted(mesh), trusted(transformed(mesh, turn)));
  });
}

// What was changed in a part, as its file says it: all but a dent is the same in both.
Sequence two_versions() {
  return single("two versions of a sphere of 100,000 triangles", Operation::subtract, [] {
    PolygonMesh mesh = sphere_mesh({0, 0, 0}, 1, 250, 201);
    const Solid before = trusted(mesh);
    for (Vec3& p : mesh.positions)
      if (p.x > 0.995) p.x -= 0.01;
    return Operands(before, trusted(mesh));
  });
}

// What a cut has taken away: both share nearly all blocks.
Sequence beside_itself() {
  return single("sphere of 100,000 triangles beside itself cut", Operation::subtract, [] {
    const Solid before = sphere_at({0, 0, 0}, 1, 250, 201);
    return Operands(before,
                    boolean(before, sphere_at({1, 0, 0}, 0.1, 30, 17), Operation::subtract));
  });
}

// What two programs made of one terrain: all sides of its cells are in both.
Sequence two_triangulations() {
  return single("terrain of 22,500 cells halved in two ways", Operation::unite, [] {
    const Terrain terrain{150, [](std::uint32_t i, std::uint32_t j) {
                            return 15 + 3 * std::sin(0.37 * i) * std::cos(0.23 * j) +
                                   std::sin(1.7 * i + 2.3 * j);
                          }};
    return Operands(trusted(terrain_mesh(terrain, true)), trusted(terrain_mesh(terrain, false)));
  });
}

// Tens of millions of boxes overlap; one end of the inner pipe comes out of the outer one a little.
Sequence needles() {
  return single("needles, 20,000 and 12,000", Operation::unite, [] {
    const auto place =
        Transform::translation({0.1, 0.012, 0.01}) * Transform::rotation_degrees({0.1, 1, 0.2}, 25);
    const PolygonMesh inner = twisted_pipe({3000, 0.3, 0.35, -2});
    return Operands(trusted(twisted_pipe({5000, 0.9, 1, 2})), trusted(transformed(inner, place)));
  });
}

Sequence drag(const char* name, std::uint32_t segments, std::uint32_t rings) {
  return {name, [=]() -> Work {
            const Solid body = sphere_at({0, 0, 0}, 2, segments, rings);
            auto tools = std::make_shared<std::vector<Solid>>();
            for (int i = 0; i < 10; ++i)
              tools->push_back(sphere_at({1.7 + 0.013 * i, 0.031 * i, 0.1}, 0.6, 32, 17));
            return [=](const Boolean& boolean) {
              for (const Solid& tool : *tools) boolean(body, tool, Operation::subtract);
            };
          }};
}

// Cubes on the fields of one colour touch along edges.
Sequence chess_board() {
  return {"chess-board chain, 1,999 operations", []() -> Work {
            std::vector<Solid> cubes;
            for (int i = 0; cubes.size() < 2000; ++i) {
              const double x = i % 64, y = i / 64;
              if ((i % 64 + i / 64) % 2 == 0) cubes.push_back(block({x, y, 0}, {x + 1, y + 1, 1}));
            }
            return [cubes = std::move(cubes)](const Boolean& boolean) {
              Solid board = cubes[0];
              for (std::size_t i = 1; i < cubes.size(); ++i)
                board = boolean(board, cubes[i], Operation::unite);
            };
          }};
}

Sequence spheres_from_block() {
  return {"1,000 spheres from a block along a curve", []() -> Work {
            std::vector<Solid> tools;
            for (int i = 0; i < 1000; ++i) {
              const double t = i / 1000.0, angle = 20 * std::numbers::pi * t;
              tools.push_back(sphere_at({(0.2 + 0.7 * t) * std::cos(angle),
                                         (0.2 + 0.7 * t) * std::sin(angle), 0.1 * (t - 0.5)},
                                        0.02, 16, 13));
            }
            return [tools = std::move(tools)](const Boolean& boolean) {
              Solid body = block({-1, -1, -0.1}, {1, 1, 0.1});
              for (const Solid& tool : tools) body = boolean(body, tool, Operation::subtract);
            };
          }};
}

}  // namespace

std::vector<Sequence> sequences() {
  std::vector<Sequence> all;
  for (const Case& each : cases())
    all.push_back(single(each.name, each.operation, [each] { return each.prepare()(); }));
  for (Sequence& each : std::vector<Sequence>{
           near_coincident(), two_versions(), beside_itself(), two_triangulations(), needles(),
           drag("10 steps of 1,000 in 10,000", 100, 51),
           drag("10 steps of 1,000 in 100,000", 320, 157),
           drag("10 steps of 1,000 in 1,000,000", 1000, 501), chess_board(), spheres_from_block()})
    all.push_back(std::move(each));
  return all;
}

}  // namespace sectile::bench
