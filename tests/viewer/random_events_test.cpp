// Whatever is pressed, dragged and typed: undo leads back to the beginning, redo to the end again.
#include <gtest/gtest.h>

#include <cstdlib>

#include "app/samples_menu.h"
#include "scene/scene_file.h"
#include "viewer/random_person.h"

namespace sectile::viewer {
namespace {

constexpr int events = 1000;

std::string text_of(const AppDriver& driver) {
  return scene_text({driver.scene(), {}});
}

void press_until(AppDriver& driver, char letter, bool (Document::*can)() const) {
  for (int i = 0; (driver.session().document.*can)(); ++i) {
    ASSERT_LT(i, 3 * events) << "undo does not come to an end";
    driver.short_key(static_cast<Key>(letter), true, false);
  }
}

class RandomEvents : public testing::TestWithParam<std::uint64_t> {};

TEST_P(RandomEvents, UndoLeadsBackToTheBeginningByteForByte) {
  AppDriver driver(AppDriver::drawing(), 800, 520);
  driver.app().start(sample_scene(GetParam() % 2 ? "fig01" : "fig13"), {});
  driver.settle();
  const std::string before = text_of(driver);
  RandomPerson person(driver, GetParam());
  std::size_t changes = 0;
  std::uint64_t revision = driver.session().document.revision();
  for (int i = 0; i < events; ++i) {
    ASSERT_NO_THROW(person.act()) << "event " << i << ": " << person.last();
    changes += driver.session().document.revision() != revision;
    revision = driver.session().document.revision();
    if (const char* told = std::getenv("SECTILE_TELL_EVENTS"); told && *told)
      std::printf("%d %s: %zu nodes\n", i, person.last().c_str(), driver.scene().size());
  }
  EXPECT_GT(changes, 50u) << "most events did nothing";
  person.come_to_rest();
  ASSERT_FALSE(driver.session().document.has_draft());
  press_until(driver, 'Y', &Document::can_redo);
  const std::string after = text_of(driver);
  press_until(driver, 'Z', &Document::can_undo);
  EXPECT_EQ(text_of(driver), before);
  EXPECT_FALSE(driver.session().document.is_changed());
  press_until(driver, 'Y', &Document::can_redo);
  EXPECT_EQ(text_of(driver), after);
  press_until(driver, 'Z', &Document::can_undo);
  EXPECT_EQ(text_of(driver), before);
}

// This one typed into a slider, typed again where the text was shorter, and took steps of the first
// text back, at which ImGui ended the program.
TEST(RandomPeople, MayTypeIntoASliderTwice) {
  AppDriver driver(AppDriver::drawing(), 800, 520);
  driver.key(Key::escape);
  RandomPerson person(driver, 112);
  driver.add("block");
  for (int i = 0; i < 400; ++i)
    ASSERT_NO_THROW(person.act()) << "event " << i << ": " << person.last();
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomEvents, testing::Values(1, 2, 3));

}  // namespace
}  // namespace sectile::viewer
