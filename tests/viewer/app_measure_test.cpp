// Measuring in the picture, and the dimensions of the selection.
#include <gtest/gtest.h>

#include <cmath>

#include "app/dimensions.h"
#include "app/measure_tool.h"
#include "viewer/app_driver.h"

namespace sectile::viewer {
namespace {

std::string result(const AppDriver& driver) {
  const auto* tool = dynamic_cast<const MeasureTool*>(driver.session().interface.tool.get());
  return tool ? tool->result() : "no tool";
}

TEST(AppMeasure, VerticesEdgesAndFaces) {
  AppDriver driver(1100, 700);
  driver.add("block");
  driver.key(Key::escape);
  driver.key(Key::home);
  const auto click = [&](const glm::dvec3& p) {
    driver.move(driver.app().on_screen(p));
    driver.click(driver.app().on_screen(p));
  };
  driver.key('M', false, true);
  click({1, -1, 1});
  EXPECT_EQ(result(driver), "Vertex: x 1 \u00B7 y -1 \u00B7 z 1");
  click({-1, -1, -1});
  EXPECT_EQ(result(driver), "Distance 2.828427 \u00B7 dx -2 \u00B7 dz -2");
  EXPECT_EQ(driver.faults(), "");
  click({0, -1, 1});
  EXPECT_EQ(result(driver), "Edge: Length 2");
  click({0.2, 0.1, 1});
  EXPECT_EQ(result(driver), "Distance 0 \u00B7 Angle 0\u00B0");
  EXPECT_TRUE(driver.session().selection().empty()) << "clicks select nothing meanwhile";
  driver.key(Key::escape);
  EXPECT_EQ(result(driver), "no tool");
}

// What is gone has no length.
TEST(AppMeasure, UndoForgetsWhatWasPicked) {
  AppDriver driver(1100, 700);
  driver.add("block");
  driver.enter("properties.size.x", "4");
  driver.key('M', false, true);
  driver.click(driver.app().on_screen({2, -1, 1}));
  ASSERT_EQ(result(driver), "Vertex: x 2 \u00B7 y -1 \u00B7 z 1");
  driver.key('Z', true);
  EXPECT_EQ(result(driver), "");
}

TEST(AppMeasure, TheRadiusOfARim) {
  AppDriver driver(1100, 700);
  driver.add("cylinder");
  driver.enter("properties.radius", "2.5");
  driver.key(Key::escape);
  driver.key(Key::home);
  driver.key('M', false, true);
  const Bounds box = driver.session().bounds_of(driver.scene().roots().front());
  // In the middle of an edge of the rim that is seen.
  const double a = 0, b = -2 * M_PI / 32;
  const glm::dvec3 p{1.25 * (std::cos(a - M_PI / 4) + std::cos(b - M_PI / 4)),
                     1.25 * (std::sin(a - M_PI / 4) + std::sin(b - M_PI / 4)), box.high.z};
  driver.click(driver.app().on_screen(p));
  EXPECT_NE(result(driver).find("Radius 2.5 \u00B7 Diameter 5"), std::string::npos)
      << result(driver);
}

TEST(AppMeasure, DimensionsFollowADrag) {
  AppDriver driver(1100, 700);
  driver.add("block");
  driver.enter("properties.rotation.z", "45");
  const auto box = [&] {
    return close_bounds_of_selection(driver.session().document, visible_shapes(driver.session()));
  };
  EXPECT_NEAR(box().high.x - box().low.x, 2 * std::sqrt(2), 1e-6) << "close around what is turned";
  const auto labels = [&] { return PictureMaker().make(driver.session()).labels.size(); };
  EXPECT_EQ(labels(), 0u);
  driver.key('S');
  driver.key('Z');
  driver.type("3");
  EXPECT_EQ(labels(), 3u) << "while it is dragged";
  EXPECT_NEAR(box().high.z - box().low.z, 6, 1e-6);
  driver.key(Key::enter);
  EXPECT_EQ(labels(), 0u);
  driver.key('B', false, true);
  EXPECT_EQ(labels(), 3u);
}

TEST(AppMeasure, DimensionsAreThoseOfTheResultNotOfItsOperands) {
  AppDriver driver(1100, 700);
  driver.add("block");
  driver.add("block");
  driver.enter("properties.position.x", "1.5");
  driver.key('A', true);
  driver.key('D');
  const NodeId difference = driver.scene().roots().front();
  const auto width = [&] {
    const Bounds box =
        close_bounds_of_selection(driver.session().document, visible_shapes(driver.session()));
    return box.high.x - box.low.x;
  };
  EXPECT_NEAR(width(), 1.5, 1e-6);
  driver.press("tree:" + std::to_string(driver.scene().at(difference).children[1]));
  EXPECT_NEAR(width(), 2, 1e-6) << "of the operand that is selected itself";
}

}  // namespace
}  // namespace sectile::viewer
