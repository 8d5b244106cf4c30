// Selecting, looking, copying: what the mouse and the menus of the picture do.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "app/picture_maker.h"
#include "viewer/app_driver.h"

namespace sectile::viewer {
namespace {

/// Two blocks side by side, seen from the front, nothing selected.
struct TwoBlocks {
  TwoBlocks() : driver(1100, 700) {
    driver.add("block");
    driver.add("block");
    driver.enter("properties.position.x", "5");
    driver.key(Key::escape);
    driver.key('1');
    driver.key(Key::home);
  }
  NodeId root(std::size_t i) { return driver.scene().roots().at(i); }
  glm::dvec2 seen(const glm::dvec3& p) { return driver.app().on_screen(p); }
  AppDriver driver;
};

TEST(AppSelect, ABoxSelectsWhatItMeets) {
  TwoBlocks two;
  AppDriver& driver = two.driver;
  driver.key('B');
  driver.drag(two.seen({3, 0, 2}), two.seen({4.5, 0, 0.5}));
  EXPECT_EQ(driver.session().selection(), Selection{two.root(1)});
  EXPECT_EQ(driver.session().interface.tool, nullptr);
  // Shift and a drag, without the key, adds.
  driver.drag(two.seen({2, 0, 2}), two.seen({0.5, 0, 0.5}), MouseButton::left, false, true);
  EXPECT_EQ(driver.session().selection(), (Selection{two.root(1), two.root(0)}));
  // A box within a face meets it too; one beside all selects nothing.
  driver.key('B');
  driver.drag(two.seen({-0.2, 0, 0.2}), two.seen({0.2, 0, -0.2}));
  EXPECT_EQ(driver.session().selection(), Selection{two.root(0)});
  driver.key('B');
  driver.drag(two.seen({2.2, 0, 0.5}), two.seen({2.8, 0, -0.5}));
  EXPECT_TRUE(driver.session().selection().empty());
}

TEST(AppSelect, ABoxFromRightToLeftAndUpIsTheSame) {
  TwoBlocks two;
  two.driver.key('B');
  two.driver.drag(two.seen({6.5, 0, -1.5}), two.seen({-1.5, 0, 1.5}));
  EXPECT_EQ(two.driver.session().selection().size(), 2u);
}

TEST(AppSelect, RightDragMovesTheView) {
  TwoBlocks two;
  AppDriver& driver = two.driver;
  const Camera before = driver.app().camera();
  const glm::dvec2 from = two.seen({2.5, 0, 2});
  driver.drag(from, from + glm::dvec2(60, 10), MouseButton::right);
  EXPECT_NE(driver.app().camera().target, before.target);
  EXPECT_EQ(driver.app().camera().azimuth, before.azimuth);
  EXPECT_FALSE(driver.app().has_widget("panel.context_menu")) << "that is for clicks";
}

TEST(AppSelect, RightClickSelectsAndOpensAMenu) {
  TwoBlocks two;
  AppDriver& driver = two.driver;
  const glm::dvec2 at = two.seen({5, -1, 0});
  driver.drag(at, at, MouseButton::right);
  EXPECT_EQ(driver.session().selection(), Selection{two.root(1)});
  ASSERT_TRUE(driver.app().has_widget("panel.context_menu"));
  EXPECT_TRUE(driver.app().has_widget("menu:transform.move"));
  EXPECT_FALSE(driver.app().has_widget("menu:edit.ungroup")) << "it is no group";
  EXPECT_EQ(driver.faults(), "");
  const NodeId gone = two.root(1);
  driver.press("menu:edit.delete");
  EXPECT_EQ(driver.scene().find(gone), nullptr);
  const glm::dvec2 empty = two.seen({2.5, 0, 0});
  driver.drag(empty, empty, MouseButton::right);
  EXPECT_TRUE(driver.app().has_widget("menu:view.all"));
}

TEST(AppSelect, CopyAndPaste) {
  TwoBlocks two;
  AppDriver& driver = two.driver;
  driver.key('V', true);
  EXPECT_NE(driver.app().last_message().find("Copy some first"), std::string::npos);
  driver.key('A', true);
  driver.key('U');
  driver.key('C', true);
  driver.key('V', true);
  ASSERT_EQ(driver.scene().size(), 6u);
  EXPECT_EQ(driver.session().selection(), Selection{two.root(1)});
  EXPECT_EQ(driver.session().document.undo_name(), "Paste");
  driver.key('X', true);
  EXPECT_EQ(driver.scene().size(), 3u);
  // A new scene knows the clipboard still.
  driver.key('S', true);
  driver.key(Key::escape);
  driver.key('Z', true);
  driver.key('V', true);
  EXPECT_EQ(driver.scene().size(), 9u);
}

TEST(AppSelect, DuplicatesFollowTheMouse) {
  TwoBlocks two;
  AppDriver& driver = two.driver;
  driver.click(two.seen({0, -1, 0}));
  driver.key('D', false, true);
  ASSERT_EQ(driver.scene().size(), 3u);
  driver.key('Z');
  driver.type("4");
  driver.key(Key::enter);
  const NodeId copy = driver.session().selected();
  EXPECT_NE(copy, two.root(0));
  EXPECT_EQ(driver.scene().at(copy).placement.position, (Vec3{0, 0, 4}));
  EXPECT_EQ(driver.scene().at(two.root(0)).placement.position, Vec3());
}

TEST(AppSelect, IsolatedSolidsAreSeenAlone) {
  TwoBlocks two;
  AppDriver& driver = two.driver;
  driver.click(two.seen({0, -1, 0}));
  driver.key('/');
  driver.settle();
  ASSERT_EQ(visible_shapes(driver.session()).size(), 1u);
  EXPECT_EQ(visible_shapes(driver.session()).front().node, two.root(0));
  const Scene before = driver.scene();
  driver.click(two.seen({5, -1, 0}));
  EXPECT_TRUE(driver.session().selection().empty()) << "what is not seen is not clicked";
  driver.key('/');
  EXPECT_EQ(visible_shapes(driver.session()).size(), 2u);
  EXPECT_EQ(driver.scene(), before) << "nothing of it is in the scene";
}

TEST(AppSelect, SixSidesByKeysAndByTheCube) {
  TwoBlocks two;
  AppDriver& driver = two.driver;
  const auto forward = [&] { return driver.app().camera().forward(); };
  const auto expect = [&](const glm::dvec3& wanted) {
    EXPECT_LT(glm::distance(forward(), wanted), 1e-9)
        << forward().x << " " << forward().y << " " << forward().z;
  };
  driver.key('1');
  expect({0, 1, 0});
  driver.key('1', true);
  expect({0, -1, 0});
  driver.key('3');
  expect({-1, 0, 0});
  driver.key('3', true);
  expect({1, 0, 0});
  driver.key('7', true);
  expect({0, 0, 1});
  driver.key('7');
  expect({0, 0, -1});
  driver.drag(two.seen({2.5, 0, 3}), two.seen({2.5, 0, 3}) + glm::dvec2(60, -60));
  driver.press("view_cube.front");
  expect({0, 1, 0});
  const double azimuth = driver.app().camera().azimuth;
  const glm::dvec2 cube = driver.middle("view_cube.front");
  driver.drag(cube, cube + glm::dvec2(20, 0));
  EXPECT_NE(driver.app().camera().azimuth, azimuth) << "a drag turns";
}

}  // namespace
}  // namespace sectile::viewer
