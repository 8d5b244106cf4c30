// Files that are no solids: the panel that says what is wrong with them, and the repair.
#include <gtest/gtest.h>

#include <fstream>

#include "app/picture_maker.h"
#include "evaluation/mesh_edges.h"
#include "viewer/app_driver.h"

namespace sectile::viewer {
namespace {

namespace fs = std::filesystem;

class Repairing : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(testing::TempDir()) / ("sectile_repair_" + std::string(test->name()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path file(const std::string& name, const PolygonMesh& mesh) const {
    write_mesh(folder_ / name, mesh);
    return folder_ / name;
  }

  fs::path folder_;
};

/// A cube as six squares, the second of which looks in direction +z.
PolygonMesh cube(const Vec3& low, double edge) {
  PolygonMesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.positions.push_back(
        {low.x + (i & 1 ? edge : 0), low.y + (i & 2 ? edge : 0), low.z + (i & 4 ? edge : 0)});
  mesh.face_sizes.assign(6, 4);
  mesh.indices = {0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5};
  return mesh;
}

PolygonMesh both(PolygonMesh first, const PolygonMesh& second) {
  const auto offset = static_cast<std::uint32_t>(first.positions.size());
  first.positions.insert(first.positions.end(), second.positions.begin(), second.positions.end());
  first.face_sizes.insert(first.face_sizes.end(), second.face_sizes.begin(),
                          second.face_sizes.end());
  for (const std::uint32_t i : second.indices) first.indices.push_back(offset + i);
  return first;
}

PolygonMesh without_top(PolygonMesh mesh) {
  mesh.face_sizes.pop_back();
  mesh.indices.erase(mesh.indices.begin() + 4, mesh.indices.begin() + 8);
  return mesh;
}

/// Two cubes that cross: 1 + 3.375 − 0.125.
PolygonMesh crossing_cubes() {
  return both(cube({0, 0, 0}, 1), cube({0.5, 0.5, 0.5}, 1.5));
}

const MeshDefects& defects_of(const AppDriver& driver) {
  const MeshDefects* defects = driver.session().results.repair.defects();
  if (!defects) throw std::runtime_error("No defects were found.");
  return *defects;
}

std::size_t count(const MeshDefects& defects, MeshDefect::Kind kind) {
  return static_cast<std::size_t>(std::count_if(defects.list.begin(), defects.list.end(),
                                                [&](const auto& d) { return d.kind == kind; }));
}

TEST_F(Repairing, ACrossingMeshIsListedLitAndRepairedAsOneStepOfUndo) {
  AppDriver driver(1280, 800);
  driver.add("block");
  driver.key(Key::escape);
  const Scene before = driver.scene();
  driver.drop(file("two.obj", crossing_cubes()));
  ASSERT_TRUE(driver.app().has_widget("panel.repair"));
  EXPECT_FALSE(driver.app().has_widget("panel.tree"));
  EXPECT_EQ(driver.scene(), before) << "nothing comes into the scene before it is wanted";
  const MeshDefects& defects = defects_of(driver);
  EXPECT_GT(count(defects, MeshDefect::Kind::contact), 1u);
  EXPECT_EQ(count(defects, MeshDefect::Kind::hole), 0u);
  ASSERT_TRUE(defects.touching);
  EXPECT_EQ(defects.touching->faces.size(), 12u) << "three squares of each cube";
  EXPECT_EQ(driver.faults(), "");

  const RepairPreview* preview = driver.session().results.repair.preview();
  ASSERT_TRUE(preview && preview->mesh);
  EXPECT_EQ(preview->volume, 4.25);
  driver.press("repair.after");
  EXPECT_TRUE(driver.session().results.repair.shows_after);
  driver.press("repair.accept");
  EXPECT_FALSE(driver.app().has_widget("panel.repair"));
  ASSERT_EQ(driver.scene().roots().size(), 2u);
  const NodeId made = driver.scene().roots().back();
  EXPECT_EQ(driver.scene().at(made).name, "two");
  EXPECT_EQ(driver.session().selected(), made);
  ASSERT_NE(driver.session().results.solid(made), nullptr);
  EXPECT_EQ(driver.session().results.solid(made)->volume(), 4.25);
  EXPECT_NE(driver.app().last_message().find("two was repaired: 6 faces divided"),
            std::string::npos)
      << driver.app().last_message();
  driver.key('Z', true);
  EXPECT_EQ(driver.scene(), before);
  driver.key('Y', true);
  EXPECT_EQ(driver.scene().roots().size(), 2u);
}

TEST_F(Repairing, TheCameraGoesToTheLineThatIsClicked) {
  AppDriver driver(1280, 800);
  driver.drop(file("two.obj", crossing_cubes()));
  const Camera all = driver.app().camera();
  driver.press("repair.defect.0");
  const MeshDefect& defect = defects_of(driver).list.front();
  EXPECT_EQ(driver.session().results.repair.lit, 0);
  EXPECT_LT(glm::distance(driver.app().camera().target, *defect.place), 1e-9);
  EXPECT_LT(driver.app().camera().distance, all.distance);
  const Picture picture = PictureMaker().make(driver.session());
  const auto plate = std::find_if(picture.labels.begin(), picture.labels.end(),
                                  [](const Label& label) { return label.plate; });
  ASSERT_NE(plate, picture.labels.end());
  EXPECT_EQ(plate->text, "1: " + defect.text);
  EXPECT_EQ(picture.labels.size(), defects_of(driver).list.size());
}

TEST_F(Repairing, HolesAreClosedOnlyIfThatIsWanted) {
  AppDriver driver(1280, 800);
  driver.drop(file("box.obj", without_top(cube({0, 0, 0}, 3))));
  ASSERT_TRUE(driver.app().has_widget("panel.repair"));
  const MeshDefects& defects = defects_of(driver);
  ASSERT_EQ(defects.list.size(), 1u);
  EXPECT_EQ(defects.list[0].text, "Hole of 4 edges, 12 long");
  EXPECT_EQ(defects.list[0].edges.size(), 8u);
  EXPECT_TRUE(driver.session().results.repair.choice().close_holes);
  driver.press("repair.close_holes");
  ASSERT_TRUE(driver.session().results.repair.preview());
  EXPECT_NE(driver.session().results.repair.preview()->refusal.find("1 hole"), std::string::npos);
  EXPECT_FALSE(driver.app().widgets().find("repair.accept")->enabled);
  driver.press("repair.close_holes");
  driver.press("repair.accept");
  ASSERT_EQ(driver.scene().roots().size(), 1u);
  EXPECT_EQ(driver.session().results.solid(driver.scene().roots()[0])->volume(), 27);
}

TEST_F(Repairing, CrossingsBesideAHoleAreListedToo) {
  AppDriver driver(1280, 800);
  driver.drop(file("three.obj", both(crossing_cubes(), without_top(cube({4, 0, 0}, 1)))));
  ASSERT_EQ(defects_of(driver).list.size(), 2u);
  EXPECT_EQ(defects_of(driver).list[0].text, "6 faces are crossed or met by others, the first");
  EXPECT_EQ(defects_of(driver).list[1].text, "Hole of 4 edges, 4 long");
}

TEST_F(Repairing, BordersAreStitchedByATypedDistance) {
  PolygonMesh split = cube({0, 0, 0}, 2);
  // The top has corners of its own, a little above.
  for (std::size_t i = 4; i < 8; ++i) {
    Vec3 p = split.positions[split.indices[i]];
    p.z += 1e-3;
    split.positions.push_back(p);
    split.indices[i] = static_cast<std::uint32_t>(split.positions.size() - 1);
  }
  AppDriver driver(1280, 800);
  driver.drop(file("lid.obj", split));
  EXPECT_EQ(count(defects_of(driver), MeshDefect::Kind::hole), 2u);
  driver.press("repair.close_holes");
  driver.enter("repair.stitch", "0.01");
  EXPECT_EQ(driver.session().results.repair.choice().stitch, 0.01);
  const RepairPreview* preview = driver.session().results.repair.preview();
  ASSERT_TRUE(preview);
  EXPECT_EQ(preview->refusal, "");
  EXPECT_NEAR(preview->volume, 8, 0.01);
  driver.press("repair.accept");
  EXPECT_EQ(driver.scene().roots().size(), 1u);
}

TEST_F(Repairing, WhatIsInsideOutOrTurnedIsSaidInWords) {
  PolygonMesh inside_out = cube({0, 0, 0}, 2);
  for (std::size_t f = 0; f < 6; ++f)
    std::reverse(inside_out.indices.begin() + 4 * f, inside_out.indices.begin() + 4 * f + 4);
  PolygonMesh turned = cube({0, 0, 0}, 2);
  std::reverse(turned.indices.begin() + 4, turned.indices.begin() + 8);
  AppDriver driver(1280, 800);
  driver.drop(file("inside.obj", inside_out));
  ASSERT_EQ(defects_of(driver).list.size(), 1u);
  EXPECT_EQ(defects_of(driver).list[0].text, "1 part is inside out");
  driver.press("repair.accept");
  EXPECT_EQ(driver.session().results.solid(driver.scene().roots()[0])->volume(), 8);
  driver.drop(file("turned.obj", turned));
  ASSERT_EQ(defects_of(driver).list.size(), 1u);
  EXPECT_EQ(defects_of(driver).list[0].text, "1 face is turned the wrong way round");
  EXPECT_EQ(defects_of(driver).list[0].edges.size(), 8u) << "the four edges around it are lit";
  driver.press("repair.accept");
  EXPECT_EQ(driver.session().results.solid(driver.scene().roots()[1])->volume(), 8);
}

TEST_F(Repairing, TheRuleSaysWhatIsMaterial) {
  AppDriver driver(1280, 800);
  driver.drop(file("two.obj", crossing_cubes()));
  driver.press("repair.rule.odd");
  ASSERT_TRUE(driver.session().results.repair.preview());
  EXPECT_EQ(driver.session().results.repair.preview()->volume, 4.125)
      << "what both cover is a hollow";
}

TEST_F(Repairing, CancelAndEscapeLeaveSceneAndCameraAsTheyWere) {
  AppDriver driver(1280, 800);
  driver.add("block");
  driver.key(Key::escape);
  const Scene before = driver.scene();
  const Camera camera = driver.app().camera();
  const fs::path bad = file("two.obj", crossing_cubes());
  for (const bool by_key : {false, true}) {
    driver.drop(bad);
    ASSERT_TRUE(driver.app().has_widget("panel.repair"));
    EXPECT_NE(driver.app().camera(), camera);
    if (by_key)
      driver.key(Key::escape);
    else
      driver.press("repair.cancel");
    EXPECT_FALSE(driver.app().has_widget("panel.repair"));
    EXPECT_EQ(driver.scene(), before);
    EXPECT_EQ(driver.app().camera(), camera);
  }
  EXPECT_EQ(driver.session().document.undo_name(), "Add block");
}

TEST_F(Repairing, ARepairedSolidStandsWhereItsFileWasNamed) {
  AppDriver driver;
  driver.drop(file("first.obj", cube({0, 0, 0}, 1)));
  driver.drop(file("second.obj", without_top(cube({2, 0, 0}, 1))));
  driver.drop(file("third.obj", without_top(cube({4, 0, 0}, 1))));
  driver.drop(file("fourth.obj", cube({6, 0, 0}, 1)));
  for (int i = 0; i < 2; ++i) {
    ASSERT_TRUE(driver.session().results.repair.is_open());
    driver.settle(4);
    driver.press("repair.accept");
  }
  std::string order;
  for (const NodeId id : driver.scene().roots()) order += driver.scene().at(id).name + " ";
  EXPECT_EQ(order, "first second third fourth ");
}

TEST_F(Repairing, SeveralFilesAreAskedAboutOneAfterAnother) {
  AppDriver driver(1280, 800);
  // As from the command line.
  driver.app().open(file("first.obj", crossing_cubes()));
  driver.app().open(file("good.obj", cube({0, 0, 0}, 1)));
  driver.app().open(file("second.obj", without_top(cube({0, 0, 0}, 1))));
  driver.settle();
  ASSERT_EQ(driver.scene().roots().size(), 1u) << "what is good does not wait";
  EXPECT_EQ(driver.session().results.repair.subject().part.name, "first");
  EXPECT_EQ(driver.session().results.repair.waiting(), 1u);
  driver.press("repair.accept");
  EXPECT_EQ(driver.session().results.repair.subject().part.name, "second");
  driver.press("repair.accept");
  EXPECT_FALSE(driver.session().results.repair.is_open());
  EXPECT_EQ(driver.scene().roots().size(), 3u);
}

TEST_F(Repairing, ABadFileOfTheDialogOpensThePanelToo) {
  AppDriver driver(1280, 800);
  const fs::path bad = file("two.stl", [] {
    PolygonMesh mesh = Solid::from_mesh(cube({0, 0, 0}, 1)).to_mesh();
    return both(mesh, Solid::from_mesh(cube({0.5, 0.5, 0.5}, 1.5)).to_mesh());
  }());
  driver.key('I', true);
  driver.accept_file(bad);
  EXPECT_TRUE(driver.app().has_widget("panel.repair"));
}

TEST_F(Repairing, TheSceneIsNotChangedBehindThePanel) {
  AppDriver driver(1280, 800);
  driver.add("block");
  const Scene before = driver.scene();
  driver.drop(file("two.obj", crossing_cubes()));
  for (const char letter : {'D', 'U', 'G', 'X', 'A'}) driver.key(letter);
  driver.key(Key::del);
  driver.key('Z', true);
  driver.key('D', true);
  const glm::dvec2 middle = driver.middle("picture");
  driver.click(middle);
  driver.drag(middle, middle + glm::dvec2(50, 20));
  EXPECT_EQ(driver.scene(), before);
  EXPECT_FALSE(driver.app().widgets().find("edit.undo")->enabled);
  const Camera camera = driver.app().camera();
  driver.key('7');
  EXPECT_NE(driver.app().camera(), camera) << "looking is not changing";
}

TEST_F(Repairing, ThePanelFitsIntoEveryWindow) {
  struct Size {
    int width, height;
    float scale;
  };
  const fs::path bad = file("two.obj", both(crossing_cubes(), without_top(cube({4, 0, 0}, 1))));
  for (const Size& size : {Size{1024, 700, 1}, {1280, 800, 1}, {1920, 1080, 1}, {1920, 1080, 2}}) {
    AppDriver driver(size.width, size.height, size.scale);
    driver.drop(bad);
    ASSERT_TRUE(driver.app().has_widget("repair.accept")) << size.width;
    EXPECT_EQ(driver.faults(), "") << size.width << " at " << size.scale;
    for (const char* name : {"repair.accept", "repair.cancel", "repair.stitch", "repair.after"})
      EXPECT_FALSE(driver.app().widgets().find(name)->clipped) << name << ' ' << size.width;
  }
}

TEST(OddEdges, AreBordersAndContradictions) {
  EXPECT_TRUE(odd_edges(cube({0, 0, 0}, 1)).borders.empty());
  const OddEdges open = odd_edges(without_top(cube({0, 0, 0}, 1)));
  EXPECT_EQ(open.borders.size(), 4u);
  EXPECT_TRUE(open.contradictions.empty());
  // Two holes are two pieces.
  const OddEdges two =
      odd_edges(both(without_top(cube({0, 0, 0}, 1)), without_top(cube({5, 0, 0}, 1))));
  EXPECT_EQ(two.borders.size(), 8u);
  EXPECT_NE(two.borders.front().piece, two.borders.back().piece);
}

}  // namespace
}  // namespace sectile::viewer
