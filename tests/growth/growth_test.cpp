#include <gtest/gtest.h>

#include <array>
#include <memory>

#include "geometry/geometry.h"
#include "growth/steps.h"
#include "sectile/boolean.h"
#include "sectile/primitives.h"
#include "sectile/rounding.h"
#include "sectile/solid.h"
#include "sectile/transform.h"
#include "sectile/validate.h"
#include "storage/geometry_loader.h"

namespace sectile {
namespace {

Solid sphere_of(std::size_t triangles) {
  const auto rings = static_cast<std::uint32_t>(std::sqrt(static_cast<double>(triangles) / 4));
  return sphere(1, 2 * rings, rings);
}

TEST(Steps, AreCountedAlikeEachTime) {
  const PolygonMesh mesh = sphere_of(1000).to_mesh();
  const auto work = [&] { Solid::from_mesh(mesh); };
  work();
  EXPECT_EQ(steps_of(work), steps_of(work));
}

TEST(Steps, TellLinearFromQuadraticGrowth) {
  const PolygonMesh mesh = sphere_of(1000).to_mesh();
  const auto repeated = [&](std::size_t times) {
    return [&mesh, times] {
      for (std::size_t i = 0; i < times; ++i) Solid::from_mesh(mesh);
    };
  };
  EXPECT_LT(growth([&](std::size_t n) { return repeated(n); }, 2), n_log_n);
  EXPECT_GT(growth([&](std::size_t n) { return repeated(n * n); }, 2), 1.9);
}

void add_face(PolygonMesh& mesh, std::initializer_list<Vec3> corners) {
  mesh.face_sizes.push_back(static_cast<std::uint32_t>(corners.size()));
  for (const Vec3& p : corners) {
    mesh.indices.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
    mesh.positions.push_back(p);
  }
}

void add_block(PolygonMesh& mesh, const Vec3& a, const Vec3& b, bool hollow = false) {
  const Vec3 p[] = {{a.x, a.y, a.z}, {b.x, a.y, a.z}, {b.x, b.y, a.z}, {a.x, b.y, a.z},
                    {a.x, a.y, b.z}, {b.x, a.y, b.z}, {b.x, b.y, b.z}, {a.x, b.y, b.z}};
  for (const auto& f : {std::array{3, 2, 1, 0},
                        {4, 5, 6, 7},
                        {0, 1, 5, 4},
                        {1, 2, 6, 5},
                        {2, 3, 7, 6},
                        {3, 0, 4, 7}}) {
    if (hollow)
      add_face(mesh, {p[f[3]], p[f[2]], p[f[1]], p[f[0]]});
    else
      add_face(mesh, {p[f[0]], p[f[1]], p[f[2]], p[f[3]]});
  }
}

PolygonMesh cubes_in_a_row(std::size_t n, bool hollow = false) {
  PolygonMesh mesh;
  for (std::size_t i = 0; i < n; ++i) {
    const double x = 2 * static_cast<double>(i);
    add_block(mesh, {x, 0, 0}, {x + 1, 1, 1}, hollow);
  }
  return mesh;
}

PolygonMesh block_with_cavities(std::size_t n) {
  PolygonMesh mesh = cubes_in_a_row(n, true);
  add_block(mesh, {-1, -1, -1}, {2 * static_cast<double>(n), 2, 2});
  return mesh;
}

// A block of n squares whose sides are flat.
PolygonMesh block_of_squares(std::size_t n) {
  const auto side = static_cast<int>(std::sqrt(static_cast<double>(n) / 2));
  PolygonMesh mesh;
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j) {
      const double x = i, y = j, u = i + 1, v = j + 1;
      add_face(mesh, {{x, y, 1}, {u, y, 1}, {u, v, 1}, {x, v, 1}});
      add_face(mesh, {{x, v, 0}, {u, v, 0}, {u, y, 0}, {x, y, 0}});
    }
  for (int i = 0; i < side; ++i) {
    const double x = i, u = i + 1, s = side;
    add_face(mesh, {{x, 0, 0}, {u, 0, 0}, {u, 0, 1}, {x, 0, 1}});
    add_face(mesh, {{u, s, 0}, {x, s, 0}, {x, s, 1}, {u, s, 1}});
    add_face(mesh, {{s, x, 0}, {s, u, 0}, {s, u, 1}, {s, x, 1}});
    add_face(mesh, {{0, u, 0}, {0, x, 0}, {0, x, 1}, {0, u, 1}});
  }
  return mesh;
}

// A prism whose base has n long slanted teeth.
PolygonMesh slanted_comb(std::size_t n) {
  const double width = static_cast<double>(n);
  std::vector<Vec3> outline{{0, -1, 0}, {width, -1, 0}};
  for (std::size_t i = n; i-- > 0;) {
    const double x = static_cast<double>(i);
    outline.push_back({x + width + 0.5, width, 0});
    outline.push_back({x, 0, 0});
  }
  const auto count = static_cast<std::uint32_t>(outline.size());
  PolygonMesh mesh;
  mesh.positions = outline;
  for (const Vec3& p : outline) mesh.positions.push_back({p.x, p.y, 1});
  mesh.face_sizes = {count, count};
  for (std::uint32_t i = count; i-- > 0;) mesh.indices.push_back(i);
  for (std::uint32_t i = 0; i < count; ++i) mesh.indices.push_back(count + i);
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t k = (i + 1) % count;
    mesh.face_sizes.push_back(4);
    mesh.indices.insert(mesh.indices.end(), {i, k, count + k, count + i});
  }
  return mesh;
}

// The test against itself looks at all pairs of boxes that overlap, and these do.
Solid trusted(const PolygonMesh& mesh) {
  ImportOptions options;
  options.trusted = true;
  return Solid::from_mesh(mesh, options);
}

Solid plate_with_pegs(std::size_t n) {
  const auto side = static_cast<int>(std::sqrt(static_cast<double>(n)));
  PolygonMesh pegs;
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j)
      add_block(pegs, {3.0 * i, 3.0 * j, 1}, {3.0 * i + 1, 3.0 * j + 1, 2});
  const double end = 3.0 * side;
  return boolean(block({-1, -1, 0}, {end, end, 1}), Solid::from_mesh(pegs), Operation::unite);
}

// Cubes and cavities in turn, one in the other.
PolygonMesh nested_shells(std::size_t n) {
  PolygonMesh mesh;
  for (std::size_t i = 1; i <= n; ++i) {
    const double r = static_cast<double>(2 * i);
    add_block(mesh, {-r, -r, -r}, {r, r, r}, (n - i) % 2 == 1);
  }
  return mesh;
}

PolygonMesh in_triangles(const PolygonMesh& convex) {
  PolygonMesh triangles;
  triangles.positions = convex.positions;
  for (std::size_t first = 0, f = 0; f < convex.face_sizes.size(); first += convex.face_sizes[f++])
    for (std::size_t k = first + 1; k + 1 < first + convex.face_sizes[f]; ++k) {
      triangles.face_sizes.push_back(3);
      for (const std::size_t corner : {first, k, k + 1})
        triangles.indices.push_back(convex.indices[corner]);
    }
  return triangles;
}

double import_growth(PolygonMesh (*make)(std::size_t), std::size_t n) {
  return growth([&](std::size_t size) { return [mesh = make(size)] { Solid::from_mesh(mesh); }; },
                n);
}

TEST(Growth, ImportOfCubesInARow) {
  EXPECT_LT(import_growth([](std::size_t n) { return cubes_in_a_row(n); }, 200), n_log_n);
}

// More than a few thousand triangles, which go straight into blocks, shell by shell.
TEST(Growth, ImportOfTrianglesOfCubesInARow) {
  EXPECT_LT(import_growth([](std::size_t n) { return in_triangles(cubes_in_a_row(n)); }, 400),
            n_log_n);
}

TEST(Growth, ImportOfABlockWithCavities) {
  EXPECT_LT(import_growth(block_with_cavities, 200), n_log_n);
}

TEST(Growth, ValidationOfCubesInARow) {
  EXPECT_LT(growth(
                [](std::size_t n) {
                  return [solid = Solid::from_mesh(cubes_in_a_row(n))] { validate(solid); };
                },
                200),
            n_log_n);
}

TEST(Growth, ImportOfAFlatBlock) {
  EXPECT_LT(import_growth(block_of_squares, 2000), n_log_n);
  EXPECT_EQ(Solid::from_mesh(block_of_squares(2000)).counts().faces, 6u);
}

TEST(Growth, ImportOfASlantedComb) {
  EXPECT_LT(growth([](std::size_t n) { return [mesh = slanted_comb(n)] { trusted(mesh); }; }, 200),
            n_log_n);
}

TEST(Growth, CutThroughAComb) {
  EXPECT_LT(growth(
                [](std::size_t n) {
                  const Solid comb = trusted(slanted_comb(n));
                  return [comb, n] { split(comb, {0, 1, 0, -0.5 * static_cast<double>(n)}); };
                },
                200),
            n_log_n);
}

TEST(Growth, CutThroughAPlateWithPegs) {
  EXPECT_LT(growth(
                [](std::size_t n) {
                  return [plate = plate_with_pegs(n)] { split(plate, {0, 0, 1, -1}); };
                },
                100),
            n_log_n);
}

// The cut's rings lie around each other.
TEST(Growth, CutThroughNestedShells) {
  EXPECT_LT(growth(
                [](std::size_t n) {
                  return [shells = trusted(nested_shells(n))] { split(shells, {0, 0, 1, -1}); };
                },
                200),
            n_log_n);
}

TEST(Growth, ImportOfNestedShells) {
  EXPECT_LT(import_growth(nested_shells, 400), n_log_n);
}

TEST(Growth, MeshOfAPlateWithPegs) {
  EXPECT_LT(
      growth([](std::size_t n) { return [plate = plate_with_pegs(n)] { plate.to_mesh(); }; }, 400),
      n_log_n);
}

TEST(Growth, ImportOfASphere) {
  EXPECT_LT(
      growth(
          [](std::size_t n) { return [mesh = sphere_of(n).to_mesh()] { Solid::from_mesh(mesh); }; },
          4000),
      n_log_n);
}

TEST(Growth, UnionOfTwoSpheres) {
  EXPECT_LT(growth(
                [](std::size_t n) {
                  const Solid a = sphere_of(n),
                              b = transformed(a, Transform::translation({0.7, 0.1, 0.05}));
                  return [a, b] { boolean(a, b, Operation::unite); };
                },
                4000),
            n_log_n);
}

// The boxes of the block's faces hold all of the sphere, but their planes only cut a circle of it.
TEST(Growth, CuttingASphereByALargeTurnedBlock) {
  const auto work = [](std::size_t n) {
    const Solid ball = Solid::from_mesh(sphere_of(n).to_mesh());
    const Solid tool =
        transformed(block({0.1, -2, -2}, {4, 2, 2}), Transform::rotation_degrees({1, 2, 3}, 40));
    boolean(ball, tool, Operation::subtract);  // finds what blocks keep
    return [=] { boolean(ball, tool, Operation::subtract); };
  };
  EXPECT_LT(growth(work, 20000), 0.75);
}

// Blocks know their volumes, and what they have in common is on their borders.
TEST(Growth, VolumeAndCountsOfAResultThatSharesMost) {
  const Solid tool = transformed(block({0.9, -0.05, -0.05}, {1.2, 0.05, 0.05}),
                                 Transform::rotation_degrees({1, 2, 3}, 40));
  const auto cut = [&](std::size_t n) {
    const Solid ball = Solid::from_mesh(sphere_of(n).to_mesh());
    ball.volume();
    ball.counts();
    return boolean(ball, tool, Operation::subtract);
  };
  const Solid few = cut(20000), many = cut(80000);
  const auto per_face = [&](const auto& work) {
    const auto of = [&](const Solid& solid) {
      return static_cast<double>(steps_of([&] { work(solid); }));
    };
    return (of(many) - of(few)) / 60000;
  };
  EXPECT_LT(per_face([](const Solid& solid) { solid.volume(); }), 3);
  EXPECT_LT(per_face([](const Solid& solid) { solid.counts(); }), 30);
}

// It is paired anew where it touches itself, and only there: some thousands of faces, as the
// blocks there happen to be cut. All faces would cost thousands of steps each.
TEST(Growth, TakingAwayAFineSolidThatTouchesItself) {
  const Solid touching = boolean(block({0.9, 0, 0}, {1.1, 0.1, 0.1}),
                                 block({0.9, 0.1, 0.1}, {1.1, 0.2, 0.2}), Operation::unite);
  const Solid corner = block({0.95, 0.05, 0.05}, {1.2, 0.15, 0.15});
  const auto steps = [&](std::size_t n) {
    const Solid ball =
        boolean(Solid::from_mesh(sphere_of(n).to_mesh()), touching, Operation::unite);
    return static_cast<double>(steps_of([&] { boolean(corner, ball, Operation::subtract); }));
  };
  EXPECT_LT((steps(320000) - steps(20000)) / 300000, 60);
}

// Faces that are the same are found to be, and not cut at each other's edges.
TEST(Growth, TakingAwayASolidsEqual) {
  const auto steps = [](std::size_t n) {
    const PolygonMesh mesh = sphere_of(n).to_mesh();
    const Solid ball = Solid::from_mesh(mesh), equal = Solid::from_mesh(mesh);
    return static_cast<double>(steps_of([&] { boolean(ball, equal, Operation::subtract); }));
  };
  EXPECT_LT((steps(80000) - steps(20000)) / 60000, 2500);
}

// Of a moved solid, only the points of blocks near the other one are made.
TEST(Growth, ASmallCutInALargeMovedSolid) {
  const Solid tool = block({0.9, -0.05, -0.05}, {1.2, 0.05, 0.05});
  const Transform turn = Transform::rotation_degrees({1, 2, 3}, 40);
  const auto steps = [&](std::size_t n) {
    const Solid ball = Solid::from_mesh(sphere_of(n).to_mesh());
    const auto cut = [&] { boolean(transformed(ball, turn), tool, Operation::subtract); };
    cut();  // finds what the ball's blocks keep
    return static_cast<double>(steps_of(cut));
  };
  EXPECT_LT((steps(80000) - steps(20000)) / 60000, 10);
}

// Solids that were moved each in its own way: a point finds its frame without a look at the others.
TEST(Growth, LoadingPointsOfManyFrames) {
  EXPECT_LT(
      growth(
          [](std::size_t n) {
            auto from = std::make_shared<Geometry>();
            for (std::size_t i = 0; i < n; ++i) {
              const double by = static_cast<double>(i);
              const auto frame = std::make_shared<const Frame>(
                  std::array<double, 12>{1, 0, 0, by, 0, 1, 0, 0, 0, 0, 1, 0});
              from->add_point(MovedPoint{{1, 2, 3}, from->frames.place(frame)}, {1 + by, 2, 3});
            }
            return [from] {
              Geometry to;
              for (std::size_t part = 0; part < 4; ++part) {  // as from several blocks
                GeometryLoader loader(*from, to, 64);
                for (const PointId p : from->positions.ids())
                  if (p.value() % 4 == part) loader.point(p);
              }
            };
          },
          5000),
      n_log_n);
}

// On a grid that has all of the sphere's corners, but not those of the dent. Edges beside the seam
// are flipped; what is far from it is not looked at for that.
TEST(Growth, WritingASphereWithADent) {
  Rounding grid;
  grid.numbers = Rounding::Numbers::grid;
  grid.spacing = 0x1p-16;
  const auto dented = [&](std::size_t n) {
    const Solid tool = Solid::from_mesh(
        transformed(sphere_of(500).to_mesh(), Transform::translation({1.21, 0.13, 0.05})));
    return boolean(Solid::from_mesh(rounded_mesh(sphere_of(n), grid).mesh), tool,
                   Operation::subtract);
  };
  const Solid few = dented(5000), many = dented(80000);
  ASSERT_GT(rounded_mesh(many, grid).report.flipped, 0u);
  const auto more = static_cast<double>(many.counts().faces - few.counts().faces);
  const auto per_face = [&](const Rounding& how) {
    const auto of = [&](const Solid& solid) {
      return static_cast<double>(steps_of([&] { rounded_mesh(solid, how); }));
    };
    return (of(many) - of(few)) / more;
  };
  Rounding whole = grid;
  whole.separate_touching = true;  // everything is looked at for that
  EXPECT_LT(per_face(grid), per_face(whole) / 4);
}

// Most triangles are written as they came; only those beside the cut are cut, rounded and looked
// at.
TEST(Growth, WritingASphereOfWhichLittleWasCut) {
  const Solid tool = transformed(block({0.9, -0.05, -0.05}, {1.2, 0.05, 0.05}),
                                 Transform::rotation_degrees({1, 2, 3}, 40));
  const auto cut = [&](std::size_t n) {
    return boolean(Solid::from_mesh(sphere_of(n).to_mesh()), tool, Operation::subtract);
  };
  const Solid few = cut(20000), many = cut(80000);
  const auto per_face = [&](const auto& work) {
    const auto of = [&](const Solid& solid) {
      return static_cast<double>(steps_of([&] { work(solid); }));
    };
    return (of(many) - of(few)) / 60000;
  };
  EXPECT_LT(per_face([](const Solid& solid) { rounded_mesh(solid); }), 55);
  EXPECT_LT(per_face([](const Solid& solid) { solid.to_mesh(); }), 40);
}

// Only the shells that were cut are tested again.
TEST(Growth, WritingManyBlocksOfWhichHalfAreCut) {
  EXPECT_LT(growth(
                [](std::size_t n) {
                  const auto side = static_cast<int>(std::sqrt(static_cast<double>(n)));
                  PolygonMesh blocks;
                  for (int i = 0; i < side; ++i)
                    for (int j = 0; j < side; ++j)
                      add_block(blocks, {i + 0.1, j + 0.1, 0}, {i + 0.9, j + 0.9, 1});
                  const Solid half =
                      transformed(block({-1, -1, -1}, {side / 2 + 0.3, side + 1.0, 2}),
                                  Transform::rotation_degrees({0, 0, 1}, 10));
                  const Solid rest =
                      boolean(Solid::from_mesh(in_triangles(blocks)), half, Operation::subtract);
                  return [rest] { rounded_mesh(rest); };
                },
                1600),
            n_log_n);
}

// Far from the origin, where floats are two apart: of the corners, very many come to each place,
// and all of the smallest sphere's to one. Most triangles have no area there.
TEST(Growth, WritingASphereOfAFewStepsInFloats) {
  Rounding floats;
  floats.numbers = Rounding::Numbers::floats;
  for (const double radius : {0.9, 2.2, 8.6}) {
    const auto work = [&](std::size_t n) {
      const auto rings = static_cast<std::uint32_t>(std::sqrt(static_cast<double>(n) / 4));
      const Solid ball = transformed(sphere(radius, 2 * rings, rings),
                                     Transform::translation({0x3p23, 0x3p23, 0x3p23}));
      return [=] { rounded_mesh(ball, floats); };
    };
    EXPECT_LT(growth(work, 2000), n_log_n) << "radius " << radius;
  }
}

TEST(Growth, OfAConeOnItsBase) {
  const auto work = [](std::size_t sides) {
    return [sides] { cone(1, 0, 1, static_cast<std::uint32_t>(sides)); };
  };
  EXPECT_LT(growth(work, 1000), n_log_n);
}

}  // namespace
}  // namespace sectile
