// Faces of two solids that are the same, corner by corner.
#include "boolean/near/face_match.h"

#include <gtest/gtest.h>

#include "sectile/sectile.h"

namespace sectile {
namespace {

// How many faces of a are faces of b: with the same and with the other side of material.
struct Matches {
  int plus = 0, minus = 0;
};

template <class Visit>
void for_each_face(const Solid& solid, const Visit& visit) {
  for (std::uint32_t s = 0; s < solid.data()->slots().size(); ++s)
    for (std::uint32_t f = 0; f < solid.data()->slot(s).faces; ++f) visit(FaceAt{s, FaceId(f)});
}

Matches matches(const Solid& a, const Solid& b) {
  FaceMatch match(*a.data(), *b.data());
  Matches found;
  for_each_face(a, [&](const FaceAt& f) {
    for_each_face(b, [&](const FaceAt& g) {
      if (const auto cls = match(f, g)) ++(*cls == Class::on_plus ? found.plus : found.minus);
    });
  });
  return found;
}

// The same solid, whose faces begin with other corners, and come in another order.
Solid read_anew(const Solid& solid, std::size_t turn) {
  const PolygonMesh mesh = solid.to_mesh();
  PolygonMesh anew;
  anew.positions = mesh.positions;
  std::vector<std::uint32_t> begin = {0};
  for (const std::uint32_t size : mesh.face_sizes) begin.push_back(begin.back() + size);
  for (std::size_t i = 0; i < mesh.face_sizes.size(); ++i) {
    const std::size_t f = (i + turn) % mesh.face_sizes.size(), size = mesh.face_sizes[f];
    anew.face_sizes.push_back(mesh.face_sizes[f]);
    for (std::size_t k = 0; k < size; ++k)
      anew.indices.push_back(mesh.indices[begin[f] + (k + turn) % size]);
  }
  return Solid::from_mesh(anew);
}

TEST(FaceMatch, OfASolidReadAgainInAnotherOrder) {
  const Solid solid = pyramid(1, 2, 7);
  for (const std::size_t turn : {0u, 1u, 2u, 5u}) {
    const Matches found = matches(solid, read_anew(solid, turn));
    EXPECT_EQ(found.plus, 8);
    EXPECT_EQ(found.minus, 0);
  }
}

TEST(FaceMatch, OfBlocksSideBySideIsTheOneBetweenThem) {
  const Solid one = block({0, 0, 0}, {1, 1, 1});
  const Matches flush = matches(one, block({1, 0, 0}, {2, 1, 1}));
  EXPECT_EQ(flush.plus, 0);
  EXPECT_EQ(flush.minus, 1);
  const Matches higher = matches(one, block({1, 0, 0}, {2, 1, 1.5}));
  EXPECT_EQ(higher.plus + higher.minus, 0);
}

TEST(FaceMatch, OfFacesWithHolesInAnyOrder) {
  const auto plate = [](std::initializer_list<Vec2> holes, double height) {
    Profile profile{{{0, 0}, {9, 0}, {9, 9}, {0, 9}}, {}};
    for (const Vec2& at : holes)
      profile.holes.push_back({at, {at.x + 1, at.y}, {at.x + 0.5, at.y + 1}});
    return extrude(profile, height);
  };
  const Solid plate_of_three = plate({{1, 1}, {3, 4}, {6, 2}}, 1);
  const Matches found = matches(plate_of_three, plate({{6, 2}, {1, 1}, {3, 4}}, 1));
  EXPECT_EQ(found.plus, 2 + 4 + 9);
  EXPECT_EQ(found.minus, 0);
  EXPECT_EQ(matches(plate_of_three, plate({{6, 2}, {1, 1}, {3, 4}}, 2)).plus, 1);  // the lower face
  EXPECT_EQ(matches(plate_of_three, plate({{6, 2}, {1, 1}}, 1)).plus, 4 + 6);      // sides
}

// Both images have corners that no doubles hold.
TEST(FaceMatch, OfSolidsMovedAlike) {
  const Solid one = pyramid(1, 2, 7), other = read_anew(one, 3);
  const Transform move = Transform::rotation_degrees({1, 2, 3}, 31),
                  nearly = Transform::rotation_degrees({1, 2, 3}, 31 + 0x1p-48);
  EXPECT_EQ(matches(transformed(one, move), transformed(other, move)).plus, 8);
  EXPECT_EQ(matches(transformed(one, move), transformed(other, nearly)).plus, 0);
}

TEST(FaceMatch, OfAMirroredSolidIsNone) {
  const Solid one = pyramid(1, 2, 7);
  const Matches found = matches(one, transformed(one, Transform::scaling({1, 1, -1})));
  EXPECT_EQ(found.plus, 0);
  EXPECT_EQ(found.minus, 1);  // its ground
}

}  // namespace
}  // namespace sectile
