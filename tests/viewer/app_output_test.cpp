// What leaves the modeller: pictures, films, files; colours, recent files, the section plane.
#include <gtest/gtest.h>
#include <stb_image.h>

#include <cmath>
#include <fstream>
#include <iterator>

#include "app/picture_maker.h"
#include "app/section_tool.h"
#include "app/words.h"
#include "render/renderer.h"
#include "scene/scene_file.h"
#include "viewer/app_driver.h"

namespace sectile::viewer {
namespace {

namespace fs = std::filesystem;

/// A folder of this test alone.
fs::path folder() {
  const fs::path made = fs::path(testing::TempDir()) / "sectile_output_test" /
                        testing::UnitTest::GetInstance()->current_test_info()->name();
  fs::create_directories(made);
  return made;
}

std::string bytes_of(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

int frames_in_gif(const fs::path& path, int& width, int& height) {
  const std::string bytes = bytes_of(path);
  int count = 0, channels = 0;
  int* delays = nullptr;
  stbi_uc* pixels =
      stbi_load_gif_from_memory(reinterpret_cast<const stbi_uc*>(bytes.data()), int(bytes.size()),
                                &delays, &width, &height, &count, &channels, 4);
  stbi_image_free(delays);
  stbi_image_free(pixels);
  return pixels ? count : 0;
}

void settle_recording(AppDriver& driver) {
  for (int i = 0; i < 200 && driver.session().is_busy(); ++i) driver.settle(1);
}

TEST(AppOutput, APictureOfAnySize) {
  fs::remove_all(folder());
  AppDriver driver;
  driver.add("block");
  RecordingPlan plan;
  plan.width = 1500, plan.height = 333;  // larger than the window
  plan.path = folder() / "picture.png";
  driver.app().record(plan);
  settle_recording(driver);
  const Image image = read_png(plan.path.string());
  EXPECT_EQ(image.width, 1500);
  EXPECT_EQ(image.height, 333);
  // The block is in the middle, the background at the side.
  const auto pixel = [&](int x, int y) {
    return &image.rgba[4 * (std::size_t(y) * 1500 + std::size_t(x))];
  };
  EXPECT_FALSE(std::equal(pixel(750, 166), pixel(750, 166) + 3, pixel(20, 166)));
  EXPECT_EQ(driver.app().last_message(), "Saved as picture.png.");
}

TEST(AppOutput, ATurntableAsGifAndTheCameraAsBefore) {
  AppDriver driver;
  driver.add("wedge");
  const Camera before = driver.app().camera();
  RecordingPlan plan;
  plan.kind = RecordingPlan::Kind::turntable;
  plan.width = 160, plan.height = 120, plan.frames = 6;
  plan.path = folder() / "turn.gif";
  driver.app().record(plan);
  settle_recording(driver);
  int width = 0, height = 0;
  EXPECT_EQ(frames_in_gif(plan.path, width, height), 6);
  EXPECT_EQ(width, 160);
  EXPECT_EQ(height, 120);
  EXPECT_EQ(driver.app().camera(), before);
}

TEST(AppOutput, StepsAsNumberedFrames) {
  fs::remove_all(folder());
  AppDriver driver;
  const Story& story = driver.open_steps("fig01");
  driver.key(Key::right);
  const std::size_t step = driver.session().results.player.step();
  RecordingPlan plan;
  plan.kind = RecordingPlan::Kind::steps;
  plan.width = 120, plan.height = 90;
  plan.path = folder() / "step.png";
  driver.app().record(plan);
  settle_recording(driver);
  EXPECT_EQ(driver.session().results.player.step(), step) << "as before";
  std::size_t files = 0;
  for (const auto& file : fs::directory_iterator(folder())) files += file.is_regular_file();
  EXPECT_EQ(files, story.steps().size());
  EXPECT_TRUE(fs::exists(folder() / "step-001.png"));
  EXPECT_NE(bytes_of(folder() / "step-001.png"),
            bytes_of(numbered(plan.path, story.steps().size() - 1, story.steps().size())));
}

TEST(AppOutput, TheDialogAsksForKindSizeAndFile) {
  for (const glm::ivec2 size : {glm::ivec2(1024, 700), {1280, 800}}) {
    AppDriver driver(size.x, size.y);
    driver.add("block");
    driver.key(Key::f12);
    EXPECT_TRUE(driver.app().has_widget("panel.recording"));
    EXPECT_EQ(driver.faults(), "");
    driver.press("record.steps");
    EXPECT_FALSE(driver.app().widgets().find("record.choose")->enabled) << "there are no steps";
    driver.press("record.turntable");
    EXPECT_EQ(driver.faults(), "");
    driver.press("record.hd");
    EXPECT_EQ(driver.session().interface.recording_plan.width, 1920u);
    driver.press("record.choose");
    EXPECT_TRUE(driver.app().has_widget("panel.browser"));
    driver.key(Key::escape);
  }
}

TEST(AppOutput, EachSolidIntoAFileOfItsOwn) {
  fs::remove_all(folder());
  AppDriver driver;
  driver.add("block");
  driver.add("cylinder");
  driver.add("wedge");
  driver.key('H');  // what is hidden stays here
  driver.key('E', true, true);
  ASSERT_TRUE(driver.app().has_widget("panel.browser"));
  driver.enter_file(folder() / "parts.off");
  driver.settle(5);
  EXPECT_TRUE(fs::exists(folder() / "parts-Block.off"));
  EXPECT_TRUE(fs::exists(folder() / "parts-Cylinder.off"));
  EXPECT_FALSE(fs::exists(folder() / "parts-Wedge.off"));
  EXPECT_EQ(Solid::from_mesh(read_mesh(folder() / "parts-Block.off")).volume(), 8);
  driver.key('E', true, true);
  driver.enter_file(folder() / "all.3mf");
  driver.settle(5);
  const Model model = read_model(folder() / "all.3mf");
  ASSERT_EQ(model.meshes.size(), 2u);
  EXPECT_EQ(model.meshes[0].name, "Block");
  EXPECT_EQ(model.meshes[1].name, "Cylinder");
}

TEST(Export, GroupsAreOneSolidOfThe3mfAndNothingIsLeftOutInSilence) {
  AppDriver driver;
  driver.add("block");
  driver.add("block");
  driver.key('A', true);
  driver.key('G', true);
  driver.add("cylinder");
  driver.key('E', true, true);
  driver.enter_file(folder() / "all.3mf");
  driver.settle(5);
  const Model model = read_model(folder() / "all.3mf");
  ASSERT_EQ(model.meshes.size(), 2u);
  EXPECT_EQ(model.meshes[0].name, "Group");
  EXPECT_EQ(Solid::from_mesh(model.meshes[0].mesh).volume(), 16);
}

TEST(ThreeMf, SolidsComeInAsPartsWithNamesAndColoursAndGoOutWithThem) {
  Model model;
  const PolygonMesh box = block({0, 0, 0}, {1, 2, 3}).to_mesh();
  model.meshes = {{"Lid", box, MeshColour{200, 10, 30}}, {"", box}, {"Lid", box}};
  const fs::path in = folder() / "in.3mf", out = folder() / "out.3mf";
  fs::remove(out);  // or the dialog asks whether to replace it
  write_model(in, model);
  AppDriver driver;
  driver.key('O', true);
  driver.enter_file(in);
  driver.settle(5);
  ASSERT_EQ(driver.scene().roots().size(), 3u) << driver.app().last_message();
  EXPECT_EQ(driver.session().selection().size(), 3u);
  const auto node = [&](std::size_t i) { return driver.scene().at(driver.scene().roots()[i]); };
  EXPECT_EQ(node(0).name, "Lid");
  EXPECT_EQ(node(1).name, "in");
  EXPECT_EQ(node(2).name, "Lid 2");
  EXPECT_EQ(node(0).colour, (NodeColour{200 / 255.0f, 10 / 255.0f, 30 / 255.0f}));
  EXPECT_FALSE(node(1).colour);
  driver.key('E', true, true);
  driver.enter_file(out);
  driver.settle(5);
  const Model back = read_model(out);
  ASSERT_EQ(back.meshes.size(), 3u);
  EXPECT_EQ(back.meshes[0].colour, model.meshes[0].colour);
  EXPECT_EQ(back.meshes[2].name, "Lid 2");
  driver.key('Z', true);
  EXPECT_TRUE(driver.scene().is_empty()) << "one step of undo";
}

TEST(ThreeMf, AFileInInchesStandsInMillimetresAndSaysSo) {
  Model model;
  model.unit = LengthUnit::inch;
  model.meshes = {{"Inch", block({0, 0, 0}, {1, 1, 1}).to_mesh()}};
  const fs::path in = folder() / "inches.3mf";
  write_model(in, model);
  AppDriver driver;
  driver.drop(in);
  ASSERT_EQ(driver.scene().size(), 1u) << driver.app().last_message();
  const Node& node = driver.scene().at(driver.scene().roots().front());
  EXPECT_EQ(node.placement.scale, (Vec3{25.4, 25.4, 25.4}));
  EXPECT_EQ(driver.app().last_message(),
            "inches.3mf counts in inches: scaled by 25.4 to millimetres.");
  EXPECT_DOUBLE_EQ(driver.session().bounds_of_all().high.x, 25.4);
}

TEST(ThreeMf, OneSolidIsNoPlural) {
  AppDriver driver;
  driver.add("block");
  const fs::path out = folder() / "one.3mf";
  fs::remove(out);
  driver.key('E', true, true);
  driver.enter_file(out);
  driver.settle(5);
  EXPECT_EQ(driver.app().last_message(), "1 solid exported to one.3mf.");
}

TEST(Words, OneFaceIsNoPlural) {
  EXPECT_EQ(counted(0, "face"), "0 faces");
  EXPECT_EQ(counted(1, "face"), "1 face");
  EXPECT_EQ(counted(1200, "face"), "1\u00A0200 faces");
}

TEST(AppOutput, RecentFilesOutliveTheSession) {
  fs::remove_all(folder());
  const fs::path file = folder() / "one.sectile";
  AppOptions options = AppDriver::waiting();
  options.data_folder = folder() / "data";
  {
    AppDriver driver(options);
    driver.add("block");
    driver.key('S', true);
    driver.enter_file(file);
    ASSERT_TRUE(fs::exists(file));
  }
  AppDriver driver(options);
  EXPECT_EQ(driver.scene().size(), 0u);
  driver.press("menu.file");
  driver.press("submenu.Recent files");
  EXPECT_EQ(driver.faults(), "");
  driver.press("recent.0");
  driver.settle(5);
  EXPECT_EQ(driver.scene().size(), 1u);
}

TEST(AppOutput, ColoursOfTheirOwn) {
  Scene scene;
  Node block;
  block.what = Primitive();
  block.colour = NodeColour{0.25f, 0.5f, 1};
  scene.add(block);
  const fs::path file = folder() / "coloured.sectile";
  write_scene(file, {scene, {}});
  AppDriver driver;
  driver.app().open(file);
  driver.settle();
  EXPECT_EQ(driver.scene(), scene);
  driver.key(Key::escape);
  EXPECT_EQ(visible_shapes(driver.session()).front().surface.colour, (Colour{0.25f, 0.5f, 1, 1}));
  driver.key('A', true);
  driver.press("properties.colour.none");
  EXPECT_FALSE(driver.scene().at(driver.scene().roots().front()).colour);
  EXPECT_EQ(driver.session().document.undo_name(), "Colour");
}

TEST(AppOutput, TheSectionPlaneGoesOntoAFaceAndAlongItsNormal) {
  AppDriver driver(1100, 760);
  driver.add("wedge");
  driver.key(Key::escape);
  driver.key(Key::home);
  driver.key('X', false, true);
  ASSERT_TRUE(driver.session().view.section);
  EXPECT_EQ(driver.session().view.section_plane(), glm::dvec4(0, -1, 0, 0)) << "halves it";
  EXPECT_EQ(driver.faults(), "");
  // The slope of the wedge is what one sees from the right.
  driver.key('3');
  const glm::dvec2 at = driver.app().on_screen({0, 0.85, 0});
  driver.move(at);
  driver.click(at);
  const glm::dvec4 slope = driver.session().view.section_plane();
  EXPECT_NEAR(slope.x, std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(slope.z, std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(slope.w, 0, 1e-12);
  EXPECT_TRUE(driver.session().view.section_oblique);
  driver.key('1');
  const Handles handles =
      section_handles(driver.session().view, driver.session().bounds_of_all(), HandleMode::move);
  const auto on_arrow = [&](double t) {
    return driver.app().on_screen(handles.origin + t * handles.size * handles.axes[2]);
  };
  driver.drag(on_arrow(0.6), on_arrow(0.1));
  const glm::dvec4 moved = driver.session().view.section_plane();
  EXPECT_GT(moved.w, 0.05);
  EXPECT_NEAR(moved.w * 20, std::round(moved.w * 20), 1e-9) << "on round numbers";
  EXPECT_EQ(moved.x, slope.x);
  driver.key('Z');
  EXPECT_EQ(glm::dvec3(driver.session().view.section_plane()), glm::dvec3(0, 0, 1));
  driver.key('T');
  EXPECT_EQ(glm::dvec3(driver.session().view.section_plane()), glm::dvec3(0, 0, -1));
}

TEST(AppOutput, TheSectionPlaneTiltsByItsRings) {
  AppDriver driver(1100, 760);
  driver.add("block");
  driver.key(Key::escape);
  driver.key(Key::home);
  driver.key('X', false, true);
  driver.key('Z');
  const Handles handles =
      section_handles(driver.session().view, driver.session().bounds_of_all(), HandleMode::rotate);
  const auto on_ring = [&](double degrees) {
    const double a = degrees * std::acos(-1.0) / 180;
    return driver.app().on_screen(handles.origin + handles.size * (std::cos(a) * handles.axes[1] +
                                                                   std::sin(a) * handles.axes[2]));
  };
  const glm::dvec3 toward = -driver.app().camera().forward();
  const double from = glm::dot(handles.axes[1], toward) > 0 ? 45 : 135;
  driver.drag(on_ring(from), on_ring(from + 20));
  const glm::dvec4 plane = driver.session().view.section_plane();
  const double tilt = glm::degrees(std::acos(plane.z));
  EXPECT_GT(tilt, 5);
  EXPECT_NEAR(tilt / 5, std::round(tilt / 5), 1e-6);
  EXPECT_NEAR(plane.w, 0, 1e-12) << "about the middle";
}

}  // namespace
}  // namespace sectile::viewer
