// The tree of the scene: names, order, groups.
#include <gtest/gtest.h>

#include "viewer/app_driver.h"

namespace sectile::viewer {
namespace {

std::string row(NodeId id) {
  return "tree:" + std::to_string(id);
}

/// A place in a row: 0 its upper edge, 1 its lower.
glm::dvec2 in_row(AppDriver& driver, NodeId id, double down) {
  const glm::vec4 r = driver.app().widget(row(id));
  return {r.x + r.z / 2, r.y + r.w * down};
}

NodeId add(AppDriver& driver, const std::string& shape) {
  driver.add(shape);
  return driver.scene().roots().back();
}

TEST(AppTree, RenamesByKeyAndByDoubleClick) {
  AppDriver driver;
  const NodeId id = add(driver, "block");
  driver.key(Key::f2);
  driver.type("Bracket \u03B1");
  driver.key(Key::enter);
  EXPECT_EQ(driver.scene().at(id).name, "Bracket \u03B1");
  driver.double_click(in_row(driver, id, 0.5));
  ASSERT_TRUE(driver.app().has_widget("tree.name"));
  driver.type("Bolt");
  driver.key(Key::enter);
  EXPECT_EQ(driver.scene().at(id).name, "Bolt");
  driver.key(Key::f2);
  driver.type("Nothing");
  driver.key(Key::escape);
  EXPECT_EQ(driver.scene().at(id).name, "Bolt") << "Esc keeps the name";
  EXPECT_FALSE(driver.app().has_widget("tree.name"));
  driver.key('Z', true);
  driver.key('Z', true);
  EXPECT_EQ(driver.scene().at(id).name, "Block");
  EXPECT_EQ(driver.scene().size(), 1u);
}

TEST(AppTree, TypingANameRunsNoCommands) {
  AppDriver driver;
  const NodeId id = add(driver, "block");
  driver.key(Key::f2);
  driver.key('H');  // hides, when nothing is being typed
  driver.key(Key::del);
  driver.type("h");
  driver.key(Key::enter);
  EXPECT_TRUE(driver.scene().at(id).visible);
  EXPECT_EQ(driver.scene().at(id).name, "h");
}

TEST(AppTree, DragsChangeTheOrder) {
  AppDriver driver;
  const NodeId a = add(driver, "block"), b = add(driver, "block"), c = add(driver, "block");
  driver.drag(in_row(driver, a, 0.5), in_row(driver, c, 0.9));
  EXPECT_EQ(driver.scene().roots(), (std::vector<NodeId>{b, c, a}));
  driver.drag(in_row(driver, c, 0.5), in_row(driver, b, 0.1));
  EXPECT_EQ(driver.scene().roots(), (std::vector<NodeId>{c, b, a}));
  EXPECT_EQ(driver.session().document.undo_name(), "Move in the tree");
  driver.key('Z', true);
  driver.key('Z', true);
  EXPECT_EQ(driver.scene().roots(), (std::vector<NodeId>{a, b, c}));
}

TEST(AppTree, DragsGoIntoGroupsAndOutOfThem) {
  AppDriver driver;
  const NodeId a = add(driver, "block"), b = add(driver, "block");
  driver.press(row(a));
  driver.key('G', true);
  const NodeId group = driver.scene().roots().front();
  ASSERT_TRUE(std::holds_alternative<Group>(driver.scene().at(group).what));
  driver.enter("properties.position.x", "0.5");
  const Transform before = driver.scene().world(b);
  driver.drag(in_row(driver, b, 0.5), in_row(driver, group, 0.5));
  EXPECT_EQ(driver.scene().at(b).parent, group);
  EXPECT_EQ(driver.scene().world(b).m, before.m) << "it stays where it is";
  EXPECT_EQ(driver.scene().at(b).placement.position.x, before.m[3] - 0.5);
  driver.drag(in_row(driver, group, 0.5), in_row(driver, b, 0.9));
  EXPECT_EQ(driver.scene().at(group).parent, 0u);
  EXPECT_NE(driver.app().last_message().find("below itself"), std::string::npos);
  driver.drag(in_row(driver, b, 0.5), in_row(driver, b, 0.5) + glm::dvec2(0, 60));
  EXPECT_EQ(driver.scene().roots(), (std::vector<NodeId>{group, b}));
  EXPECT_EQ(driver.scene().world(b).m, before.m);
}

TEST(AppTree, DragsGiveOperandsToAnOperation) {
  AppDriver driver;
  const NodeId a = add(driver, "block"), b = add(driver, "block"), c = add(driver, "block");
  driver.click(in_row(driver, a, 0.5));
  driver.click(in_row(driver, b, 0.5), true);
  driver.key('U');
  const NodeId result = driver.session().selected();
  driver.drag(in_row(driver, c, 0.5), in_row(driver, result, 0.5));
  EXPECT_EQ(driver.scene().at(result).children, (std::vector<NodeId>{a, b, c}));
  EXPECT_EQ(driver.session().results.solid(result)->volume(), 24);
}

TEST(AppTree, DeletesWholeGroups) {
  AppDriver driver;
  add(driver, "block");
  add(driver, "sphere");
  const NodeId other = add(driver, "block");
  driver.press(row(driver.scene().roots()[0]));
  driver.click(in_row(driver, driver.scene().roots()[1], 0.5), true);
  driver.key('G', true);
  const Scene grouped = driver.scene();
  ASSERT_EQ(grouped.roots().size(), 2u);
  driver.key(Key::del);
  EXPECT_EQ(driver.scene().roots(), std::vector<NodeId>{other});
  EXPECT_EQ(driver.scene().size(), 1u);
  driver.key('Z', true);
  EXPECT_EQ(driver.scene(), grouped);
  // A member goes alone; a group and its member are no trouble together.
  const NodeId group = driver.session().selected();
  const NodeId member = driver.scene().at(group).children.front();
  driver.press(row(member));
  driver.click(in_row(driver, group, 0.5), true);
  driver.key(Key::backspace);
  EXPECT_EQ(driver.scene().roots(), std::vector<NodeId>{other});
  driver.key('Z', true);
  driver.press(row(member));
  driver.key(Key::del);
  EXPECT_EQ(driver.scene().at(group).children.size(), 1u);
  driver.press(row(group));
  driver.key('G', true, true);
  EXPECT_EQ(driver.scene().roots().size(), 2u) << "ungrouped";
}

}  // namespace
}  // namespace sectile::viewer
