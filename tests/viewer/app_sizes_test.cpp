// Every sample at every phase, and every station of the tour, in windows of all usual sizes:
// nothing is cut off, nothing lies on something else. Told by the rectangles of the widgets.
#include <gtest/gtest.h>

#include "app/samples_menu.h"
#include "app/words.h"
#include "tour/station.h"
#include "viewer/app_driver.h"

namespace sectile::viewer {
namespace {

struct Size {
  int width, height;
  float scale;
  bool dark;
};

class EveryWindow : public testing::TestWithParam<Size> {
 protected:
  EveryWindow() : driver_(options(), GetParam().width, GetParam().height, GetParam().scale) {}
  static AppOptions options() {
    AppOptions made = AppDriver::waiting();
    made.dark = GetParam().dark;
    return made;
  }
  AppDriver driver_;
};

TEST_P(EveryWindow, ShowsEverySampleAtEveryPhase) {
  for (const SampleTitle& sample : sample_titles()) {
    driver_.app().open_sample(sample.name);
    driver_.settle(2);
    EXPECT_EQ(driver_.faults(), "") << sample.name;
    if (driver_.session().story_node() == 0) continue;
    for (const Phase phase : all_phases) {
      driver_.app().show_step(phase, SIZE_MAX);
      driver_.settle(2);
      EXPECT_EQ(driver_.faults(), "") << sample.name << ", " << title_of(phase);
    }
    driver_.key(Key::tab);
  }
}

TEST_P(EveryWindow, ShowsTheTour) {
  driver_.press("menu.help");
  driver_.press("menu:tour.start");
  for (const Station& station : stations()) {
    ASSERT_TRUE(driver_.session().interface.tour.is_on());
    EXPECT_EQ(driver_.faults(), "") << station.title;
    driver_.key(Key::down, true);
    EXPECT_EQ(driver_.faults(), "") << station.title << ", the answer";
    driver_.key(Key::right, true);
  }
}

TEST_P(EveryWindow, ShowsDialogsAndTools) {
  driver_.add("block");
  driver_.add("cylinder");
  driver_.key('A', true);
  for (const char* command : {"repeat.linear", "edit.undo"}) {
    driver_.press(std::string(command).starts_with("edit") ? "menu.edit" : "menu.repeat");
    EXPECT_EQ(driver_.faults(), "") << "the menu of " << command;
    driver_.press(std::string("menu:") + command);
    EXPECT_EQ(driver_.faults(), "") << command;
  }
  const auto look = [&](const char* what, auto open) {
    open();
    EXPECT_EQ(driver_.faults(), "") << what;
    driver_.key(Key::escape);
  };
  look("moving", [&] { driver_.key('G'); });
  look("face on face", [&] { driver_.key('F', false, true); });
  look("measuring", [&] { driver_.key('M', false, true); });
  look("mirror", [&] { driver_.key('M', true); });
  look("chamfer", [&] { driver_.key('B', true); });
  look("keys", [&] { driver_.key(Key::f1); });
  look("recording", [&] { driver_.key(Key::f12); });
  look("opening", [&] { driver_.key('O', true); });
  look("exporting", [&] { driver_.key('E', true, true); });
  look("a profile", [&] { driver_.key('P', false, true); });
}

INSTANTIATE_TEST_SUITE_P(Sizes, EveryWindow,
                         testing::Values(Size{1024, 700, 1, false}, Size{1280, 800, 1, true},
                                         Size{1920, 1080, 1, false}, Size{1920, 1080, 2, true}),
                         [](const auto& tested) {
                           const Size& size = tested.param;
                           return std::to_string(size.width) + "x" + std::to_string(size.height) +
                                  (size.scale == 2 ? "AtTwice" : "") +
                                  (size.dark ? "Dark" : "Light");
                         });

}  // namespace
}  // namespace sectile::viewer
