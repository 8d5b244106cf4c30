// Points of integer coordinates in solids of integer corners, judged by crossings of rays in random
// directions with all faces, in integers.
#include "boolean/components/point_in_solid.h"

#include <gtest/gtest.h>

#include <array>
#include <optional>
#include <random>

#include "sectile/sectile.h"

namespace sectile {
namespace {

using Integers = std::array<std::int64_t, 3>;

Integers integers(const Vec3& p) {
  return {std::llround(p.x), std::llround(p.y), std::llround(p.z)};
}
Integers operator-(const Integers& p, const Integers& q) {
  return {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
}
std::int64_t det(const Integers& u, const Integers& v, const Integers& w) {
  return u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0]) +
         u[2] * (v[0] * w[1] - v[1] * w[0]);
}
std::int64_t dot(const Integers& u, const Integers& v) {
  return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
}
bool are_parallel(const Integers& u, const Integers& v) {
  return u[1] * v[2] == u[2] * v[1] && u[2] * v[0] == u[0] * v[2] && u[0] * v[1] == u[1] * v[0];
}
bool is_beside(const Integers& u, const Integers& v) {
  return are_parallel(u, v) && dot(u, v) > 0;
}
/// Or is one of them zero?
bool are_opposite(const Integers& u, const Integers& v) {
  return are_parallel(u, v) && dot(u, v) <= 0;
}
int sign(std::int64_t value) {
  return value > 0 ? 1 : value < 0 ? -1 : 0;
}

// All faces, one by one.
class Crossings {
 public:
  explicit Crossings(const Solid& solid) {
    const PolygonMesh mesh = solid.to_mesh();
    std::size_t corner = 0;
    for (const std::uint32_t size : mesh.face_sizes) {
      faces_.emplace_back();
      for (std::uint32_t i = 0; i < size; ++i)
        faces_.back().push_back(integers(mesh.positions[mesh.indices[corner++]]));
    }
  }

  /// Nothing if the point is on the boundary, or on a side of one of the triangles.
  std::optional<bool> is_inside(const Integers& p) {
    while (true) {
      const Integers way{number(), number(), number()};
      int layers = 0;
      bool on_boundary = false, clear = true;
      for (const auto& face : faces_) clear = clear && add(face, p, way, layers, on_boundary);
      if (!clear) continue;
      if (on_boundary) return {};
      return layers > 0;
    }
  }

 private:
  std::int64_t number() { return static_cast<std::int64_t>(random_() % 2001) - 1000; }

  // As the triangles of a fan, each with its sign. False if the line meets one of their edges.
  static bool add(const std::vector<Integers>& face, const Integers& p, const Integers& way,
                  int& layers, bool& on_boundary) {
    int crossings = 0;
    std::int64_t volume = 0;  // between the point and the face
    for (std::size_t i = 1; i + 1 < face.size(); ++i) {
      const Integers u = face[0] - p, v = face[i] - p, w = face[i + 1] - p;
      // A triangle whose plane the line meets beside it.
      if (is_beside(u, v) || is_beside(v, w) || is_beside(w, u)) continue;
      if (are_opposite(u, v) || are_opposite(v, w) || are_opposite(w, u)) {
        on_boundary = true;
        return true;
      }
      const int signs[] = {sign(det(way, u, v)), sign(det(way, v, w)), sign(det(way, w, u))};
      volume += det(u, v, w);
      if (signs[0] == 0 || signs[1] == 0 || signs[2] == 0) return false;
      if (signs[0] == signs[1] && signs[1] == signs[2]) crossings += signs[0];
    }
    if (crossings != 0 && volume == 0) on_boundary = true;
    // The sign of a crossing is that of the normal along the way. The face is ahead if its normal
    // points away from the point then, too.
    if (crossings * sign(volume) > 0) layers += crossings;
    return true;
  }

  std::vector<std::vector<Integers>> faces_;
  std::minstd_rand random_{1};
};

void expect_located(const Solid& solid, const std::vector<Integers>& points,
                    std::size_t least_inside) {
  const BooleanOptions options;
  Workspace w(options);
  w.patch[Operand::b].solid = solid.data().get();
  w.kernel = std::make_unique<Kernel>(w.geometry);
  PointInSolid is_inside(w, Operand::b);
  Crossings crossings(solid);
  std::size_t counts[2] = {0, 0};
  for (const Integers& p : points) {
    const std::optional<bool> expected = crossings.is_inside(p);
    if (!expected) continue;
    const PointId point = w.geometry.add_point(Vec3{double(p[0]), double(p[1]), double(p[2])});
    w.kernel->refresh();
    ASSERT_EQ(is_inside(point), *expected) << p[0] << " " << p[1] << " " << p[2];
    ++counts[*expected ? 1 : 0];
  }
  EXPECT_GT(counts[0], points.size() / 10);
  EXPECT_GE(counts[1], least_inside);
}

void expect_located(const Solid& solid, const std::vector<Integers>& points) {
  expect_located(solid, points, points.size() / 20);
}

void add_face(PolygonMesh& mesh, const std::vector<std::uint32_t>& corners) {
  mesh.face_sizes.push_back(static_cast<std::uint32_t>(corners.size()));
  mesh.indices.insert(mesh.indices.end(), corners.begin(), corners.end());
}

// Over a polygon that runs counter-clockwise.
void add_prism(PolygonMesh& mesh, const std::vector<Vec2>& outline, double low, double high) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size()),
             count = static_cast<std::uint32_t>(outline.size());
  for (const double z : {low, high})
    for (const Vec2& p : outline) mesh.positions.push_back({p.x, p.y, z});
  std::vector<std::uint32_t> bottom, top;
  for (std::uint32_t i = 0; i < count; ++i) {
    bottom.push_back(first + count - 1 - i);
    top.push_back(first + count + i);
    const std::uint32_t j = (i + 1) % count;
    add_face(mesh, {first + i, first + j, first + count + j, first + count + i});
  }
  add_face(mesh, bottom);
  add_face(mesh, top);
}

// A linear map that keeps integers, and orientation, but no axis.
Vec3 slanted(const Vec3& p) {
  return {2 * p.x + p.y, p.y + p.z, p.x + p.z};
}
Integers slanted(const Integers& p) {
  return {2 * p[0] + p[1], p[1] + p[2], p[0] + p[2]};
}

struct Case {
  PolygonMesh mesh;
  std::vector<Integers> points;

  Case slanted() const {
    Case turned = *this;
    for (Vec3& p : turned.mesh.positions) p = sectile::slanted(p);
    for (Integers& p : turned.points) p = sectile::slanted(p);
    return turned;
  }
};

std::vector<Integers> grid(const Integers& low, const Integers& high) {
  std::vector<Integers> points;
  for (std::int64_t x = low[0]; x <= high[0]; ++x)
    for (std::int64_t y = low[1]; y <= high[1]; ++y)
      for (std::int64_t z = low[2]; z <= high[2]; ++z) points.push_back({x, y, z});
  return points;
}

// With teeth from 4 i to 4 i + 2; all corners are level with points.
Case comb(int teeth) {
  const double length = 4 * teeth;
  std::vector<Vec2> outline{{-2, -4}, {length + 2, -4}};
  for (int i = teeth; i-- > 0;)
    outline.insert(outline.end(), {{4.0 * i + 2, 0}, {4.0 * i + 2, 6}, {4.0 * i, 6}, {4.0 * i, 0}});
  Case result;
  add_prism(result.mesh, outline, 0, 4);
  result.points = grid({-3, -1, -1}, {4 * teeth + 3, 7, 4});
  return result;
}

// Thin walls around the z axis, with points in them and between them.
Case walls(int of_a_quarter) {
  constexpr double far = 4096;
  Case result;
  for (int quarter = 0; quarter < 4; ++quarter) {
    const auto turned = [&](double x, double y) {
      const Vec2 all[] = {{x, y}, {-y, x}, {-x, -y}, {y, -x}};
      return all[quarter];
    };
    for (int i = -of_a_quarter; i < of_a_quarter; ++i) {
      const double a = 64.0 * i, b = a + 32;
      add_prism(result.mesh, {{0, 0}, turned(far, a), turned(far, b)}, 0, 1024);
      for (const double share : {0.125, 0.5, 0.75})
        for (const double across : {a + 16, a + 48, a + 8, a + 40}) {
          const Vec2 p = turned(share * far, share * across);
          result.points.push_back(integers({p.x, p.y, 100.0 + i}));
        }
    }
  }
  return result;
}

// Cubes that touch each other along edges only.
Case touching_cubes(int side) {
  Case result;
  for (int x = 0; x < side; ++x)
    for (int y = 0; y < side; ++y)
      for (int z = 0; z < side; ++z) {
        if ((x + y + z) % 2 != 0) continue;
        const double u = 4 * x, v = 4 * y;
        add_prism(result.mesh, {{u, v}, {u + 4, v}, {u + 4, v + 4}, {u, v + 4}}, 4 * z, 4 * z + 4);
      }
  result.points = grid({-1, -1, -1}, {4 * side + 1, 4 * side + 1, 4 * side + 1});
  std::erase_if(result.points, [](const Integers& p) { return (p[0] + 3 * p[1] + p[2]) % 7 != 0; });
  return result;
}

// Long ones that lie aslant beside each other.
Case needles(int side) {
  Case result;
  std::minstd_rand random(3);
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j) {
      const double x = 16 * i, y = 16 * j, length = 16 * side;
      add_prism(result.mesh, {{x, y}, {x + 8, y}, {x, y + 8}}, 0, length);
      for (std::size_t k = result.mesh.positions.size() - 3; k < result.mesh.positions.size();
           ++k) {
        result.mesh.positions[k].x += length;
        result.mesh.positions[k].y += 0.75 * length;
      }
      const auto z = static_cast<std::int64_t>(4 * (random() % (4 * static_cast<unsigned>(side))));
      for (const std::int64_t off : {0, 1, 3, 8, 9, 12})
        result.points.push_back({16 * i + off + z, 16 * j + 2 + 3 * z / 4, z});
    }
  return result;
}

TEST(PointInSolid, BetweenTheTeethOfACombAndInThem) {
  const Case upright = comb(40);
  expect_located(Solid::from_mesh(upright.mesh), upright.points);
  expect_located(Solid::from_mesh(upright.slanted().mesh), upright.slanted().points);
}

TEST(PointInSolid, BetweenWallsAroundOneLineAndInThem) {
  const Case upright = walls(40);
  expect_located(Solid::from_mesh(upright.mesh), upright.points);
  expect_located(Solid::from_mesh(upright.slanted().mesh), upright.slanted().points);
}

TEST(PointInSolid, AmongCubesThatTouchAlongEdges) {
  const Case upright = touching_cubes(5);
  expect_located(Solid::from_mesh(upright.mesh), upright.points);
  expect_located(Solid::from_mesh(upright.slanted().mesh), upright.slanted().points);
}

TEST(PointInSolid, BetweenNeedlesAndInThem) {
  const Case upright = needles(12);
  expect_located(Solid::from_mesh(upright.mesh), upright.points);
  expect_located(Solid::from_mesh(upright.slanted().mesh), upright.slanted().points);
}

// Of so few faces that all are loaded with one. Points are level with corners.
TEST(PointInSolid, BesideSingleTetrahedraAndInThem) {
  std::minstd_rand random(5);
  const auto number = [&] { return static_cast<double>(random() % 7) - 3; };
  std::size_t made = 0;
  while (made < 40) {
    std::array<Vec3, 4> p;
    for (Vec3& corner : p) corner = {number(), number(), number()};
    const Integers u = integers(p[1]) - integers(p[0]), v = integers(p[2]) - integers(p[0]),
                   w = integers(p[3]) - integers(p[0]);
    if (det(u, v, w) < 20) continue;
    ++made;
    const PolygonMesh mesh{
        {p.begin(), p.end()}, {3, 3, 3, 3}, {0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2}};
    expect_located(Solid::from_mesh(mesh), grid({-4, -3, -3}, {3, 3, 3}), 0);
  }
}

// Blocks of what was taken away are in the result, turned.
TEST(PointInSolid, InASolidWithTurnedBlocks) {
  for (const Case& turned : {comb(80).slanted(), needles(10), walls(20)}) {
    const Solid tool = Solid::from_mesh(turned.mesh);
    const Solid rest =
        boolean(block({-40000, -40000, -40000}, {40000, 40000, 40000}), tool, Operation::subtract);
    ASSERT_TRUE(std::ranges::any_of(rest.data()->slots(), [](const Slot& s) { return s.turned; }));
    std::vector<Integers> points = turned.points;
    points.push_back({40001, 0, 0});
    expect_located(rest, points);
  }
}

}  // namespace
}  // namespace sectile
