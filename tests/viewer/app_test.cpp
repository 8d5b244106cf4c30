// The modeller driven like a person would, without a window.
#include <gtest/gtest.h>

#include <fstream>

#include "scene/primitive_kind.h"
#include "viewer/app_driver.h"

namespace sectile::viewer {
namespace {

std::filesystem::path file(const std::string& name) {
  const auto folder = std::filesystem::temp_directory_path() / "sectile_app_test";
  std::filesystem::create_directories(folder);
  return folder / (std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()) +
                   "_" + name);
}

const Solid& only_solid(const AppDriver& driver) {
  const Solid* solid = driver.session().results.solid(driver.scene().roots().front());
  if (!solid) throw std::runtime_error("The only solid was not computed.");
  return *solid;
}

/// Two blocks of edge 2, the second moved by one along x, by its field.
void add_two_blocks(AppDriver& driver) {
  driver.add("block");
  driver.add("block");
  driver.press("properties.position.x");
  driver.type("1");
  driver.key(Key::enter);
}

void combine_two_blocks(AppDriver& driver, char key) {
  add_two_blocks(driver);
  driver.key('A', true);
  driver.key(key);
}

TEST(App, AddsEveryPrimitive) {
  for (const PrimitiveKind* kind : primitive_kinds()) {
    AppDriver driver(1024, 700);
    driver.add(std::string(kind->name));
    ASSERT_EQ(driver.scene().size(), 1u) << kind->name;
    EXPECT_GT(only_solid(driver).volume(), 0) << kind->name;
    for (const PrimitiveField& field : kind->fields) {
      const std::string name = std::string("properties.") + field.name;
      EXPECT_TRUE(driver.app().has_widget(name) || driver.app().has_widget(name + ".x")) << name;
    }
    EXPECT_EQ(driver.faults(), "") << kind->name;
  }
}

TEST(App, HandleMovesAlongItsAxisAndUndoes) {
  AppDriver driver;
  driver.add("block");
  const NodeId id = driver.scene().roots().front();
  const glm::dvec2 from = driver.middle("handle.x");
  const glm::dvec2 middle = driver.app().on_screen({0, 0, 0});
  driver.drag(from, from + (from - middle));
  const Vec3 moved = driver.scene().at(id).placement.position;
  EXPECT_GT(moved.x, 0.2);
  EXPECT_EQ(moved.x * 4, std::round(moved.x * 4)) << "snapped to the grid";
  EXPECT_EQ(moved.y, 0);
  EXPECT_EQ(moved.z, 0);
  driver.key('Z', true);
  EXPECT_EQ(driver.scene().at(id).placement.position, Vec3());
  driver.key('Z', true, true);
  EXPECT_EQ(driver.scene().at(id).placement.position, moved);
}

TEST(App, HandlesRotateAndScale) {
  AppDriver driver;
  driver.add("block");
  const NodeId id = driver.scene().roots().front();
  driver.press("handle.rotate");
  glm::dvec2 from = driver.middle("handle.z");
  driver.drag(from, from + glm::dvec2(-60, -10));
  EXPECT_NE(driver.scene().at(id).placement.rotation.z, 0);
  EXPECT_NEAR(only_solid(driver).volume(), 8, 1e-9);
  driver.key('Z', true);
  driver.press("handle.scale");
  from = driver.middle("handle.z");
  driver.drag(from, from + glm::dvec2(0, -60));
  EXPECT_GT(driver.scene().at(id).placement.scale.z, 1);
}

TEST(App, EveryBooleanByButtonAndByKey) {
  struct Case {
    const char* button;
    char key;
    double volume;
  };
  for (const Case& wanted : {Case{"operation.unite", 'U', 12}, Case{"operation.intersect", 'I', 4},
                             Case{"operation.subtract", 'D', 4}})
    for (const bool by_key : {false, true}) {
      AppDriver driver;
      add_two_blocks(driver);
      driver.key('A', true);
      if (by_key)
        driver.key(wanted.key);
      else
        driver.press(wanted.button);
      ASSERT_EQ(driver.scene().roots().size(), 1u) << wanted.button;
      EXPECT_EQ(only_solid(driver).volume(), wanted.volume) << wanted.button;
    }
}

TEST(App, SplitsAlongTheSectionPlane) {
  AppDriver driver;
  driver.add("block");
  driver.key('P');  // shows the plane
  driver.key('P');
  ASSERT_EQ(driver.scene().roots().size(), 2u);
  EXPECT_EQ(only_solid(driver).volume(), 4);
}

TEST(App, StepsToTheSpecialCaseNamed) {
  AppDriver driver;
  const Story& story = driver.open_steps("fig01");
  driver.press("steps.next_special");
  ASSERT_NE(driver.session().results.player.current(), nullptr);
  EXPECT_TRUE(driver.session().results.player.current()->special);
  EXPECT_EQ(driver.session().results.player.step(), story.next_special(0, false));
  driver.press("steps.stops");
  driver.press("stop.null edge");
  driver.key(Key::escape);
  driver.click(driver.middle("status.text"));
  driver.key('B');
  EXPECT_EQ(driver.session().results.player.current()->kind, "null edge");
}

TEST(App, UndoesAndRedoesEverything) {
  AppDriver driver;
  combine_two_blocks(driver, 'U');
  driver.key('D', true);
  driver.key('H');
  driver.key(Key::del);
  const Scene end = driver.scene();
  int steps = 0;
  while (driver.session().document.can_undo()) driver.key('Z', true), ++steps;
  EXPECT_GE(steps, 6);
  EXPECT_EQ(driver.scene().size(), 0u);
  for (int i = 0; i < steps; ++i) driver.key('Z', true, true);
  EXPECT_EQ(driver.scene(), end);
}

TEST(App, SavesAndOpensAgain) {
  AppDriver driver;
  combine_two_blocks(driver, 'I');
  const std::filesystem::path path = file("scene.sectile");
  std::filesystem::remove(path);
  driver.key('S', true);
  driver.accept_file(path);
  ASSERT_TRUE(std::filesystem::exists(path)) << driver.app().last_message();
  const Scene saved = driver.scene();
  AppDriver second;
  second.drop(path);
  EXPECT_EQ(second.scene(), saved) << second.app().last_message();
  EXPECT_EQ(only_solid(second).volume(), 4);
}

TEST(App, AnUnreadableFileGivesAMessageAndChangesNothing) {
  const std::filesystem::path path = file("bad.obj");
  std::ofstream(path) << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 7\n";
  AppDriver driver;
  driver.drop(path);
  EXPECT_EQ(driver.scene().size(), 0u);
  EXPECT_NE(driver.app().last_message().find("bad.obj: "), std::string::npos);
  EXPECT_TRUE(driver.app().has_widget("message.0"));
  EXPECT_FALSE(driver.app().has_widget("panel.repair"));
  EXPECT_EQ(driver.faults(), "");
}

TEST(App, ExportsTheResult) {
  const std::filesystem::path path = file("result.obj");
  std::filesystem::remove(path);
  AppDriver driver;
  combine_two_blocks(driver, 'U');
  driver.key('E', true);
  driver.enter_file(path);
  ASSERT_TRUE(std::filesystem::exists(path)) << driver.app().last_message();
  EXPECT_EQ(Solid::from_mesh(read_mesh(path)).volume(), 12);
}

TEST(App, ClosingAsksWhetherToSave) {
  AppDriver driver;
  driver.add("block");
  driver.key('Q', true);
  EXPECT_FALSE(driver.app().wants_to_close());
  driver.press("question.cancel");
  EXPECT_FALSE(driver.app().wants_to_close());
  driver.key('Q', true);
  driver.press("question.discard");
  EXPECT_TRUE(driver.app().wants_to_close());
}

TEST(App, DragTurnsTheViewAndClickSelects) {
  AppDriver driver;
  driver.add("block");
  driver.key(Key::escape);
  EXPECT_TRUE(driver.session().selection().empty());
  driver.click(driver.app().on_screen({0, 0, 0}));
  EXPECT_EQ(driver.session().selection().size(), 1u);
  const double before = driver.app().camera().azimuth;
  const glm::vec4 picture = driver.app().widget("picture");
  const glm::dvec2 corner(picture.x + 20, picture.y + 20);
  driver.drag(corner, corner + glm::dvec2(60, 0));
  EXPECT_NE(driver.app().camera().azimuth, before);
}

TEST(App, NothingOverlapsOrIsCutOff) {
  struct Size {
    int width, height;
    float scale;
  };
  for (const Size& size :
       {Size{1024, 700, 1}, Size{1280, 800, 1}, Size{1920, 1080, 1}, Size{1920, 1080, 2}}) {
    AppDriver driver(size.width, size.height, size.scale);
    const std::string at = std::to_string(size.width) + " at " + std::to_string(size.scale);
    EXPECT_EQ(driver.faults(), "") << at << ", empty";
    driver.press("tool.add");
    EXPECT_EQ(driver.faults(), "") << at << ", adding";
    driver.key(Key::escape);
    driver.app().open_sample("fig01");
    driver.settle();
    EXPECT_EQ(driver.faults(), "") << at << ", model";
    driver.key('V');
    EXPECT_EQ(driver.faults(), "") << at << ", view settings";
    driver.key('V');
    driver.app().show_step(Phase::vertex_vertex, 1);
    driver.settle();
    EXPECT_EQ(driver.faults(), "") << at << ", steps";
    driver.press("steps.stops");
    EXPECT_EQ(driver.faults(), "") << at << ", break points";
  }
}

}  // namespace
}  // namespace sectile::viewer
