// The dialog that draws profiles.
#include <gtest/gtest.h>

#include <cmath>

#include "viewer/app_driver.h"

namespace sectile::viewer {
namespace {

/// Where a place of the drawing's plane is on the screen.
glm::dvec2 on_canvas(AppDriver& driver, double x, double y) {
  const glm::dvec2 zero = driver.middle("profile.at.0.0"), one = driver.middle("profile.at.1.1");
  return zero + glm::dvec2(x, y) * (one - zero);
}

void click(AppDriver& driver, double x, double y) {
  driver.click(on_canvas(driver, x, y));
}

void choose(AppDriver& driver, const std::string& item) {
  driver.press("menu.add");
  driver.press("menu:" + item);
}

const Primitive& primitive(const AppDriver& driver) {
  return std::get<Primitive>(driver.scene().at(driver.session().selected()).what);
}

double volume(const AppDriver& driver) {
  const Solid* solid = driver.session().results.solid(driver.session().selected());
  return solid ? solid->volume() : -1;
}

TEST(AppProfile, SaysHowWideTheGridIsAndWhereThePointerStands) {
  AppDriver driver(1280, 800);
  choose(driver, "profile.xy");
  driver.move(on_canvas(driver, 1, -2));
  driver.settle(2);
  EXPECT_TRUE(driver.app().has_widget("text:Grid 0.25   x 1   y -2"));
  driver.move(driver.middle("profile.circle"));
  driver.settle(2);
  EXPECT_TRUE(driver.app().has_widget("text:Grid 0.25"));
  EXPECT_EQ(driver.faults(), "");
}

TEST(AppProfile, DrawsAPlateWithAHoleAndChangesItLater) {
  for (const glm::ivec2 size : {glm::ivec2(1024, 700), {1280, 800}}) {
    AppDriver driver(size.x, size.y);
    choose(driver, "profile.xy");
    ASSERT_TRUE(driver.app().has_widget("panel.profile"));
    click(driver, -2, -2);
    click(driver, 2, -2);
    EXPECT_EQ(driver.faults(), "") << "while drawing";
    // The next side by its numbers.
    driver.enter("profile.next.length", "3.5");
    driver.enter("profile.next.angle", "90");
    driver.press("profile.next.add");
    click(driver, -2, 1.5);
    click(driver, -2, -2);  // the first corner again closes it
    EXPECT_EQ(driver.session().interface.profile.sketch.loops().size(), 1u);
    driver.press("profile.circle");
    driver.press("profile.done");
    ASSERT_FALSE(driver.app().has_widget("panel.profile"));
    EXPECT_EQ(driver.session().document.undo_name(), "Draw profile");
    EXPECT_EQ(primitive(driver).profile.outer[2].y, 1.5);
    EXPECT_NEAR(volume(driver), 14 - 16 * std::sin(2 * std::acos(-1.0) / 32), 1e-12);
    const Scene drawn = driver.scene();
    driver.press("properties.profile");
    click(driver, -2, 1.5);
    EXPECT_EQ(driver.faults(), "") << "with a corner selected";
    driver.enter("profile.corner.y", "2");
    driver.press("profile.done");
    EXPECT_EQ(primitive(driver).profile.outer[3].y, 2);
    EXPECT_EQ(driver.session().document.undo_name(), "Edit profile");
    driver.key('Z', true);
    EXPECT_EQ(driver.scene(), drawn);
  }
}

TEST(AppProfile, UponAFace) {
  AppDriver driver(1280, 800);
  driver.add("block");
  driver.key(Key::home);
  driver.key('P', false, true);
  driver.click(driver.app().on_screen({0.2, -0.3, 1}));
  ASSERT_TRUE(driver.app().has_widget("panel.profile"));
  // Corners of the face take the pointer.
  driver.click(on_canvas(driver, -1, -1) + glm::dvec2(4, 3));
  click(driver, 0, -1);
  click(driver, 0, 0);
  driver.key(Key::enter);
  driver.key(Key::enter);
  EXPECT_EQ(driver.scene().at(driver.session().selected()).placement.position, (Vec3{0, 0, 1}));
  EXPECT_EQ(primitive(driver).profile.outer[0].x, -1);
  EXPECT_EQ(primitive(driver).profile.outer[0].y, -1);
  EXPECT_EQ(volume(driver), 0.5);
}

TEST(AppProfile, CornersAreDraggedInsertedAndRemoved) {
  AppDriver driver(1280, 800);
  choose(driver, "profile.xy");
  driver.press("profile.rectangle");  // 2 by 2
  driver.drag(on_canvas(driver, 1, 1), on_canvas(driver, 2, 1));
  const ProfileSketch& sketch = driver.session().interface.profile.sketch;
  EXPECT_EQ(sketch.loops()[0][2].x, 2);
  EXPECT_EQ(sketch.loops()[0][2].y, 1);
  driver.double_click(on_canvas(driver, 0, -1));
  EXPECT_EQ(sketch.loops()[0].size(), 5u);
  driver.key(Key::del);
  EXPECT_EQ(sketch.loops()[0].size(), 4u);
  driver.key('Z', true);
  driver.key('Z', true);
  driver.key('Z', true);
  EXPECT_EQ(sketch.loops()[0][2].x, 1) << "a drag is one step";
  EXPECT_EQ(driver.scene().size(), 0u) << "the scene's own undo is not meant";
  driver.key(Key::escape);
  EXPECT_FALSE(driver.app().has_widget("panel.profile"));
  EXPECT_EQ(driver.scene().size(), 0u);
}

TEST(AppProfile, WhatIsWrongIsSaidBeforeTheSolidIsMade) {
  AppDriver driver(1280, 800);
  choose(driver, "profile.turned");
  for (const auto& [x, y] : {std::pair{1, 0}, {2, 2}, {2, 0}, {1, 2}}) click(driver, x, y);
  driver.key(Key::enter);
  EXPECT_NE(driver.session().interface.profile.sketch.problem(
                driver.session().interface.profile.primitive),
            "");
  driver.key(Key::enter);
  EXPECT_EQ(driver.scene().size(), 0u);
  EXPECT_EQ(driver.faults(), "");
}

}  // namespace
}  // namespace sectile::viewer
