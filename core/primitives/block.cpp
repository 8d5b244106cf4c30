#include <cmath>

#include "primitives/arguments.h"
#include "primitives/soup_builder.h"
#include "sectile/primitives.h"

namespace sectile {

namespace {

void require_extent(const Vec3& low, const Vec3& high) {
  const double lows[] = {low.x, low.y, low.z}, highs[] = {high.x, high.y, high.z};
  for (int axis = 0; axis < 3; ++axis) {
    const std::string name(1, "xyz"[axis]);
    require(std::isfinite(lows[axis]) && std::isfinite(highs[axis]),
            "The corners must be finite, but they are not in " + name + ".");
    require(lows[axis] < highs[axis],
            "The low corner must lie below the high corner, but it does not in " + name + ".");
  }
}

}  // namespace

//     7------6
//    /|     /|    z  y
//   4------5 |    | /
//   | 3----|-2    |/
//   |/     |/     +---x
//   0------1
Solid block(const Vec3& low, const Vec3& high) {
  require_extent(low, high);
  SoupBuilder soup;
  for (const double z : {low.z, high.z}) {
    soup.add_position({low.x, low.y, z});
    soup.add_position({high.x, low.y, z});
    soup.add_position({high.x, high.y, z});
    soup.add_position({low.x, high.y, z});
  }
  soup.add_face({3, 2, 1, 0});
  soup.add_face({4, 5, 6, 7});
  soup.add_face({0, 1, 5, 4});
  soup.add_face({1, 2, 6, 5});
  soup.add_face({2, 3, 7, 6});
  soup.add_face({3, 0, 4, 7});
  return soup.solid();
}

//   2
//   | \      z
//   |   \    |
//   0-----1  +---x    and 3, 4, 5 behind them
Solid wedge(const Vec3& low, const Vec3& high) {
  require_extent(low, high);
  SoupBuilder soup;
  for (const double y : {low.y, high.y}) {
    soup.add_position({low.x, y, low.z});
    soup.add_position({high.x, y, low.z});
    soup.add_position({low.x, y, high.z});
  }
  soup.add_face({0, 1, 2});
  soup.add_face({5, 4, 3});
  soup.add_face({0, 3, 4, 1});
  soup.add_face({1, 4, 5, 2});
  soup.add_face({2, 5, 3, 0});
  return soup.solid();
}

}  // namespace sectile
