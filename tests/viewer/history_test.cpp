#include "scene/history.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace sectile::viewer {
namespace {

Scene with_block(double x, NodeId* id = nullptr) {
  Scene scene;
  Node node;
  node.what = Primitive();
  node.placement.position.x = x;
  const NodeId made = scene.add(node);
  if (id) *id = made;
  return scene;
}

TEST(History, GoesBackAndForthWithSelections) {
  History history;
  NodeId id = 0;
  const Scene one = with_block(1, &id);
  history.apply("Add block", one, {id});
  history.apply("Delete", Scene());
  EXPECT_TRUE(history.selection().empty());
  EXPECT_EQ(history.undo_description(), "Delete");
  history.undo();
  EXPECT_TRUE(history.scene() == one);
  EXPECT_EQ(history.selection(), Selection{id});
  EXPECT_EQ(history.redo_description(), "Delete");
  history.undo();
  EXPECT_EQ(history.scene().size(), 0u);
  EXPECT_FALSE(history.can_undo());
  history.redo();
  EXPECT_TRUE(history.scene() == one);
  history.apply("Move", with_block(2));
  EXPECT_FALSE(history.can_redo());
  EXPECT_EQ(history.descriptions(), (std::vector<std::string>{"Add block", "Move"}));
}

TEST(History, MakesOneStepOfADrag) {
  History history(with_block(0));
  history.begin("Move");
  for (int i = 1; i <= 50; ++i) history.update(with_block(i));
  EXPECT_TRUE(history.is_dragging());
  history.commit();
  EXPECT_TRUE(history.scene() == with_block(50));
  history.undo();
  EXPECT_TRUE(history.scene() == with_block(0));
  EXPECT_FALSE(history.can_undo());
}

TEST(History, CancelledAndEmptyDragsLeaveNoStep) {
  History history(with_block(0));
  history.begin("Move");
  history.update(with_block(1));
  history.cancel();
  EXPECT_TRUE(history.scene() == with_block(0));
  history.begin("Move");
  history.update(with_block(1));
  history.update(with_block(0));
  history.commit();
  EXPECT_FALSE(history.can_undo());
  EXPECT_THROW(history.update(with_block(1)), std::logic_error);
}

TEST(History, KnowsWhetherTheFileIsUpToDate) {
  History history;
  EXPECT_TRUE(history.is_saved());
  history.apply("Add block", with_block(1));
  EXPECT_FALSE(history.is_saved());
  history.mark_saved();
  history.apply("Move", with_block(2));
  EXPECT_FALSE(history.is_saved());
  history.undo();
  EXPECT_TRUE(history.is_saved());
  history.apply("Move", with_block(3));
  EXPECT_FALSE(history.is_saved());
}

}  // namespace
}  // namespace sectile::viewer
