// Drags of handles in the modeller: taking back, local axes, contacts.
#include <gtest/gtest.h>

#include <cmath>

#include "app/handle_pull.h"
#include "viewer/app_driver.h"

namespace sectile::viewer {
namespace {

const Placement& placement(const AppDriver& driver, std::size_t root) {
  return driver.scene().at(driver.scene().roots().at(root)).placement;
}

/// Where the pointer must go so that the x handle, which points along `axis`, moves its solid by
/// this much.
glm::dvec2 target(AppDriver& driver, const glm::dvec3& origin, const glm::dvec3& axis, double by) {
  const Session& session = driver.session();
  const Handles handles = *handles_of(session);
  EXPECT_LT(glm::distance(handles.origin, origin), 1e-9);
  const glm::dvec3 grip = handles.grip(HandlePart::axis_x, session.view.camera);
  EXPECT_LT(glm::distance(handles.axes[0], axis), 1e-9);
  return driver.middle("handle.x") + driver.app().on_screen(grip + by * axis) -
         driver.app().on_screen(grip);
}

/// A quarter turn around the middle of the handles, on the screen.
glm::dvec2 quarter_turn(AppDriver& driver, const glm::dvec2& from) {
  const glm::dvec2 centre = driver.middle("handle.centre"), away = from - centre;
  return centre + glm::dvec2(-away.y, away.x);
}

/// Two blocks of edge 2; the second, at x = 3, is selected.
void add_two_blocks(AppDriver& driver) {
  driver.add("block");
  driver.add("block");
  ASSERT_EQ(placement(driver, 1).position, (Vec3{3, 0, 0}));
}

/// A new block, and a drag of one of its widgets that has not ended.
struct HeldBlock {
  HeldBlock(const std::string& widget, const glm::dvec2& by) {
    driver.add("block");
    before = driver.scene();
    from = driver.middle(widget);
    driver.hold(from, from + by);
    EXPECT_NE(driver.scene(), before) << "the drag shows";
  }

  AppDriver driver;
  Scene before;
  glm::dvec2 from{0};
};

TEST(AppDrag, EscapeTakesADragBack) {
  HeldBlock block("handle.x", {60, 20});
  auto& [driver, before, from] = block;
  EXPECT_NE(driver.session().interface.dragging, "");
  driver.key(Key::escape);
  EXPECT_EQ(driver.scene(), before);
  EXPECT_EQ(driver.session().interface.dragging, "");
  EXPECT_EQ(driver.session().selection().size(), 1u) << "it stays selected";
  driver.move(from + glm::dvec2(90, 30));
  driver.let_go(from + glm::dvec2(90, 30));
  EXPECT_EQ(driver.scene(), before) << "the button is still down, but nothing is dragged";
  EXPECT_EQ(driver.session().document.undo_name(), "Add block");
  EXPECT_FALSE(driver.session().document.can_redo());
}

TEST(AppDrag, EscapeTakesADragOfAFieldBack) {
  HeldBlock block("properties.position.x", {50, 0});
  auto& [driver, before, field] = block;
  driver.key(Key::escape);
  EXPECT_EQ(driver.scene(), before);
  driver.move(field + glm::dvec2(70, 0));
  driver.let_go(field + glm::dvec2(70, 0));
  EXPECT_EQ(driver.scene(), before);
  EXPECT_EQ(driver.session().document.undo_name(), "Add block");
}

TEST(AppDrag, EachDragIsOneStepOfUndo) {
  AppDriver driver;
  driver.add("block");
  const std::vector<std::pair<std::string, std::string>> modes{
      {"handle.move", "Move"}, {"handle.rotate", "Rotate"}, {"handle.scale", "Scale"}};
  std::vector<Scene> scenes{driver.scene()};
  for (const auto& [button, name] : modes) {
    driver.press(button);
    const glm::dvec2 from = driver.middle("handle.y");
    driver.drag(from, name == "Rotate" ? quarter_turn(driver, from) : from + glm::dvec2(70, -50));
    EXPECT_EQ(driver.session().document.undo_name(), name);
    EXPECT_NE(driver.scene(), scenes.back()) << name;
    scenes.push_back(driver.scene());
  }
  for (std::size_t i = modes.size(); i-- > 0;) {
    driver.key('Z', true);
    EXPECT_EQ(driver.scene(), scenes[i]);
  }
}

TEST(AppDrag, KeysAfterAFastDragComeAfterIt) {
  AppDriver driver;
  driver.add("block");
  const glm::dvec2 from = driver.middle("handle.x");
  driver.drag_and_key(from, from + glm::dvec2(70, 20), 'D', true);
  ASSERT_EQ(driver.scene().roots().size(), 2u) << "Ctrl+D duplicates";
  const double x = placement(driver, 0).position.x;
  EXPECT_GT(x, 0.2);
  EXPECT_EQ(x * 20, std::round(x * 20)) << "Ctrl belongs to the key: the drag snaps";
  EXPECT_EQ(placement(driver, 1).position.x, x);
}

TEST(AppDrag, LocalAxesFollowTheSolid) {
  AppDriver driver;
  driver.add("block");
  driver.enter("properties.rotation.z", "30");
  ASSERT_EQ(placement(driver, 0).rotation.z, 30);
  const auto drag_x = [&] {
    const glm::dvec2 from = driver.middle("handle.x");
    driver.drag(from, from + (from - driver.middle("handle.centre")));
    const Vec3 moved = placement(driver, 0).position;
    driver.key('Z', true);
    return moved;
  };
  const Vec3 world = drag_x();
  EXPECT_GT(world.x, 0.2);
  EXPECT_EQ(world.y, 0);
  driver.key('L');
  const Vec3 own = drag_x();
  EXPECT_GT(own.x, 0.2);
  EXPECT_NEAR(std::atan2(own.y, own.x), std::atan2(1, std::sqrt(3)), 1e-9);
  const double length = std::hypot(own.x, own.y);
  EXPECT_NEAR(length * 20, std::round(length * 20), 1e-9) << "the distance is round";
  // Turning about the own x axis changes the first angle only.
  driver.press("handle.rotate");
  const glm::dvec2 from = driver.middle("handle.x");
  driver.drag(from, quarter_turn(driver, from));
  EXPECT_NE(placement(driver, 0).rotation.x, 0);
  EXPECT_NEAR(placement(driver, 0).rotation.z, 30, 1e-9);
}

TEST(AppDrag, RotationSnapsToRoundAngles) {
  AppDriver driver;
  driver.add("block");
  driver.press("handle.rotate");
  const glm::dvec2 from = driver.middle("handle.z");
  driver.drag(from, from + glm::dvec2(-60, -10));
  const double degrees = placement(driver, 0).rotation.z;
  EXPECT_NE(degrees, 0);
  EXPECT_EQ(degrees, 15 * std::round(degrees / 15));
  driver.drag(from, from + glm::dvec2(-53, -10), MouseButton::left, true);
  const double free = placement(driver, 0).rotation.z;
  EXPECT_NE(free, 15 * std::round(free / 15)) << "Ctrl: without snapping";
}

TEST(AppDrag, FacesBecomeFlush) {
  AppDriver driver;
  add_two_blocks(driver);
  // Smaller, so that only faces can meet.
  driver.enter("properties.scale.y", "0.7");
  driver.enter("properties.scale.z", "0.7");
  driver.enter("properties.position.x", "3.141");
  const glm::dvec2 to = target(driver, {3.141, 0, 0}, {1, 0, 0}, -1.12);
  driver.hold(driver.middle("handle.x"), to);
  EXPECT_NE(driver.session().interface.dragging.find("face on face: exact"), std::string::npos)
      << driver.session().interface.dragging;
  driver.let_go(to);
  EXPECT_EQ(placement(driver, 1).position, (Vec3{2, 0, 0}));
  driver.key('A', true);
  driver.key('U');
  const Solid* both = driver.session().results.solid(driver.scene().roots().front());
  ASSERT_NE(both, nullptr);
  EXPECT_EQ(both->counts().shells, 1u);
  EXPECT_NEAR(both->volume(), 8 + 8 * 0.49, 1e-12);
}

// The wall stands at 0.1 + 1, which is no double: the position that touches it has a remainder,
// until another one is typed.
TEST(AppDrag, ContactsBetweenDoublesAreExact) {
  AppDriver driver;
  add_two_blocks(driver);
  driver.enter("properties.scale.y", "0.75");
  driver.enter("properties.scale.z", "0.75");
  const NodeId first = driver.scene().roots()[0], second = driver.scene().roots()[1];
  driver.press("tree:" + std::to_string(first));
  driver.enter("properties.position.x", "0.1");
  driver.press("tree:" + std::to_string(second));
  const glm::dvec2 to = target(driver, {3, 0, 0}, {1, 0, 0}, -0.88);
  driver.hold(driver.middle("handle.x"), to);
  EXPECT_NE(driver.session().interface.dragging.find("face on face: exact"), std::string::npos)
      << driver.session().interface.dragging;
  driver.let_go(to);
  EXPECT_EQ(placement(driver, 1).position, (Vec3{2.1, 0, 0}));
  EXPECT_NE(placement(driver, 1).remainder.x, 0);
  driver.key('A', true);
  driver.key('U');
  const NodeId both = driver.scene().roots().front();
  ASSERT_NE(driver.session().results.solid(both), nullptr);
  EXPECT_EQ(driver.session().results.solid(both)->counts().faces, 11u);
  EXPECT_EQ(driver.session().results.solid(both)->counts().shells, 1u);
  driver.key('Z', true);
  driver.press("tree:" + std::to_string(second));
  driver.enter("properties.position.x", "2.1");
  EXPECT_EQ(placement(driver, 1).remainder, (Vec3{0, 0, 0}));
  driver.key('Z', true);
  EXPECT_NE(placement(driver, 1).remainder.x, 0) << "undo gives it back";
}

TEST(AppDrag, AnAxisHandleMovesAlongItsAxisOnly) {
  AppDriver driver;
  add_two_blocks(driver);
  // Corners of the first one are at y = 0.7 + 0.1, one bit below those of the second at y = 0.8: a
  // contact of corners needs more than the x axis.
  const NodeId first = driver.scene().roots()[0], second = driver.scene().roots()[1];
  driver.enter("properties.scale.y", "0.8");
  driver.press("tree:" + std::to_string(first));
  driver.enter("properties.scale.y", "0.7");
  driver.enter("properties.position.y", "0.1");
  driver.press("tree:" + std::to_string(second));
  const glm::dvec2 to = target(driver, {3, 0, 0}, {1, 0, 0}, -1.02);
  driver.hold(driver.middle("handle.x"), to);
  const std::string told = driver.session().interface.dragging;
  EXPECT_NE(told.find("vertex on vertex"), std::string::npos) << told;
  EXPECT_NE(told.find("beside the way of this handle"), std::string::npos) << told;
  driver.let_go(to);
  EXPECT_EQ(placement(driver, 1).position, (Vec3{2, 0, 0}));
}

TEST(AppDrag, OperandsOfAMovedOperationBecomeFlush) {
  AppDriver driver;
  add_two_blocks(driver);
  driver.enter("properties.scale.y", "0.7");
  driver.enter("properties.scale.z", "0.7");
  driver.key('A', true);
  driver.key('U');
  // Sums with these are rounded.
  driver.enter("properties.position.x", "0.1");
  driver.enter("properties.position.y", "-0.3");
  const NodeId made = driver.scene().roots().front(), b = driver.scene().at(made).children[1];
  driver.press("tree:" + std::to_string(b));
  const glm::dvec2 to = target(driver, {3.1, -0.3, 0}, {1, 0, 0}, -1.02);
  driver.hold(driver.middle("handle.x"), to);
  EXPECT_NE(driver.session().interface.dragging.find("face on face: exact"), std::string::npos)
      << driver.session().interface.dragging;
  driver.let_go(to);
  EXPECT_EQ(driver.scene().at(b).placement.position, (Vec3{2, 0, 0}));
  EXPECT_EQ(driver.session().results.solid(made)->counts().shells, 1u);
}

TEST(AppDrag, SlantedFacesAreSaidNotToBeExact) {
  AppDriver driver;
  driver.add("block");
  driver.enter("properties.rotation.z", "30");
  driver.key('D', true);
  driver.enter("properties.position.x", "1");
  ASSERT_EQ(placement(driver, 1).position, (Vec3{1, 0, 0}));
  driver.enter("properties.scale.y", "0.7");
  driver.enter("properties.scale.z", "0.7");
  driver.key('L');
  const double by = 2.01 - std::sqrt(0.75);
  const glm::dvec2 to = target(driver, {1, 0, 0}, {std::sqrt(0.75), 0.5, 0}, by);
  driver.hold(driver.middle("handle.x"), to);
  EXPECT_NE(driver.session().interface.dragging.find("face on face: near, not exact"),
            std::string::npos)
      << driver.session().interface.dragging;
  driver.let_go(to);
  EXPECT_NEAR(placement(driver, 1).position.x, 1 + (by - 0.01) * std::sqrt(0.75), 1e-9);
}

}  // namespace
}  // namespace sectile::viewer
