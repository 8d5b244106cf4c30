// Files, crashes, long computations, typed values, break points.
#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <thread>

#include "viewer/app_driver.h"

namespace sectile::viewer {
namespace {

namespace fs = std::filesystem;

fs::path folder() {
  const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
  return fs::path(::testing::TempDir()) / ("sectile_" + std::string(test->name()));
}

fs::path empty_folder() {
  fs::remove_all(folder());
  fs::create_directories(folder());
  return folder();
}

TEST(AppWork, StopsWhereAVertexTakesPart) {
  AppDriver driver;
  const Story& story = driver.open_steps("fig01");
  // A vertex that the first steps do not concern.
  std::string vertex;
  std::size_t wanted = 0;
  for (int i = 0; i < 100 && wanted < 4; ++i) {
    vertex = "v" + std::to_string(i);
    const std::size_t found = story.next_of_kind(0, vertex);
    wanted = found < story.steps().size() ? found : 0;
  }
  ASSERT_GE(wanted, 4u);
  driver.press("steps.stops");
  driver.press("stop.entity");
  driver.type(vertex);
  driver.key(Key::enter);
  EXPECT_EQ(driver.session().results.player.stops, std::vector<std::string>{vertex});
  EXPECT_TRUE(driver.app().has_widget("stop.remove." + vertex));
  driver.press("stop.entity");
  driver.type("corner");
  driver.press("stop.add");
  EXPECT_EQ(driver.session().results.player.stops.size(), 1u) << "that names nothing";
  EXPECT_NE(driver.app().last_message().find("corner"), std::string::npos);
  driver.press("stop.remove." + vertex);
  EXPECT_TRUE(driver.session().results.player.stops.empty());
  driver.press("stop.entity");
  driver.key('A', true);
  driver.type(vertex);
  driver.press("stop.add");
  driver.key(Key::escape);
  driver.click(driver.middle("status.text"));
  driver.key('B');
  EXPECT_EQ(driver.session().results.player.step(), wanted);
}

TEST(AppWork, CancelsALongComputation) {
  AppOptions impatient;
  impatient.fast_pictures = true;
  AppDriver driver(impatient, 1024, 700);
  const auto frames_until = [&](const auto& done) {
    const auto start = std::chrono::steady_clock::now();
    while (!done() && std::chrono::steady_clock::now() - start < std::chrono::seconds(60))
      driver.settle(1);
    return done();
  };
  const auto is_idle = [&] { return !driver.session().is_busy(); };
  for (int i = 0; i < 2; ++i) {
    driver.add("sphere");
    driver.key('H');  // drawing them takes longer than anything else
    driver.enter("properties.segments", "400");
    driver.enter("properties.rings", "200");
  }
  driver.enter("properties.position.x", "0.5");
  driver.key('A', true);
  driver.key('U');
  const NodeId result = driver.scene().roots().front();
  ASSERT_TRUE(frames_until([&] { return driver.app().has_widget("status.cancel"); }));
  EXPECT_EQ(driver.faults(), "");
  driver.press("status.cancel");
  ASSERT_TRUE(frames_until(is_idle));
  EXPECT_NE(driver.app().last_message().find("Cancelled"), std::string::npos);
  EXPECT_EQ(driver.session().results.solid(result), nullptr);
  EXPECT_EQ(driver.scene().roots().size(), 1u) << "the scene stays as it is";
  // Undone, there is little to compute.
  driver.key('Z', true);
  ASSERT_TRUE(frames_until(is_idle));
  EXPECT_NE(driver.session().results.solid(driver.scene().roots().front()), nullptr);
}

/// A session that keeps a copy of a block and ends without any goodbye.
[[noreturn]] void crash(const fs::path& data) {
  AppOptions options = AppDriver::waiting();
  options.data_folder = data;
  AppDriver driver(options);
  driver.add("block");
  driver.enter("properties.position.x", "0.3");
  // The copy is written by a thread.
  for (int i = 0; i < 600; ++i) {
    for (const auto& entry : fs::recursive_directory_iterator(data)) {
      if (!entry.is_regular_file()) continue;
      std::ifstream file(entry.path());
      const std::string text{std::istreambuf_iterator<char>(file), {}};
      if (text.find("0.3") != std::string::npos) std::_Exit(3);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  std::_Exit(4);
}

TEST(AppWorkDeathTest, RecoveryIsOfferedAfterACrash) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const fs::path data = folder();
  if (!::testing::internal::InDeathTestChild()) fs::remove_all(data);
  EXPECT_EXIT(crash(data), ::testing::ExitedWithCode(3), "");
  AppOptions options = AppDriver::waiting();
  options.data_folder = data;
  {
    AppDriver later(options);
    ASSERT_TRUE(later.app().has_widget("question.recover"));
    EXPECT_EQ(later.faults(), "");
    later.press("question.later");
    EXPECT_EQ(later.scene().size(), 0u);
  }
  {
    AppDriver driver(options);
    driver.press("question.recover");
    ASSERT_EQ(driver.scene().size(), 1u) << driver.app().last_message();
    EXPECT_EQ(driver.scene().at(driver.scene().roots().front()).placement.position.x, 0.3);
    EXPECT_TRUE(driver.session().document.is_changed()) << "it is not saved yet";
    EXPECT_FALSE(driver.app().has_widget("question.recover"));
  }
  AppDriver last(options);
  EXPECT_FALSE(last.app().has_widget("question.recover")) << "offered once";
}

TEST(AppWork, DroppedFilesBecomeSolids) {
  const fs::path path = empty_folder() / "bracket.obj";
  write_mesh(path,
             transformed(block({0, 0, 0}, {1, 2, 3}), Transform::translation({7, 0, 0})).to_mesh());
  AppDriver driver;
  driver.add("block");
  driver.drop(path);
  ASSERT_EQ(driver.scene().roots().size(), 2u) << driver.app().last_message();
  const Node& node = driver.scene().at(driver.scene().roots().back());
  EXPECT_EQ(node.name, "bracket");
  EXPECT_EQ(driver.session().selected(), node.id);
  EXPECT_EQ(driver.session().results.solid(node.id)->volume(), 6);
  // Its handles stand where it is, not at its distant origin.
  const glm::dvec2 centre = driver.middle("handle.centre");
  EXPECT_NEAR(glm::distance(centre, driver.app().on_screen({7.5, 1, 1.5})), 0, 1);
  driver.key('Z', true);
  EXPECT_EQ(driver.scene().roots().size(), 1u);
  driver.drop(folder() / "missing.stl");
  EXPECT_EQ(driver.scene().roots().size(), 1u);
  EXPECT_NE(driver.app().last_message().find("missing.stl"), std::string::npos);
}

TEST(AppWork, ExportsTheSelectedSolid) {
  empty_folder();
  AppDriver driver;
  driver.add("block");
  driver.add("block");
  const auto export_as = [&](const std::string& name) {
    driver.key('E', true);
    driver.accept_file(folder() / name);
  };
  driver.key('A', true);
  export_as("both.obj");
  EXPECT_FALSE(fs::exists(folder() / "both.obj"));
  EXPECT_NE(driver.app().last_message().find("Select the one solid"), std::string::npos);
  driver.key('U');
  const NodeId result = driver.session().selected();
  driver.press("tree:" + std::to_string(driver.scene().at(result).children[1]));
  driver.enter("properties.position.x", "1.5");
  driver.press("tree:" + std::to_string(result));
  for (const char* name : {"result.stl", "result.ply"}) {
    export_as(name);
    ASSERT_TRUE(fs::exists(folder() / name)) << driver.app().last_message();
    EXPECT_EQ(Solid::from_mesh(read_mesh(folder() / name)).volume(), 14) << name;
  }
  export_as("result.doc");
  EXPECT_TRUE(driver.session().interface.dialogs.browsing) << "says what is wrong and stays open";
  EXPECT_NE(driver.session().interface.dialogs.browser.problem, "");
}

TEST(AppWork, ValuesAreTypedAtTwiceTheScale) {
  AppDriver driver(1920, 1200, 2);
  driver.add("block");
  const NodeId id = driver.scene().roots().front();
  const auto at = [&]() -> const Placement& { return driver.scene().at(id).placement; };
  driver.enter("properties.position.x", "0.123456789012");
  driver.enter("properties.rotation.z", "90");
  driver.enter("properties.scale.y", "2");
  EXPECT_EQ(at().position.x, 0.123456789012);
  EXPECT_EQ(at().rotation.z, 90);
  EXPECT_EQ(driver.session().results.solid(id)->volume(), 16);
  driver.enter("properties.size.x", "3");
  EXPECT_EQ(driver.session().results.solid(id)->volume(), 24);
  EXPECT_EQ(driver.faults(), "");
  // Looking into a field is no change, and Esc takes what was typed back to the last digit.
  const std::string last = driver.session().document.undo_name();
  const Scene before = driver.scene();
  driver.enter("properties.position.x", "");
  EXPECT_EQ(at().position.x, 0.123456789012);
  driver.enter("properties.position.x", "7", Key::escape);
  EXPECT_EQ(at().position.x, 0.123456789012);
  driver.enter("properties.position.x", "nonsense");
  EXPECT_EQ(at().position.x, 0.123456789012);
  EXPECT_EQ(driver.scene(), before);
  EXPECT_FALSE(driver.session().document.has_draft());
  // Handles are found where they are drawn.
  const glm::dvec2 from = driver.middle("handle.z");
  driver.drag(from, from + glm::dvec2(0, -40));
  EXPECT_GT(at().position.z, 0.1);
  EXPECT_EQ(driver.session().document.undo_name(), "Move");
  driver.key('Z', true);
  EXPECT_EQ(driver.session().document.undo_name(), last);
}

}  // namespace
}  // namespace sectile::viewer
