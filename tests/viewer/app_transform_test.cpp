// G, R and S: the selection follows the mouse, axes and numbers are typed.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "app/commands.h"
#include "viewer/app_driver.h"

namespace sectile::viewer {
namespace {

const Placement& placement(const AppDriver& driver) {
  return driver.scene().at(driver.session().selected()).placement;
}

/// A selected block, and the pointer beside its middle.
struct Block {
  Block() {
    driver.add("block");
    driver.key(Key::home);
    before = driver.scene();
    pointer = driver.app().on_screen({0, 0, 0}) + glm::dvec2(70, 40);
    driver.move(pointer);
  }
  AppDriver driver;
  Scene before;
  glm::dvec2 pointer{0};
};

TEST(AppTransform, TheSelectionFollowsTheMouseAtOnce) {
  Block block;
  auto& [driver, before, pointer] = block;
  driver.key('G');
  EXPECT_EQ(driver.scene(), before) << "not before the mouse moves";
  driver.move(pointer + glm::dvec2(90, 10));
  EXPECT_NE(placement(driver).position, Vec3()) << "no button is held";
  EXPECT_NE(driver.session().interface.dragging, "");
  driver.key(Key::escape);
  EXPECT_EQ(driver.scene(), before);
  EXPECT_EQ(driver.session().document.undo_name(), "Add block");
  EXPECT_EQ(driver.session().selection().size(), 1u) << "it stays selected";
  driver.move(pointer + glm::dvec2(120, 30));
  EXPECT_EQ(driver.scene(), before) << "the mouse is free again";
}

TEST(AppTransform, AClickTakesItAsOneStep) {
  Block block;
  auto& [driver, before, pointer] = block;
  driver.key('G');
  for (int i = 1; i <= 5; ++i) driver.move(pointer + glm::dvec2(18, 2) * double(i));
  const Scene shown = driver.scene();
  driver.click(pointer + glm::dvec2(90, 10));
  EXPECT_EQ(driver.scene(), shown);
  EXPECT_NE(driver.scene(), before);
  EXPECT_EQ(driver.session().selection().size(), 1u) << "the click selects nothing else";
  EXPECT_EQ(driver.session().document.undo_name(), "Move");
  driver.key('Z', true);
  EXPECT_EQ(driver.scene(), before);
}

TEST(AppTransform, ARightClickGivesItBack) {
  Block block;
  auto& [driver, before, pointer] = block;
  driver.key('S');
  driver.move(pointer + glm::dvec2(90, 10));
  EXPECT_GT(placement(driver).scale.x, 1.2);
  EXPECT_EQ(placement(driver).scale.x, placement(driver).scale.z);
  driver.drag(pointer, pointer, MouseButton::right);
  EXPECT_EQ(driver.scene(), before);
}

TEST(AppTransform, TypedNumbersAreTakenToTheLastBit) {
  Block block;
  auto& driver = block.driver;
  driver.key('G');
  driver.key('X');
  driver.type("2");
  driver.type(".3");
  driver.key(Key::enter);
  EXPECT_EQ(placement(driver).position, (Vec3{2.3, 0, 0}));
  driver.key('G');
  driver.key('Y');
  driver.type("0,7");
  driver.type("-");  // a sign may come late
  driver.key(Key::enter);
  EXPECT_EQ(placement(driver).position, (Vec3{2.3, -0.7, 0}));
  driver.key('G');
  driver.key('Z');
  driver.type("15");
  driver.key(Key::backspace);
  driver.key(Key::enter);
  EXPECT_EQ(placement(driver).position, (Vec3{2.3, -0.7, 1}));
  EXPECT_EQ(driver.session().document.undo_name(), "Move");
  driver.key('Z', true);
  EXPECT_EQ(placement(driver).position, (Vec3{2.3, -0.7, 0}));
}

TEST(AppTransform, ShiftKeepsThePlaneAcrossAnAxis) {
  Block block;
  auto& [driver, before, pointer] = block;
  driver.key('G');
  driver.key('X', false, true);
  driver.move(pointer + glm::dvec2(60, -90));
  EXPECT_EQ(placement(driver).position.x, 0);
  EXPECT_NE(placement(driver).position.y, 0);
  EXPECT_NE(placement(driver).position.z, 0);
  driver.type("1");
  driver.key(Key::tab);
  driver.type("2");
  driver.key(Key::enter);
  EXPECT_EQ(placement(driver).position, (Vec3{0, 1, 2}));
}

TEST(AppTransform, TurnsByTypedDegreesAndByThePointer) {
  Block block;
  auto& [driver, before, pointer] = block;
  driver.key('R');
  driver.key('Z');
  driver.type("30");
  driver.key(Key::enter);
  EXPECT_EQ(placement(driver).rotation, (Vec3{0, 0, 30}));
  EXPECT_EQ(driver.session().document.undo_name(), "Rotate");
  driver.key('Z', true);
  // A quarter turn of the pointer around the solid, seen from above.
  driver.key('7');
  const glm::dvec2 middle = driver.app().on_screen({0, 0, 0});
  driver.move(middle + glm::dvec2(100, 0));
  driver.key('R');
  driver.key('Z');
  driver.move(middle + glm::dvec2(71, -71));
  driver.move(middle + glm::dvec2(0, -100));
  driver.key(Key::enter);
  EXPECT_EQ(placement(driver).rotation, (Vec3{0, 0, 90}));
}

TEST(AppTransform, ScalesAllAxesOneOrTwo) {
  Block block;
  auto& driver = block.driver;
  const auto scaled = [&](auto constrain) {
    driver.key('S');
    constrain();
    driver.type("3");
    driver.key(Key::enter);
    const Vec3 scale = placement(driver).scale;
    driver.key('Z', true);
    return scale;
  };
  EXPECT_EQ(scaled([] {}), (Vec3{3, 3, 3}));
  EXPECT_EQ(scaled([&] { driver.key('Y'); }), (Vec3{1, 3, 1}));
  EXPECT_EQ(scaled([&] { driver.key('Y', false, true); }), (Vec3{3, 1, 3}));
}

TEST(AppTransform, TheSameAxisTwiceIsTheSolidsOwn) {
  Block block;
  auto& driver = block.driver;
  driver.enter("properties.rotation.z", "90");
  const auto moved = [&](int times) {
    driver.key('G');
    for (int i = 0; i < times; ++i) driver.key('X');
    driver.type("1");
    driver.key(Key::enter);
    const Vec3 position = placement(driver).position;
    driver.key('Z', true);
    return position;
  };
  EXPECT_EQ(moved(1), (Vec3{1, 0, 0}));
  EXPECT_NEAR(moved(2).y, 1, 1e-12);
  EXPECT_EQ(moved(3), (Vec3{1, 0, 0})) << "without a constraint a number goes along x";
}

TEST(AppTransform, AnotherKeyChangesWhatTheMouseDoes) {
  Block block;
  auto& [driver, before, pointer] = block;
  driver.key('G');
  driver.move(pointer + glm::dvec2(60, 0));
  driver.key('S');
  EXPECT_EQ(placement(driver).position, Vec3()) << "the move is given back";
  driver.type("2");
  driver.key(Key::enter);
  EXPECT_EQ(placement(driver).scale, (Vec3{2, 2, 2}));
  EXPECT_EQ(driver.session().document.undo_name(), "Scale");
}

TEST(AppTransform, NoPanelSeesTheMouseMeanwhile) {
  Block block;
  auto& [driver, before, pointer] = block;
  const glm::dvec2 undo = driver.middle("edit.undo");
  driver.key('G');
  driver.move(pointer + glm::dvec2(60, 0));
  driver.settle();
  driver.click(undo);
  EXPECT_EQ(driver.session().document.undo_name(), "Move") << "taken, not undone";
  EXPECT_EQ(driver.session().interface.tool, nullptr);
}

TEST(AppTransform, KeysOfCommandsDoNotActMeanwhile) {
  Block block;
  auto& driver = block.driver;
  driver.key('G');
  driver.key(Key::del);
  driver.key('H');
  EXPECT_EQ(driver.scene(), block.before);
  EXPECT_NE(driver.session().interface.tool, nullptr);
}

TEST(AppTransform, WithoutASelectionTheKeysDoNothing) {
  AppDriver driver;
  driver.key('G');
  EXPECT_EQ(driver.session().interface.tool, nullptr);
}

TEST(AppKeys, EveryCommandWithAKeyStandsOnThePage) {
  for (const glm::ivec2 size : {glm::ivec2(1024, 700), {1280, 800}, {1920, 1080}}) {
    AppDriver driver(size.x, size.y);
    driver.key(Key::f1);
    EXPECT_TRUE(driver.app().has_widget("panel.keys"));
    EXPECT_EQ(driver.faults(), "") << size.x;
    driver.key(Key::escape);
    EXPECT_FALSE(driver.app().has_widget("panel.keys"));
  }
}

TEST(AppKeys, NoTwoCommandsShareAKey) {
  const Commands commands;
  std::map<std::string, std::string> owners;
  for (const CommandMenu& menu : commands.menus())
    for (const Command& command : menu.commands)
      for (const Shortcut& shortcut : command.keys) {
        Command alone = command;
        alone.keys = {shortcut};
        // Steps are told in a mode of their own.
        const std::string key = (menu.name == "menu.steps" ? "steps " : "") + key_name(alone);
        EXPECT_TRUE(owners.emplace(key, command.name).second)
            << key << ": " << owners[key] << " and " << command.name;
      }
}

}  // namespace
}  // namespace sectile::viewer
