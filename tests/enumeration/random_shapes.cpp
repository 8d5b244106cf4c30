#include "random_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace sectile::test {
namespace {

Vec3 minus(const Vec3& a, const Vec3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
double determinant(const Vec3& a, const Vec3& b, const Vec3& c) {
  return a.x * (b.y * c.z - b.z * c.y) - a.y * (b.x * c.z - b.z * c.x) +
         a.z * (b.x * c.y - b.y * c.x);
}

}  // namespace

int RandomShapes::number(int low, int high) {
  return low + static_cast<int>(random_() % static_cast<unsigned>(high - low + 1));
}

template <class Make>
Solid RandomShapes::in_box(const Make& make) {
  const int x = number(0, 2), y = number(0, 2), z = number(0, 2);
  const Vec3 high{real(x + 1, 3), real(y + 1, 3), real(z + 1, 3)};
  return make(Vec3{double(x), double(y), double(z)}, high);
}

Solid RandomShapes::tetrahedron() {
  PolygonMesh mesh;
  double volume = 0;
  while (volume == 0) {
    mesh.positions.clear();
    for (int i = 0; i < 4; ++i) {
      const double x = real(0, 3), y = real(0, 3), z = real(0, 3);
      mesh.positions.push_back({x, y, z});
    }
    const auto& p = mesh.positions;
    volume = determinant(minus(p[1], p[0]), minus(p[2], p[0]), minus(p[3], p[0]));
  }
  if (volume < 0) std::swap(mesh.positions[0], mesh.positions[1]);
  mesh.face_sizes = {3, 3, 3, 3};
  mesh.indices = {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3};
  return Solid::from_mesh(mesh);
}

Solid RandomShapes::cells() {
  Solid all;
  for (int i = number(2, 6); i > 0; --i) {
    const double x = real(0, 3), y = real(0, 3), z = real(0, 3);
    all = boolean(all, block({x, y, z}, {x + 1, y + 1, z + 1}), Operation::unite);
  }
  return all;
}

Solid RandomShapes::shape() {
  switch (number(0, 7)) {
    case 0:
    case 1:
      return in_box([](const Vec3& low, const Vec3& high) { return block(low, high); });
    case 2:
    case 3:
      return tetrahedron();
    case 4:
      return in_box([](const Vec3& low, const Vec3& high) { return wedge(low, high); });
    case 5: {
      const auto segments = static_cast<std::uint32_t>(number(4, 9));
      const auto rings = static_cast<std::uint32_t>(number(3, 6));
      const double x = real(0, 6) / 2, y = real(0, 6) / 2, z = real(0, 6) / 2;
      return transformed(sphere(1.25, segments, rings), Transform::translation({x, y, z}));
    }
    case 6: {
      const auto sides = static_cast<std::uint32_t>(number(3, 7));
      const double x = real(0, 3), y = real(0, 3), z = real(0, 2);
      return transformed(prism(1, 2, sides), Transform::translation({x, y, z}));
    }
    default:
      return cells();
  }
}

Transform RandomShapes::map() {
  switch (number(0, 8)) {
    case 0: {
      const double x = real(-1, 1), y = real(-1, 1), z = real(-1, 1);
      return Transform::translation({x, y, z});
    }
    case 1: {
      std::array<std::size_t, 3> axes{0, 1, 2};
      std::shuffle(axes.begin(), axes.end(), random_);
      Transform swap{{}};
      for (std::size_t k = 0; k < 3; ++k) {
        const bool mirrored = number(0, 1) == 1;
        swap.m[4 * k + axes[k]] = mirrored ? -1 : 1;
        swap.m[4 * k + 3] = mirrored ? 3 : 0;
      }
      return swap;
    }
    case 2:
      return {{0.6, -0.8, 0, 1, 0.8, 0.6, 0, 0, 0, 0, 1, 0}};
    case 3: {
      const double xy = real(-1, 1), yz = real(-1, 1);
      return {{1, xy, 0, 0, 0, 1, yz, 0, 0, 0, 1, 0}};
    }
    case 4: {
      const double third = 1 / 3.0, two = 2 / 3.0;
      return {{third, -two, two, 0, two, two, third, 0, -two, third, two, 1}};
    }
    case 5: {
      const double size = std::ldexp(1.0, number(-40, 40));
      return Transform::scaling({size, size, size});
    }
    case 6: {
      const double little = std::pow(10.0, real(-17, -5));
      return Transform::translation({little, -little, 0});
    }
    case 7: {
      const double x = real(-1, 1), y = real(-2, 2);
      return Transform::rotation_degrees({x, y, 3}, std::pow(10.0, real(-16, -1)));
    }
    default:
      return Transform::rotation_degrees({1, 2, 3}, real(1, 359));
  }
}

HalfSpace RandomShapes::half_space() {
  const double a = real(-2, 2), b = real(-2, 2), c = real(1, 2), d = real(-6, 0);
  return {a, b, c, d};
}

}  // namespace sectile::test
