// What is no solid is refused, with the place and what to do.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "sectile/sectile.h"
#include "unit/import/cell_mesh.h"

namespace sectile {
namespace {

using Reason = InvalidSolid::Reason;
using Faces = std::vector<std::vector<std::uint32_t>>;

struct Refusal {
  Reason reason;
  std::uint32_t face = no_element, vertex = no_element;
  std::vector<std::string> words;
};

void expect_refused(const PolygonMesh& mesh, const Refusal& expected) {
  try {
    Solid::from_mesh(mesh);
    ADD_FAILURE() << "accepted";
  } catch (const InvalidSolid& error) {
    EXPECT_EQ(error.reason(), expected.reason) << error.what();
    EXPECT_EQ(error.face(), expected.face) << error.what();
    EXPECT_EQ(error.vertex(), expected.vertex) << error.what();
    for (const std::string& word : expected.words)
      EXPECT_NE(std::string(error.what()).find(word), std::string::npos)
          << word << " is not in: " << error.what();
  }
}

PolygonMesh cube_with(std::size_t number, const std::vector<std::uint32_t>& face) {
  Faces faces = faces_of(cube_mesh());
  faces[number] = face;
  return with_faces(cube_mesh().positions, faces);
}

TEST(ImportRefusal, AMissingFace) {
  Faces faces = faces_of(cube_mesh());
  faces.erase(faces.begin() + 1);  // the top
  expect_refused(with_faces(cube_mesh().positions, faces),
                 {Reason::open, 1, 4, {"(0, 0, 1)", "(1, 0, 1)", "close the hole"}});
}

TEST(ImportRefusal, ATurnedFace) {
  expect_refused(cube_with(1, {7, 6, 5, 4}),
                 {Reason::inconsistent, 1, 4, {"faces 1 and 2", "the same way", "turn one"}});
}

TEST(ImportRefusal, AnIndexOutOfRange) {
  expect_refused(cube_with(3, {1, 2, 6, 8}),
                 {Reason::index_out_of_range, 3, 8, {"face 3", "vertex 8", "only 8"}});
}

TEST(ImportRefusal, CoordinatesThatAreNoNumbers) {
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity(),
                           -std::numeric_limits<double>::infinity()})
    for (int axis = 0; axis < 3; ++axis) {
      PolygonMesh mesh = cube_mesh();
      Vec3& p = mesh.positions[5];
      (axis == 0 ? p.x : axis == 1 ? p.y : p.z) = bad;
      expect_refused(mesh, {Reason::not_finite, no_element, 5, {"vertex 5"}});
    }
}

TEST(ImportRefusal, SizesThatDoNotFit) {
  PolygonMesh mesh = cube_mesh();
  mesh.indices.pop_back();
  expect_refused(mesh, {Reason::malformed, no_element, no_element, {"24", "23"}});
  mesh = cube_mesh();
  mesh.face_sizes[0] = 0xFFFFFFFFu;
  expect_refused(mesh, {Reason::malformed, no_element, no_element, {}});
}

TEST(ImportRefusal, AFaceWhoseEdgesCross) {
  expect_refused(cube_with(1, {4, 6, 5, 7}),
                 {Reason::self_intersecting, 1, no_element, {"face 1", "split it"}});
}

TEST(ImportRefusal, ALargeFaceWhoseEdgesCross) {
  std::vector<Vec3> positions;
  std::vector<std::uint32_t> face;
  for (std::uint32_t i = 0; i < 100; ++i) {
    positions.push_back({std::cos(i * 0.06), std::sin(i * 0.06), 0});
    face.push_back(i);
  }
  std::swap(face[40], face[60]);
  expect_refused(with_faces(positions, {face}),
                 {Reason::self_intersecting, 0, no_element, {"face 0", "cross"}});
}

TEST(ImportRefusal, InsideOut) {
  expect_refused(turned_over(cube_mesh()),
                 {Reason::inside_out, 0, no_element, {"inside out", "turn all its faces around"}});
}

TEST(ImportRefusal, AShellInsideOutBesideALargerOne) {
  expect_refused(joined(cube_mesh({0, 0, 0}, 10), turned_over(cube_mesh({20, 0, 0}))),
                 {Reason::inside_out, 6, no_element, {"face 6"}});
}

TEST(ImportRefusal, AShellInsideOutInTheNotchOfAnother) {
  // In the box of the first shell, but not in its material.
  expect_refused(joined(cell_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}),
                        turned_over(cube_mesh({1.25, 1.25, 0.25}, 0.5))),
                 {Reason::inside_out, 14, no_element, {"face 14"}});
}

TEST(ImportRefusal, AVoidInAVoid) {
  expect_refused(joined(joined(cube_mesh({0, 0, 0}, 9), turned_over(cube_mesh({1, 1, 1}, 7))),
                        turned_over(cube_mesh({2, 2, 2}, 5))),
                 {Reason::inside_out, 12, no_element, {"face 12"}});
}

TEST(ImportRefusal, MaterialInMaterial) {
  expect_refused(joined(cube_mesh({0, 0, 0}, 9), cube_mesh({1, 1, 1}, 7)),
                 {Reason::self_intersecting, 6, no_element, {"face 6", "unite"}});
}

TEST(ImportRefusal, ShellsOnEachOther) {
  EXPECT_THROW(Solid::from_mesh(joined(cube_mesh(), cube_mesh({0, 0, 1}))), InvalidSolid);
}

TEST(ImportRefusal, AThinShellInsideOut) {
  // Its volume is far below the rounding error of a sum in doubles.
  PolygonMesh mesh = cube_mesh({1e6, 1e6, 1e6});
  for (std::size_t i = 4; i < 8; ++i) mesh.positions[i].z = std::nextafter(1e6, 2e6);
  EXPECT_FALSE(Solid::from_mesh(mesh).is_empty());
  expect_refused(turned_over(mesh), {Reason::inside_out, 0, no_element, {}});
}

TEST(ImportRefusal, TwoFacesOnEachOther) {
  expect_refused(with_faces({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {2, 1, 0}}),
                 {Reason::self_intersecting, 0, no_element, {"faces 0 and 1", "folded"}});
}

TEST(ImportRefusal, ACubeTwice) {
  const PolygonMesh mesh = joined(cube_mesh(), cube_mesh());
  EXPECT_THROW(Solid::from_mesh(mesh), InvalidSolid);
}

TEST(ImportRefusal, AFlatFaceDoesNotCloseAHole) {
  // The flat triangle divides the edge of face 2, whose other side is still open.
  std::vector<Vec3> positions = cube_mesh().positions;
  positions.push_back({0.5, 0, 1});
  Faces faces = faces_of(cube_mesh());
  faces[1] = {4, 5, 8};
  expect_refused(with_faces(positions, faces), {Reason::open, 2, 4, {}});
}

}  // namespace
}  // namespace sectile
