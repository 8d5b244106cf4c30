// The whole window beside pictures that were looked at and kept.
#include <gtest/gtest.h>

#include "viewer/app_driver.h"
#include "viewer/reference_pictures.h"

namespace sectile::viewer {
namespace {

constexpr int width = 1280, height = 800;

void expect_as_kept(AppDriver& driver, const std::string& name) {
  EXPECT_EQ(difference_from_reference(name, driver.app().screenshot()), "");
  EXPECT_EQ(driver.faults(), "");
}

TEST(ReferencePicturesOfInterface, EmptyScene) {
  AppDriver driver(width, height);
  expect_as_kept(driver, "interface-empty");
}

TEST(ReferencePicturesOfInterface, ModelWithResult) {
  AppDriver driver(width, height);
  driver.app().open_sample("fig01");
  driver.settle();
  expect_as_kept(driver, "interface-fig01");
}

// Of a difference that is worked on: the operands' outlines, and what was removed.
TEST(ReferencePicturesOfInterface, OperandsOfADifference) {
  AppDriver driver(width, height);
  driver.app().open_sample("fig13");
  driver.settle();
  driver.press("tree:" + std::to_string(driver.app().scene().roots().front()));
  driver.settle();
  expect_as_kept(driver, "interface-operands");
}

TEST(ReferencePicturesOfInterface, StepOfNullEdges) {
  AppDriver driver(width, height);
  driver.app().open_sample("fig13");
  driver.settle();
  driver.app().show_step(Phase::null_edges, 1);
  driver.settle();
  expect_as_kept(driver, "interface-fig13-null_edges");
}

}  // namespace
}  // namespace sectile::viewer
