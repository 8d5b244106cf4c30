// The tour of the paper in the window, and what helps to teach from the steps.
#include <gtest/gtest.h>

#include <algorithm>

#include "app/session.h"
#include "tour/station.h"
#include "viewer/app_driver.h"

namespace sectile::viewer {
namespace {

void run(AppDriver& driver, const std::string& menu, const std::string& item) {
  driver.press(menu);
  driver.settle();
  driver.press("menu:" + item);
  driver.settle();
}

TEST(AppTour, GoesForwardsAndBackwardsByKeys) {
  AppDriver driver(AppDriver::waiting(), 1280, 800);
  run(driver, "menu.help", "tour.start");
  ASSERT_TRUE(driver.session().interface.tour.is_on());
  for (std::size_t i = 0; i < 4; ++i) {
    const Station& station = stations()[i];
    EXPECT_EQ(driver.session().interface.tour.at(), i);
    ASSERT_NE(driver.session().results.player.story(), nullptr) << station.title;
    EXPECT_EQ(driver.session().results.player.phase(), station.phase) << station.title;
    EXPECT_EQ(driver.session().results.player.step(),
              step_of(station, *driver.session().results.player.story()).value());
    EXPECT_EQ(driver.faults(), "") << station.title;
    driver.key(Key::right, true);
    driver.settle();
  }
  driver.key(Key::left, true);
  driver.settle();
  EXPECT_EQ(driver.session().interface.tour.at(), 3u);
  EXPECT_FALSE(driver.session().interface.tour.shows_answer);
  driver.key(Key::down, true);
  driver.settle();
  EXPECT_TRUE(driver.session().interface.tour.shows_answer);
  driver.press("tour.end");
  driver.settle();
  EXPECT_FALSE(driver.session().interface.tour.is_on());
}

TEST(AppTour, SamplesShowTheirOperandsFirst) {
  AppDriver driver(AppDriver::waiting(), 1280, 800);
  driver.app().open_sample("fig13");
  driver.settle();
  const auto says = [&](const char* what) {
    const auto& legend = driver.session().view.legend;
    return std::any_of(legend.begin(), legend.end(),
                       [&](const LegendKey& key) { return key.text.starts_with(what); });
  };
  EXPECT_TRUE(says("A"));
  EXPECT_TRUE(says("B"));
  EXPECT_FALSE(says("result"));
  driver.press("tree:" + std::to_string(driver.scene().roots().front()));
  driver.settle();
  EXPECT_TRUE(says("result"));
  EXPECT_TRUE(says("removed"));
}

TEST(AppTour, SpecialCasesOnlyPassesOverPlainSteps) {
  AppDriver driver(AppDriver::waiting(), 1280, 800);
  const Story& story = driver.open_steps("fig01");
  driver.press("steps.special_only");
  driver.settle();
  for (int i = 0; i < 5; ++i) {
    driver.key(Key::right);
    driver.settle();
    EXPECT_TRUE(story.steps()[driver.session().results.player.step()].special);
  }
}

TEST(AppTour, PointingAtARowLightsItInThePicture) {
  AppDriver driver(AppDriver::waiting(), 1280, 800);
  driver.open_steps("fig11");
  driver.app().show_step(Phase::vertex_face, 0);
  driver.settle();
  EXPECT_EQ(driver.session().interface.lit_row, -1);
  const glm::vec4 table = driver.app().widget("inspector.table");
  driver.move({table.x + 30, table.y + table.w * 0.5});
  driver.settle();
  EXPECT_GE(driver.session().interface.lit_row, 0);
  const auto& legend = driver.session().view.legend;
  EXPECT_TRUE(std::any_of(legend.begin(), legend.end(),
                          [](const LegendKey& key) { return key.text == "this row"; }));
}

TEST(AppTour, AChainOfOperandsOffersEachOfItsPairs) {
  AppDriver driver(AppDriver::waiting(), 1280, 800);
  for (const char* shape : {"block", "cylinder", "sphere"}) driver.add(shape);
  driver.key('A', true);
  driver.key('U');
  driver.settle();
  driver.key(Key::tab);
  driver.settle();
  ASSERT_NE(driver.session().results.player.story(), nullptr);
  EXPECT_EQ(driver.session().told_operand(), 2u);
  EXPECT_TRUE(driver.app().has_widget("inspector.pair"));
  const Solid last = driver.session().results.player.story()->result();
  const_cast<Session&>(driver.session()).tell_operand(1);
  driver.settle(5);
  EXPECT_FALSE(driver.session().results.player.story()->result() == last);
}

}  // namespace
}  // namespace sectile::viewer
