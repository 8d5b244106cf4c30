// What people expect of any program: menus that keys close, typed numbers that are understood,
// messages that are not lost, files in the order in which they were named.
#include <gtest/gtest.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <fstream>
#include <future>

#include "app/file_work.h"
#include "app/picture_maker.h"
#include "viewer/app_driver.h"

namespace sectile::viewer {
namespace {

namespace fs = std::filesystem;

fs::path new_folder() {
  const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
  const fs::path folder =
      fs::path(::testing::TempDir()) / ("sectile_habits_" + std::string(test->name()));
  fs::remove_all(folder);
  fs::create_directories(folder);
  return folder;
}

/// Two blocks of edge 2 that overlap by half; all of it selected.
void add_two_blocks(AppDriver& driver) {
  driver.add("block");
  driver.add("block");
  driver.enter("properties.position.x", "1");
  driver.key('A', true);
}

TEST(Files, AreHandedOverInTheOrderInWhichTheyWereNamed) {
  FileWork files;
  std::promise<void> first_may_end;
  std::atomic<bool> second_ended{false};
  std::vector<int> order;
  files.start(FileWork::Kind::reading, "first", [&]() -> FileWork::Finish {
    first_may_end.get_future().wait();
    return [&] { order.push_back(1); };
  });
  files.start(FileWork::Kind::reading, "second", [&]() -> FileWork::Finish {
    second_ended = true;
    return [&] { order.push_back(2); };
  });
  while (!second_ended) std::this_thread::yield();
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  files.finish(false);
  EXPECT_TRUE(order.empty()) << "the second one waits for the first";
  first_may_end.set_value();
  files.finish(true);
  EXPECT_EQ(order, (std::vector<int>{1, 2}));
  EXPECT_FALSE(files.is_busy());
}

TEST(Groups, AreNotEmptyAndExportedWhole) {
  const fs::path folder = new_folder();
  AppDriver driver;
  add_two_blocks(driver);
  driver.key('G', true);
  const NodeId group = driver.scene().roots().front();
  ASSERT_TRUE(std::holds_alternative<Group>(driver.scene().at(group).what));
  EXPECT_EQ(driver.session().results.solid(group), nullptr) << "it is no empty solid";
  const std::vector<Shape> shapes = visible_shapes(driver.session());
  ASSERT_EQ(shapes.size(), 2u);
  for (const Shape& shape : shapes) EXPECT_TRUE(shape.surface.highlighted);
  driver.key('E', true);
  driver.accept_file(folder / "group.obj");
  ASSERT_TRUE(fs::exists(folder / "group.obj")) << driver.app().last_message();
  EXPECT_EQ(Solid::from_mesh(read_mesh(folder / "group.obj")).volume(), 12);
}

TEST(NestedOperands, AreSeenAndOutlined) {
  AppDriver driver;
  add_two_blocks(driver);
  driver.key('D');
  const NodeId inner = driver.scene().roots().front();
  driver.add("block");
  driver.key('A', true);
  driver.key('U');
  const NodeId operand = driver.scene().at(inner).children.front();
  driver.press("tree:" + std::to_string(operand));
  const auto shape_of = [&](NodeId id) -> std::optional<Shape> {
    for (const Shape& shape : visible_shapes(driver.session()))
      if (shape.node == id) return shape;
    return std::nullopt;
  };
  ASSERT_TRUE(shape_of(operand));
  EXPECT_TRUE(shape_of(operand)->is_operand);
  EXPECT_TRUE(shape_of(operand)->surface.highlighted);
  driver.press("tree:" + std::to_string(inner));
  ASSERT_TRUE(shape_of(inner)) << "an operation inside another one is seen too";
  EXPECT_TRUE(shape_of(inner)->surface.highlighted);
}

TEST(TypedValues, TakeExpressionsUnitsAndADecimalComma) {
  AppDriver driver;
  driver.add("block");
  const NodeId id = driver.scene().roots().front();
  const auto at = [&]() -> const Placement& { return driver.scene().at(id).placement; };
  driver.enter("properties.position.x", "40/2");
  EXPECT_EQ(at().position.x, 20);
  driver.enter("properties.position.x", "20,5");
  EXPECT_EQ(at().position.x, 20.5);
  driver.enter("properties.position.y", "2 cm");
  EXPECT_EQ(at().position.y, 20);
  driver.enter("properties.rotation.z", "pi/2 * 1 rad");
  EXPECT_EQ(driver.app().last_message(), "") << "nothing was refused so far";
  const Scene before = driver.scene();
  driver.enter("properties.position.x", "1e12");
  EXPECT_NE(driver.app().last_message().find("at most 1000000000"), std::string::npos)
      << driver.app().last_message();
  EXPECT_EQ(driver.scene(), before);
  driver.key(Key::escape);
  driver.enter("properties.rotation.x", "3 mm");
  EXPECT_NE(driver.app().last_message().find("not a unit of angles"), std::string::npos)
      << driver.app().last_message();
  EXPECT_EQ(driver.scene(), before);
}

TEST(TypedValues, TabGoesToTheNextField) {
  AppDriver driver;
  driver.add("block");
  const NodeId id = driver.scene().roots().front();
  driver.press("properties.position.x");
  for (const char* text : {"1", "2", "3"}) {
    driver.type(text);
    driver.key(Key::tab);
  }
  driver.key(Key::escape);
  EXPECT_EQ(driver.scene().at(id).placement.position, (Vec3{1, 2, 3}));
  EXPECT_EQ(driver.session().mode(), Mode::model);
}

TEST(MessageList, KeepsTheMessagesOfAllBadFiles) {
  const fs::path folder = new_folder();
  AppDriver driver;
  for (int i = 0; i < 6; ++i) {
    const fs::path file = folder / ("bad" + std::to_string(i) + ".sectile");
    std::ofstream(file) << "{ \"kind\": \n";
    driver.drop(file);
  }
  EXPECT_EQ(driver.session().interface.messages.shown().size(), 3u);
  EXPECT_EQ(driver.session().interface.messages.waiting(), 3u);
  ASSERT_EQ(driver.session().interface.messages.all().size(), 6u);
  for (int i = 0; i < 6; ++i) {
    const std::string& text =
        driver.session().interface.messages.all()[static_cast<std::size_t>(i)].text;
    EXPECT_EQ(text.find("bad" + std::to_string(i) + ".sectile: line "), 0u) << text;
    EXPECT_EQ(text.find("exception"), std::string::npos) << text;
    EXPECT_EQ(text.back(), '.');
  }
  driver.press("messages.more");
  EXPECT_TRUE(driver.app().has_widget("panel.messages"));
  EXPECT_TRUE(driver.session().interface.messages.shown().empty());
  EXPECT_EQ(driver.session().interface.messages.all().size(), 6u);
  driver.press("messages.close");
  EXPECT_FALSE(driver.app().has_widget("panel.messages"));
  driver.press("status.messages");
  EXPECT_TRUE(driver.app().has_widget("panel.messages"));
}

TEST(MessageList, WhatWasToldOfTheSceneBeforeIsNotShownWithTheNext) {
  AppDriver driver;
  driver.app().open_sample("fig13");
  driver.settle(2);
  driver.app().open_sample("fig02");
  driver.settle(2);
  const auto& shown = driver.session().interface.messages.shown();
  ASSERT_EQ(shown.size(), 1u);
  EXPECT_EQ(shown[0].text.find("Figures 2, 3 of the paper: "), 0u) << shown[0].text;
  EXPECT_EQ(driver.session().interface.messages.all().size(), 2u) << "the list keeps it";
}

TEST(MessageList, LeavesTheViewCubeFree) {
  AppDriver driver(1024, 700);
  driver.open_steps("fig13");
  const glm::vec4 message = driver.app().widget("panel.message.0"),
                  cube = driver.app().widget("view_cube.front");
  EXPECT_LE(message.x + message.z, cube.x);
}

TEST(Menus, CloseWithEscapeAndKeepTheSelection) {
  AppDriver driver;
  driver.add("block");
  const NodeId selected = driver.session().selected();
  driver.press("menu.edit");
  ASSERT_TRUE(driver.app().has_widget("menu:edit.undo"));
  driver.key(Key::escape);
  EXPECT_FALSE(driver.app().has_widget("menu:edit.undo"));
  EXPECT_EQ(driver.session().selected(), selected);
  driver.key(Key::escape);
  EXPECT_EQ(driver.session().selected(), 0u);
}

TEST(Menus, AreWalkedByArrowKeys) {
  AppDriver driver;
  driver.press("menu.steps");
  ASSERT_TRUE(driver.app().has_widget("menu:mode.steps"));
  driver.key(Key::down);
  driver.key(Key::right);
  EXPECT_FALSE(driver.app().has_widget("menu:mode.steps"));
  ASSERT_TRUE(driver.app().has_widget("sample:fig01")) << "the menu to the right";
  driver.key(Key::down);
  driver.key(Key::enter);
  EXPECT_FALSE(driver.app().has_widget("sample:fig01"));
  EXPECT_FALSE(driver.scene().is_empty()) << "a sample was chosen";
}

TEST(Menus, AreWalkedAroundTheirEndsAndBack) {
  AppDriver driver;
  driver.press("menu.file");
  driver.key(Key::left);
  EXPECT_TRUE(driver.app().has_widget("menu:help.keys")) << "before the first stands the last";
  driver.key(Key::right);
  EXPECT_TRUE(driver.app().has_widget("menu:file.open"));
  driver.key(Key::right);
  EXPECT_TRUE(driver.app().has_widget("menu:edit.undo"));
  driver.key(Key::left);
  EXPECT_TRUE(driver.app().has_widget("menu:file.open"));
  driver.key(Key::escape);
  EXPECT_FALSE(driver.app().has_widget("menu:file.open"));
}

TEST(Steps, LeavingThemShowsTheModelAsItWas) {
  AppDriver driver;
  add_two_blocks(driver);
  driver.key('D');
  const Camera before = driver.app().camera();
  driver.key(Key::tab);
  driver.key(Key::right);
  ASSERT_NE(driver.app().camera(), before) << "it follows the steps";
  driver.key(Key::tab);
  EXPECT_EQ(driver.session().mode(), Mode::model);
  EXPECT_EQ(driver.app().camera(), before);
  // Not where a person chose to look for himself.
  driver.key(Key::tab);
  driver.key('C');
  const Camera chosen = driver.app().camera();
  driver.key(Key::tab);
  EXPECT_EQ(driver.app().camera(), chosen);
}

TEST(Section, StartsWhereItCutsSomething) {
  AppDriver driver;
  driver.add("block");
  driver.enter("properties.position.x", "1");
  driver.key('X');
  EXPECT_TRUE(driver.session().view.section);
  EXPECT_EQ(driver.session().view.section_plane(), glm::dvec4(1, 0, 0, -1));
}

TEST(Section, HasAnOutline) {
  AppDriver driver;
  driver.add("block");
  const auto lines_of = [&] {
    std::size_t ends = 0;
    for (const Lines& lines : PictureMaker().make(driver.session()).lines)
      ends += lines.ends.size();
    return ends;
  };
  const std::size_t before = lines_of();
  driver.key('X');
  EXPECT_GE(lines_of(), before + 8) << "the four sides of the cut";
}

TEST(Frame, IncludesOperandsThatAreShown) {
  AppDriver driver;
  add_two_blocks(driver);
  driver.key('I');
  ASSERT_EQ(driver.session().bounds_of_all().high.x, 1) << "the result alone";
  driver.key('F');
  for (const double x : {-1.0, 2.0})
    for (const double z : {-1.0, 1.0}) {
      const glm::dvec2 p = driver.app().on_screen({x, -1, z});
      const glm::vec4 picture = driver.app().widget("picture");
      EXPECT_GT(p.x, picture.x);
      EXPECT_LT(p.x, picture.x + picture.z);
      EXPECT_GT(p.y, picture.y);
      EXPECT_LT(p.y, picture.y + picture.w);
    }
  EXPECT_EQ(driver.session().bounds_shown(true).high.x, 2);
}

TEST(Frame, IncludesPartsThatArePulledApart) {
  AppDriver driver;
  driver.open_steps("fig01");
  driver.key(Key::page_down);
  for (int i = 0; i < 8; ++i) driver.key(Key::page_down);
  driver.app().show_step(Phase::components, 0);
  driver.settle();
  const Bounds together = driver.session().bounds_of_all();
  driver.drag(driver.middle("view.exploded"), driver.middle("view.exploded") + glm::dvec2(400, 0));
  ASSERT_EQ(driver.session().view.exploded, 1);
  const Bounds apart = driver.session().bounds_shown(false);
  EXPECT_GT(glm::length(apart.high - apart.low), 1.05 * glm::length(together.high - together.low));
  driver.key('F');
  EXPECT_LT(glm::distance(driver.app().camera().target, apart.centre()), 1e-9);
}

TEST(Duplicate, StaysInPlace) {
  AppDriver driver;
  driver.add("block");
  driver.enter("properties.position.y", "3");
  const NodeId original = driver.session().selected();
  driver.key('D', true);
  const NodeId copy = driver.session().selected();
  ASSERT_NE(copy, original);
  EXPECT_EQ(driver.scene().at(copy).placement, driver.scene().at(original).placement);
}

TEST(Deleting, TheFirstOperandOfADifferenceSaysWhatStandsInItsPlace) {
  AppDriver driver;
  add_two_blocks(driver);
  driver.key('D');
  const Node difference = driver.scene().at(driver.scene().roots().front());
  const std::string first = driver.scene().at(difference.children[0]).name;
  const std::string second = driver.scene().at(difference.children[1]).name;
  driver.press("tree:" + std::to_string(difference.children[0]));
  driver.key(Key::del);
  const std::string message = driver.app().last_message();
  EXPECT_NE(message.find("\"" + first + "\""), std::string::npos) << message;
  EXPECT_NE(message.find("now \"" + second + "\" stands in its place"), std::string::npos)
      << message;
}

TEST(Quit, AsksForASceneThatWasEmptied) {
  const fs::path folder = new_folder();
  AppDriver driver;
  driver.add("block");
  driver.key('S', true);
  driver.accept_file(folder / "kept.sectile");
  ASSERT_FALSE(driver.session().document.is_changed()) << driver.app().last_message();
  driver.key('A', true);
  driver.key(Key::del);
  ASSERT_TRUE(driver.scene().is_empty());
  driver.key('Q', true);
  EXPECT_FALSE(driver.app().wants_to_close());
  EXPECT_TRUE(driver.app().has_widget("question.save"));
}

TEST(Title, NamesTheFileAndMarksChanges) {
  const fs::path folder = new_folder();
  AppDriver driver;
  EXPECT_EQ(driver.app().title(), "Sectile");
  driver.add("block");
  EXPECT_EQ(driver.app().title(), "*unnamed \u2013 Sectile");
  driver.key('S', true);
  driver.accept_file(folder / "part.sectile");
  EXPECT_EQ(driver.app().title(), "part.sectile \u2013 Sectile");
}

TEST(FileBrowserFolder, IsRememberedByTheNextSession) {
  const fs::path folder = new_folder();
  fs::create_directories(folder / "models");
  AppOptions options = AppDriver::waiting();
  options.data_folder = folder / "data";
  {
    AppDriver driver(options);
    driver.add("block");
    driver.key('S', true);
    driver.accept_file(folder / "models" / "part.sectile");
  }
  AppDriver driver(options);
  driver.key('O', true);
  EXPECT_EQ(driver.session().interface.dialogs.browser.folder, folder / "models");
}

TEST(FailingField, LeavesTheFieldsWhereTheyAre) {
  AppDriver driver;
  driver.add("extrusion");
  const NodeId id = driver.session().selected();
  const glm::vec4 before = driver.app().widget("properties.scale.x");
  driver.enter("properties.scale.x", "0");
  ASSERT_NE(driver.session().results.error_of(id), "");
  ASSERT_TRUE(driver.app().has_widget("properties.error"));
  EXPECT_EQ(driver.app().widget("properties.scale.x"), before);
}

/// The step with the widest table: half-planes around a segment.
void show_wide_table(AppDriver& driver) {
  const Story& story = driver.open_steps("fig01");
  const auto [first, end] = story.range(Phase::vertex_vertex);
  for (std::size_t i = first; i < end; ++i)
    if (story.step(i).columns.size() == 8) {
      driver.app().show_step(Phase::vertex_vertex, i - first);
      driver.settle(4);
      return;
    }
  FAIL() << "no such step";
}

TEST(StepsTable, IsWholeAtUsualSizes) {
  struct Size {
    int width, height;
    float scale;
  };
  for (const Size& size : {Size{1280, 800, 1}, {1024, 700, 1}, {1920, 1080, 2}}) {
    AppDriver driver(size.width, size.height, size.scale);
    show_wide_table(driver);
    for (const std::string& column : driver.session().results.player.current()->columns)
      for (const char* row : {"inspector.column:", "inspector.last:"}) {
        const Widget* cell = driver.app().widgets().find(row + column);
        ASSERT_NE(cell, nullptr) << size.width << ' ' << column;
        EXPECT_FALSE(cell->clipped) << size.width << ' ' << row << column;
      }
    EXPECT_EQ(driver.faults(), "") << size.width;
  }
}

TEST(Panels, AreResizedByTheirEdges) {
  AppDriver driver(1280, 800);
  driver.open_steps("fig13");
  driver.app().show_step(Phase::null_edges, 1);
  driver.settle();
  ASSERT_TRUE(driver.app().has_widget("inspector.sphere"));
  const auto width = [&](const char* name) { return driver.app().widget(name).z; };
  const float inspector = width("panel.inspector"), tree = width("panel.tree");
  const glm::dvec2 right = driver.middle("splitter.right"), left = driver.middle("splitter.left");
  driver.drag(right, right - glm::dvec2(80, 0));
  EXPECT_NEAR(width("panel.inspector"), inspector + 80, 2);
  driver.drag(left, left + glm::dvec2(40, 0));
  EXPECT_NEAR(width("panel.tree"), tree + 40, 2);
  const float sphere = driver.app().widget("inspector.sphere").w;
  const glm::dvec2 above = driver.middle("splitter.sphere");
  driver.drag(above, above + glm::dvec2(0, 60));
  EXPECT_NEAR(driver.app().widget("inspector.sphere").w, sphere - 60, 2);
  driver.double_click(driver.middle("splitter.right"));
  EXPECT_EQ(width("panel.inspector"), inspector);
  EXPECT_EQ(driver.faults(), "");
}

TEST(Tooltips, ComeAfterAMomentAndHaveWords) {
  AppDriver driver;
  const auto tooltip = [] {
    const ImGuiWindow* window = ImGui::FindWindowByName("##Tooltip_00");
    return window && window->Active && window->HiddenFramesCanSkipItems == 0 ? window : nullptr;
  };
  driver.move(driver.middle("view.frame"));
  driver.settle(3);
  EXPECT_EQ(tooltip(), nullptr) << "the mouse only passes over";
  EXPECT_TRUE(driver.app().needs_frame()) << "until it comes, without a further event";
  driver.settle(40);
  ASSERT_NE(tooltip(), nullptr);
  EXPECT_GT(tooltip()->Size.x, 60);
  EXPECT_FALSE(driver.app().needs_frame());
}

}  // namespace
}  // namespace sectile::viewer
