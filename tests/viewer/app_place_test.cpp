// The commands that place solids, by menus and clicks.
#include <gtest/gtest.h>

#include "viewer/app_driver.h"

namespace sectile::viewer {
namespace {

const Placement& placement(const AppDriver& driver, std::size_t root) {
  return driver.scene().at(driver.scene().roots().at(root)).placement;
}

void choose(AppDriver& driver, const std::string& menu, const std::string& item) {
  driver.press(menu);
  driver.press("menu:" + item);
}

void choose(AppDriver& driver, const std::string& menu, const std::string& submenu,
            const std::string& item) {
  driver.press(menu);
  driver.press("submenu." + submenu);
  driver.press("menu:" + item);
}

/// A plate of 6 by 4 by 1 and a block of edge 2 above it to the right.
struct PlateAndBlock {
  PlateAndBlock() : driver(1280, 800) {
    driver.add("block");
    driver.enter("properties.size.x", "6");
    driver.enter("properties.size.y", "4");
    driver.enter("properties.size.z", "1");
    driver.add("block");
    driver.enter("properties.position.x", "2.3");
    driver.enter("properties.position.z", "4.7");
    driver.key(Key::escape);
    driver.key(Key::home);
  }
  glm::dvec2 seen(const glm::dvec3& p) { return driver.app().on_screen(p); }
  /// Clicks, for Face on face, the block's front.
  void pick_front() {
    const Bounds block = driver.session().bounds_of(driver.scene().roots()[1]);
    driver.click(seen({block.centre().x, block.low.y, block.centre().z}));
  }
  AppDriver driver;
};

TEST(AppPlace, FaceOnFaceTouches) {
  PlateAndBlock two;
  AppDriver& driver = two.driver;
  // The block's underside is not seen: its front goes onto the plate's top.
  choose(driver, "menu.place", "place.face_on_face");
  ASSERT_TRUE(driver.app().has_widget("tool.hint"));
  const Bounds block = driver.session().bounds_of(driver.scene().roots()[1]);
  const glm::dvec3 front{block.centre().x, block.low.y, block.centre().z};
  driver.move(two.seen(front));
  driver.click(two.seen(front));
  driver.click(two.seen({-1.5, 0.5, 0.5}));
  EXPECT_NE(driver.session().interface.dragging.find("exact"), std::string::npos);
  EXPECT_EQ(driver.faults(), "");
  driver.key(Key::enter);
  EXPECT_EQ(driver.session().interface.tool, nullptr);
  EXPECT_EQ(driver.app().last_message(), "Face on face: exact.");
  EXPECT_EQ(driver.session().document.undo_name(), "Face on face");
  const NodeId id = driver.scene().roots()[1];
  const Bounds landed = driver.session().bounds_of(id);
  EXPECT_EQ(landed.low.z, 0.5);
  EXPECT_EQ(placement(driver, 1).position.z, 1.5);
  driver.key('A', true);
  driver.key('U');
  const Solid* both = driver.session().results.solid(driver.scene().roots().front());
  ASSERT_NE(both, nullptr);
  EXPECT_EQ(both->counts().shells, 1u) << "they touch without a gap";
}

TEST(AppPlace, CentredAndTurnedOverByKeys) {
  PlateAndBlock two;
  AppDriver& driver = two.driver;
  driver.key('F', false, true);
  two.pick_front();
  driver.click(two.seen({-1.5, 0.5, 0.5}));
  driver.key('C');
  EXPECT_EQ(placement(driver, 1).position, (Vec3{0, 0, 1.5}));
  driver.key('T');
  EXPECT_EQ(placement(driver, 1).position, (Vec3{0, 0, -0.5})) << "level with the top";
  const Scene before = driver.scene();
  driver.key(Key::escape);
  EXPECT_NE(driver.scene(), before) << "given back";
  EXPECT_EQ(placement(driver, 1).position, (Vec3{2.3, 0, 4.7}));
}

TEST(AppPlace, EdgeOnEdge) {
  PlateAndBlock two;
  AppDriver& driver = two.driver;
  choose(driver, "menu.place", "place.edge_on_edge");
  const Bounds b = driver.session().bounds_of(driver.scene().roots()[1]);
  driver.click(two.seen({b.low.x + 0.4, b.low.y, b.high.z}));
  driver.click(two.seen({-2.5, -2, 0.5}));
  driver.key(Key::enter);
  const Bounds landed = driver.session().bounds_of(driver.scene().roots()[1]);
  EXPECT_EQ(driver.app().last_message(), "Edge on edge: exact.");
  EXPECT_EQ(landed.low.x, -3);
  EXPECT_EQ(landed.low.y, -2);
  EXPECT_EQ(landed.high.z, 0.5);
}

TEST(AppPlace, OnTheGroundAndAligned) {
  PlateAndBlock two;
  AppDriver& driver = two.driver;
  driver.key('A', true);
  driver.key(Key::end);
  EXPECT_EQ(placement(driver, 0).position.z, 0.5);
  EXPECT_EQ(placement(driver, 1).position.z, 1);
  EXPECT_EQ(driver.app().last_message(), "Put on the ground: exact.");
  choose(driver, "menu.place", "Align", "place.right");
  EXPECT_EQ(placement(driver, 0).position.x + 3, 3.3) << "the one selected last stays";
  EXPECT_EQ(placement(driver, 1).position.x, 2.3);
  choose(driver, "menu.place", "Align", "place.middle_z");
  EXPECT_EQ(placement(driver, 0).position.z, 1);
  driver.key('Z', true);
  EXPECT_EQ(placement(driver, 0).position.z, 0.5);
}

TEST(AppPlace, EqualGaps) {
  AppDriver driver(1280, 800);
  for (const char* x : {"0", "3", "10"}) {
    driver.add("block");
    driver.enter("properties.position.x", x);
  }
  driver.key('A', true);
  choose(driver, "menu.place", "Distribute", "place.distribute_x");
  EXPECT_EQ(placement(driver, 1).position.x, 5);
  EXPECT_EQ(placement(driver, 0).position.x, 0);
  EXPECT_EQ(placement(driver, 2).position.x, 10);
}

TEST(AppPlace, ASolidIsNotPlacedOnItself) {
  PlateAndBlock two;
  AppDriver& driver = two.driver;
  const Scene before = driver.scene();
  driver.key('F', false, true);
  driver.click(two.seen({-1.5, 0.5, 0.5}));
  driver.click(two.seen({-1.5, -2, 0}));
  EXPECT_EQ(driver.scene(), before);
  EXPECT_NE(driver.app().last_message().find("another solid"), std::string::npos);
  driver.press("tool.end");
  EXPECT_EQ(driver.session().interface.tool, nullptr);
}

// What was picked is gone: nothing is placed, and the tool begins anew.
TEST(AppPlace, UndoBetweenThePicksForgetsTheFirst) {
  PlateAndBlock two;
  AppDriver& driver = two.driver;
  driver.key('F', false, true);
  two.pick_front();
  while (driver.scene().roots().size() > 1) driver.key('Z', true);
  const Scene before = driver.scene();
  driver.click(two.seen({-1.5, 0.5, 0.5}));
  EXPECT_EQ(driver.scene(), before);
  ASSERT_NE(driver.session().interface.tool, nullptr);
  EXPECT_EQ(driver.session().interface.tool->hint(driver.session().view),
            "Click the face on which it is to lie.")
      << "this is the first pick now";
}

// Undo gives the place back that is shown, and with it the second pick.
TEST(AppPlace, UndoOfWhatIsShownTakesNothing) {
  PlateAndBlock two;
  AppDriver& driver = two.driver;
  driver.key('F', false, true);
  two.pick_front();
  driver.click(two.seen({-1.5, 0.5, 0.5}));
  driver.key('Z', true);
  EXPECT_EQ(placement(driver, 1).position, (Vec3{2.3, 0, 4.7}));
  EXPECT_EQ(driver.session().interface.dragging, "");
  driver.key(Key::enter);
  EXPECT_EQ(placement(driver, 1).position, (Vec3{2.3, 0, 4.7}));
  ASSERT_NE(driver.session().interface.tool, nullptr);
  EXPECT_EQ(driver.session().interface.tool->hint(driver.session().view),
            "Click the face on which it is to lie.");
  driver.click(two.seen({-1.5, 0.5, 0.5}));
  EXPECT_EQ(placement(driver, 1).position.z, 1.5);
  driver.key(Key::enter);
  EXPECT_EQ(driver.session().interface.tool, nullptr);
  EXPECT_EQ(driver.session().document.undo_name(), "Face on face");
}

TEST(AppPlace, UndoOfAChamferThatIsShownAsksForAnEdge) {
  PlateAndBlock two;
  AppDriver& driver = two.driver;
  const Scene before = driver.scene();
  driver.key('B', true);
  const Bounds b = driver.session().bounds_of(driver.scene().roots()[1]);
  driver.click(two.seen({b.low.x + 0.4, b.low.y, b.high.z}));
  ASSERT_TRUE(driver.session().document.has_draft());
  driver.key('Z', true);
  EXPECT_EQ(driver.scene(), before);
  driver.key(Key::enter);
  EXPECT_EQ(driver.scene(), before);
  ASSERT_NE(driver.session().interface.tool, nullptr);
  EXPECT_EQ(driver.session().interface.tool->hint(driver.session().view),
            "Click the edge that is to be cut off.");
}

TEST(AppPlace, UndoWithAPickedEdgeChamfersNothing) {
  PlateAndBlock two;
  AppDriver& driver = two.driver;
  driver.key('B', true);
  ASSERT_NE(driver.session().interface.tool, nullptr);
  const Bounds b = driver.session().bounds_of(driver.scene().roots()[1]);
  driver.click(two.seen({b.low.x + 0.4, b.low.y, b.high.z}));
  ASSERT_TRUE(driver.session().document.has_draft());
  while (driver.scene().roots().size() > 1) driver.key('Z', true);
  const Scene before = driver.scene();
  driver.key(Key::enter);
  EXPECT_EQ(driver.scene(), before);
  ASSERT_NE(driver.session().interface.tool, nullptr);
  EXPECT_EQ(driver.session().interface.tool->hint(driver.session().view),
            "Click the edge that is to be cut off.");
}

}  // namespace
}  // namespace sectile::viewer
