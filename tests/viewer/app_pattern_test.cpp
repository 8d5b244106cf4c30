// Arrays and mirrors made in the picture.
#include <gtest/gtest.h>

#include <cmath>

#include "viewer/app_driver.h"

namespace sectile::viewer {
namespace {

void choose(AppDriver& driver, const std::string& item) {
  driver.press("menu.repeat");
  driver.press("menu:" + item);
}

const Pattern& pattern(const AppDriver& driver) {
  return std::get<Pattern>(driver.scene().at(driver.session().selected()).what);
}

const Solid& only_solid(const AppDriver& driver) {
  const Solid* solid = driver.session().results.solid(driver.scene().roots().front());
  if (!solid) throw std::runtime_error("The only solid was not computed.");
  return *solid;
}

TEST(AppPattern, ARowIsAStepThatCanBeChangedLater) {
  AppDriver driver(1100, 760);
  driver.add("block");
  choose(driver, "repeat.linear");
  EXPECT_EQ(pattern(driver).step, (Vec3{3, 0, 0}));
  EXPECT_EQ(only_solid(driver).volume(), 24);
  driver.enter("properties.count", "5");
  driver.enter("properties.step.x", "2");
  EXPECT_EQ(only_solid(driver).volume(), 40);
  EXPECT_EQ(only_solid(driver).counts().shells, 1u);
  EXPECT_EQ(driver.faults(), "");
  // The child is still there, and what is changed of it changes all copies.
  const NodeId child = driver.scene().at(driver.session().selected()).children.front();
  driver.press("tree:" + std::to_string(child));
  driver.enter("properties.size.y", "1");
  EXPECT_EQ(only_solid(driver).volume(), 20);
  for (int i = 0; i < 4; ++i) driver.key('Z', true);
  EXPECT_EQ(driver.scene().size(), 1u);
}

TEST(AppPattern, HolesAroundTheAxisOfARim) {
  AppDriver driver(1100, 760);
  driver.add("cylinder");
  driver.enter("properties.radius", "4");
  driver.enter("properties.height", "1");
  driver.add("cylinder");
  driver.enter("properties.radius", "0.5");
  driver.enter("properties.position.x", "3");
  driver.key(Key::home);
  choose(driver, "repeat.polar");
  const NodeId disc = driver.scene().roots().front();
  const Bounds box = driver.session().bounds_of(disc);
  const double a = 2 * M_PI / 32;
  const glm::dvec3 p{2 * (std::cos(-8 * a) + std::cos(-7 * a)),
                     2 * (std::sin(-8 * a) + std::sin(-7 * a)), box.high.z};
  driver.move(driver.app().on_screen(p));
  driver.click(driver.app().on_screen(p));
  ASSERT_EQ(driver.session().interface.tool, nullptr) << "the rim gives the axis";
  EXPECT_EQ(pattern(driver).count, 4u);
  EXPECT_EQ(std::abs(pattern(driver).axis.z), 1);
  EXPECT_EQ(pattern(driver).centre.x, 0);
  EXPECT_EQ(pattern(driver).centre.y, 0);
  driver.enter("properties.count", "6");
  const NodeId ring = driver.session().selected();
  driver.press("tree:" + std::to_string(disc));
  driver.click(driver.middle("tree:" + std::to_string(ring)), true);
  driver.key('D');
  EXPECT_EQ(only_solid(driver).counts().genus, 6);
}

TEST(AppPattern, MirrorsAtTheFaceThatIsClicked) {
  AppDriver driver(1100, 760);
  driver.add("wedge");
  driver.key(Key::home);
  driver.key('M', true);
  driver.key('K');
  const glm::dvec2 front = driver.app().on_screen({-0.4, -1, -0.4});
  driver.move(front);
  EXPECT_EQ(driver.faults(), "");
  driver.click(front);
  EXPECT_EQ(pattern(driver).kind, Pattern::Kind::mirror);
  EXPECT_EQ(pattern(driver).axis, (Vec3{0, -1, 0}));
  EXPECT_EQ(pattern(driver).centre.y, -1);
  EXPECT_FALSE(pattern(driver).keeps);
  EXPECT_EQ(driver.session().bounds_of(driver.session().selected()).low.y, -3);
  EXPECT_EQ(only_solid(driver).volume(), 4);
  driver.press("properties.keeps");
  EXPECT_EQ(only_solid(driver).volume(), 8);
  EXPECT_EQ(only_solid(driver).counts().shells, 1u) << "they meet in the mirror";
}

TEST(AppPattern, AlongAPathOnTheGround) {
  AppDriver driver(1100, 760);
  driver.add("block");
  driver.key(Key::home);
  driver.key('7');
  choose(driver, "repeat.path");
  for (const glm::dvec3& p : {glm::dvec3(1.5, -1.5, 0), {1.5, 1.5, 0}, {-1.5, 1.5, 0}})
    driver.click(driver.app().on_screen(p));
  EXPECT_EQ(driver.faults(), "");
  driver.key(Key::enter);
  ASSERT_EQ(pattern(driver).path.size(), 3u);
  EXPECT_EQ(pattern(driver).path[0], (Vec3{1.5, -1.5, 0})) << "on the grid";
  EXPECT_EQ(pattern(driver).count, 5u);
  EXPECT_EQ(driver.faults(), "");
}

}  // namespace
}  // namespace sectile::viewer
