#include "cases.h"

#include <cstdint>
#include <utility>

#include "sectile/primitives.h"
#include "sectile/transform.h"

namespace sectile::bench {
namespace {

/// Two spheres of 2·segments·(rings - 1) raw triangles each, half a radius apart off the axes.
Case spheres(const char* name, std::uint32_t segments, std::uint32_t rings) {
  return {name, Operation::unite, [=]() -> MakeOperands {
            return [a = sphere_mesh({0, 0, 0}, 1, segments, rings),
                    b = sphere_mesh({0.41, 0.23, 0.17}, 1, segments, rings)] {
              return std::pair(Solid::from_mesh(a), Solid::from_mesh(b));
            };
          }};
}

/// The box of each of the block's faces holds all of the sphere, but its plane cuts one circle.
Case halved(const char* name, std::uint32_t segments, std::uint32_t rings) {
  return {name, Operation::subtract, [=]() -> MakeOperands {
            const auto turn = Transform::rotation_degrees({1, 2, 3}, 40);
            return [mesh = sphere_mesh({0, 0, 0}, 1, segments, rings),
                    block = transformed(block({0.1, -2, -2}, {4, 2, 2}), turn)] {
              return std::pair(Solid::from_mesh(mesh), block);
            };
          }};
}

Case turned_cube() {
  return {"cube minus turned cube", Operation::subtract, []() -> MakeOperands {
            const PolygonMesh cube = block({-1, -1, -1}, {1, 1, 1}).to_mesh();
            const auto turn = Transform::rotation_degrees({1, 2, 3}, 40);
            return [cube, turned = transformed(cube, turn)] {
              return std::pair(Solid::from_mesh(cube), Solid::from_mesh(turned));
            };
          }};
}

/// A plate of 2·columns × 2·rows with a square hole in each 2 × 2 field.
Solid perforated_plate(int columns, int rows) {
  Profile plate;
  const double width = 2 * columns, depth = 2 * rows;
  plate.outer = {{0, 0}, {width, 0}, {width, depth}, {0, depth}};
  for (int column = 0; column < columns; ++column)
    for (int row = 0; row < rows; ++row) {
      const double x = 2 * column + 0.5, y = 2 * row + 0.5;
      plate.holes.push_back({{x, y}, {x, y + 1}, {x + 1, y + 1}, {x + 1, y}});
    }
  return extrude(plate, 1);
}

/// The slab stands across the plate and passes through a row of holes: all other holes have to
/// find the piece of the face that they are in.
Case plate_cut_across(const char* name, int columns, int rows) {
  return {name, Operation::subtract, [=]() -> MakeOperands {
            return [=] {
              const double middle = 2 * (rows / 2) + 1;
              return std::pair(
                  perforated_plate(columns, rows),
                  block({-1, middle - 0.25, -1}, {2.0 * columns + 1, middle + 0.25, 2}));
            };
          }};
}

/// The slab lies in the plate: it cuts the walls of all holes.
Case plate_cut_along(const char* name, int columns, int rows) {
  return {name, Operation::subtract, [=]() -> MakeOperands {
            return [=] {
              return std::pair(perforated_plate(columns, rows),
                               block({-1, -1, 0.25}, {2.0 * columns + 1, 2.0 * rows + 1, 0.75}));
            };
          }};
}

Case cones(const char* name, std::uint32_t sides) {
  return {
      name, Operation::unite, [=]() -> MakeOperands {
        return [=] {
          Solid standing = cone(1, 0, 1, sides);
          const auto mirror = Transform::translation({0, 0, 2}) * Transform::scaling({1, 1, -1});
          Solid hanging = transformed(standing, mirror);
          return std::pair(std::move(standing), std::move(hanging));
        };
      }};
}

}  // namespace

std::vector<Case> cases() {
  return {
      turned_cube(),
      spheres("spheres of 1,000 triangles", 25, 21),
      spheres("spheres of 100,000 triangles", 250, 201),
      spheres("spheres of 1,000,000 triangles", 1000, 501),
      halved("sphere of 100,000 triangles halved", 250, 201),
      halved("sphere of 1,000,000 triangles halved", 1000, 501),
      plate_cut_across("plate with 1,000 holes cut across", 40, 25),
      plate_cut_across("plate with 10,000 holes cut across", 100, 100),
      plate_cut_along("plate with 1,000 holes cut along", 40, 25),
      plate_cut_along("plate with 10,000 holes cut along", 100, 100),
      cones("1,000-gon cones apex to apex", 1000),
      cones("10,000-gon cones apex to apex", 10000),
  };
}

}  // namespace sectile::bench
