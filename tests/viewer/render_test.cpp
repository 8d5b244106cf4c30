// The rendering layer: camera, surfaces, pictures off screen, PNG files, comparison of pictures.
#include <gtest/gtest.h>
#include <imgui.h>

#include <filesystem>
#include <fstream>
#include <glm/gtc/matrix_transform.hpp>
#include <random>

#include "demo_pictures.h"
#include "picture/polygon_ears.h"
#include "picture/surface_mesh.h"
#include "picture/theme.h"
#include "render/embedded.h"
#include "render/image_difference.h"
#include "render/renderer.h"
#include "sectile/primitives.h"

namespace sectile::viewer {
namespace {

constexpr int width = 320, height = 240;

struct Rgb {
  int r, g, b;
};

Rgb at(const Image& image, int x, int y) {
  const std::size_t i = (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                         static_cast<std::size_t>(x)) *
                        4;
  return {image.rgba[i], image.rgba[i + 1], image.rgba[i + 2]};
}

Image drawn(Renderer& renderer, const Picture& picture) {
  renderer.begin_frame();
  renderer.draw(picture, {0, 0, width, height});
  return renderer.read_frame();
}

Image drawn(const Picture& picture) {
  const auto context = make_offscreen_context(width, height);
  Renderer renderer(*context);
  return drawn(renderer, picture);
}

Surface surface_of(const Solid& solid, const Colour& colour) {
  Surface surface;
  surface.mesh = surface_mesh(solid);
  surface.colour = colour;
  surface.translucent = colour.a < 1;
  surface.edges = false;
  return surface;
}

// Looks along -y at the origin; nothing but the solids on white.
Picture plain_picture() {
  Picture picture;
  picture.surroundings.show_grid = picture.surroundings.show_axes = false;
  picture.surroundings.show_shadow = false;
  picture.surroundings.background_top = picture.surroundings.background_bottom = {1, 1, 1, 1};
  picture.camera.azimuth = 1.5707963;
  picture.camera.elevation = 0;
  picture.camera.distance = 10;
  return picture;
}

const Colour red{1, 0, 0, 1}, half_blue{0, 0, 1, 0.5f}, half_green{0, 1, 0, 0.5f};

Camera some_camera(std::mt19937& random) {
  std::uniform_real_distribution<double> u(-1, 1);
  Camera camera;
  camera.target = {3 * u(random), 3 * u(random), 3 * u(random)};
  camera.distance = 6 + 4 * u(random);
  camera.azimuth = 3 * u(random);
  camera.elevation = 1.4 * u(random);
  camera.orthographic = u(random) > 0;
  return camera;
}

TEST(Renderer, DrawsAgainWhateverChanged) {
  const auto context = make_offscreen_context(width, height);
  Renderer renderer(*context);
  Picture picture = plain_picture();
  picture.surfaces = {surface_of(block({-1, -1, -1}, {1, 1, 1}), red)};
  const Image first = drawn(renderer, picture);
  EXPECT_EQ(drawn(renderer, picture).rgba, first.rgba);
  const auto expect_change = [&](const char* what, const Picture& changed) {
    const Image second = drawn(renderer, changed);
    EXPECT_EQ(second.rgba, drawn(changed).rgba) << what;
    EXPECT_NE(second.rgba, first.rgba) << what;
    EXPECT_EQ(drawn(renderer, picture).rgba, first.rgba) << what;
  };
  Picture changed = picture;
  changed.camera.orbit(0.3, 0.2);
  expect_change("camera", changed);
  changed = picture;
  changed.surfaces[0].colour = {0, 1, 0, 1};
  expect_change("colour", changed);
  changed = picture;
  changed.surfaces[0].model[3].x = 0.5;
  expect_change("place", changed);
  changed = picture;
  changed.points.push_back({{{0, 2, 0}}, {0, 0, 1, 1}, 8, true});
  expect_change("mark", changed);
  changed = picture;
  changed.section = {true, {1, 0, 0, 0}};
  expect_change("section", changed);
}

TEST(Renderer, BackFacesOfClosedSurfacesMakeNoDifference) {
  Picture picture = plain_picture();
  picture.quality = Quality::fast;
  picture.camera.orbit(0.5, 0.4);
  picture.surfaces = {surface_of(block({-1, -1, -1}, {1, 1, 1}), red)};
  picture.surfaces[0].model[0].x = -1;  // mirrored
  ASSERT_TRUE(picture.surfaces[0].mesh->closed);
  Picture open = picture;
  auto mesh = std::make_shared<SurfaceMesh>(*picture.surfaces[0].mesh);
  mesh->closed = false;
  open.surfaces[0].mesh = mesh;
  // On the silhouette rounding may put a back face in front.
  EXPECT_LT(compare_images(drawn(picture), drawn(open)).share, 0.002);
  picture.section = open.section = {true, {0, 1, 0, 0}};
  EXPECT_EQ(drawn(picture).rgba, drawn(open).rgba);
}

TEST(Camera, RaysPassThroughWhatIsProjected) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> u(-1, 1);
  const glm::dvec2 size(800, 500);
  for (int i = 0; i < 200; ++i) {
    const Camera camera = some_camera(random);
    const glm::dvec3 point = camera.target + glm::dvec3(u(random), u(random), u(random));
    const glm::dvec3 on_screen = camera.project(point, size);
    const Ray ray = camera.ray(glm::dvec2(on_screen), size);
    EXPECT_NEAR(glm::length(ray.direction), 1, 1e-12);
    const glm::dvec3 to_point = point - ray.origin;
    EXPECT_NEAR(glm::length(glm::cross(to_point, ray.direction)), 0, 1e-9);
    EXPECT_GT(glm::dot(to_point, ray.direction), 0);
  }
}

TEST(Camera, MatricesAgreeWithProject) {
  std::mt19937 random(2);
  const glm::dvec2 size(640, 400);
  for (int i = 0; i < 50; ++i) {
    const Camera camera = some_camera(random);
    const glm::dvec3 point = camera.target + glm::dvec3(0.3, -0.2, 0.5);
    Bounds bounds;
    bounds.add(camera.target - 2.0);
    bounds.add(camera.target + 2.0);
    const glm::dvec4 clip = camera.projection(1.6, bounds) * camera.view() * glm::dvec4(point, 1);
    const glm::dvec3 expected = camera.project(point, size);
    EXPECT_NEAR((clip.x / clip.w + 1) / 2 * size.x, expected.x, 1e-8);
    EXPECT_NEAR((1 - clip.y / clip.w) / 2 * size.y, expected.y, 1e-8);
    EXPECT_LT(std::abs(clip.z / clip.w), 1);
  }
}

TEST(Camera, OrbitKeepsTargetInTheMiddleAndNeverTurnsOver) {
  Camera camera;
  camera.target = {1, 2, 3};
  const glm::dvec2 size(800, 600);
  for (int i = 0; i < 100; ++i) {
    camera.orbit(0.37, 0.11);
    const glm::dvec3 middle = camera.project({1, 2, 3}, size);
    EXPECT_NEAR(middle.x, 400, 1e-9);
    EXPECT_NEAR(middle.y, 300, 1e-9);
    EXPECT_NEAR(middle.z, camera.distance, 1e-9);
    EXPECT_GT(camera.up().z, 0);
  }
}

TEST(Camera, PanAndZoomKeepWhatIsUnderTheMouse) {
  std::mt19937 random(3);
  const glm::dvec2 size(800, 600), pixel(123, 456);
  for (int i = 0; i < 50; ++i) {
    Camera camera = some_camera(random);
    const glm::dvec3 target = camera.target;
    camera.pan({50, -20}, size);
    EXPECT_NEAR(camera.project(target, size).x, 450, 1e-8);
    EXPECT_NEAR(camera.project(target, size).y, 280, 1e-8);

    const Ray ray = camera.ray(pixel, size);
    const double along = glm::dot(camera.target - ray.origin, camera.forward()) /
                         glm::dot(ray.direction, camera.forward());
    const glm::dvec3 under = ray.origin + ray.direction * along;
    camera.zoom(0.7, pixel, size);
    EXPECT_NEAR(camera.project(under, size).x, pixel.x, 1e-8);
    EXPECT_NEAR(camera.project(under, size).y, pixel.y, 1e-8);
  }
}

TEST(Camera, LookAtShowsAllCorners) {
  std::mt19937 random(4);
  Bounds bounds;
  bounds.add(glm::dvec3(-1, -5, 0));
  bounds.add(glm::dvec3(4, 2, 1));
  for (int i = 0; i < 50; ++i) {
    Camera camera = some_camera(random);
    camera.look_at(bounds, 1.6);
    for (int corner = 0; corner < 8; ++corner) {
      const glm::dvec3 p(corner & 1 ? 4 : -1, corner & 2 ? 2 : -5, corner & 4 ? 1 : 0);
      const glm::dvec3 seen = camera.project(p, {1600, 1000});
      EXPECT_TRUE(seen.x > 0 && seen.x < 1600 && seen.y > 0 && seen.y < 1000);
    }
  }
}

TEST(SurfaceMesh, BlockHasTwelveHardEdges) {
  const auto mesh = surface_mesh(block({0, 0, 0}, {1, 2, 3}));
  EXPECT_EQ(mesh->faces.size(), 12u);
  EXPECT_EQ(mesh->hard_edges.size(), 24u);
  EXPECT_EQ(mesh->bounds.high, glm::dvec3(1, 2, 3));
}

TEST(SurfaceMesh, NormalsPointOutwards) {
  const auto mesh = surface_mesh(sphere(1, 16, 8));
  for (std::size_t i = 0; i < mesh->positions.size(); ++i)
    EXPECT_GT(glm::dot(mesh->positions[i], mesh->normals[i]), 0);
}

TEST(SurfaceMesh, PartsWithHolesAreTriangulatedWhole) {
  const Solid plate = block({-2, -2, -1}, {2, 2, 1}), rod = cylinder(1, 4, 24);
  const Solid moved = transformed(rod, Transform::translation({0, 0, -2}));
  const SurfacePart part = classify(plate, moved).a_out_b;
  const auto mesh = surface_mesh(part);
  double area = 0;
  for (std::size_t t = 0; t < mesh->faces.size(); ++t) {
    const glm::vec3* p = &mesh->positions[3 * t];
    const glm::vec3 n = glm::cross(p[1] - p[0], p[2] - p[0]);
    EXPECT_GT(glm::dot(n, mesh->normals[3 * t]), 0);
    area += 0.5 * static_cast<double>(glm::length(n));
  }
  EXPECT_NEAR(area, part.area, 1e-4);
  // Twelve edges of the plate, two rings of 24.
  EXPECT_EQ(mesh->hard_edges.size(), 2u * (12 + 48));
}

TEST(PolygonEars, TakesTwoHolesAndCornersInLine) {
  const std::vector<glm::dvec2> places = {{0, 0}, {5, 0}, {10, 0}, {10, 6}, {0, 6}, {1, 1}, {1, 4},
                                          {4, 4}, {4, 1}, {6, 2},  {6, 5},  {9, 5}, {9, 2}};
  double area = 0;
  for (const auto& [a, b, c] : ears(places, {{0, 1, 2, 3, 4}, {5, 6, 7, 8}, {9, 10, 11, 12}})) {
    const glm::dvec2 u = places[b] - places[a], v = places[c] - places[a];
    EXPECT_GE(u.x * v.y - u.y * v.x, 0);
    area += 0.5 * (u.x * v.y - u.y * v.x);
  }
  EXPECT_DOUBLE_EQ(area, 60 - 9 - 9);
}

TEST(Renderer, OpaqueSolidHidesWhatIsBehind) {
  Picture picture = plain_picture();
  picture.surfaces.push_back(surface_of(block({-1, -3, -1}, {1, -2, 1}), {0, 1, 0, 1}));
  picture.surfaces.push_back(surface_of(block({-1, 2, -1}, {1, 3, 1}), red));
  const Rgb middle = at(drawn(picture), width / 2, height / 2);
  EXPECT_GT(middle.r, 150);
  EXPECT_EQ(middle.g, 0);
}

TEST(Renderer, TranslucentCubeLetsTheOpaqueOneThrough) {
  for (const Quality quality : {Quality::fast, Quality::full}) {
    Picture picture = plain_picture();
    picture.quality = quality;
    picture.surfaces.push_back(surface_of(block({-1.5, -1.5, -1.5}, {1.5, 1.5, 1.5}), half_blue));
    picture.surfaces.push_back(surface_of(block({-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}), red));
    const Image image = drawn(picture);
    const Rgb inner = at(image, width / 2, height / 2);       // one layer of blue over red
    const Rgb outer = at(image, width / 2 - 45, height / 2);  // two over white
    EXPECT_GT(inner.r, 80);
    EXPECT_GT(inner.b, 80);
    EXPECT_EQ(inner.g, 0);
    EXPECT_NEAR(outer.r, 64, 3);
    EXPECT_GT(outer.b, outer.r + 80);
  }
}

// Where two translucent bodies interpenetrate no order of bodies is right; layers are.
TEST(Renderer, LayersOfInterpenetratingBodiesAreInOrder) {
  for (const Quality quality : {Quality::fast, Quality::full}) {
    Picture picture = plain_picture();
    picture.quality = quality;
    // Along the line of sight: green's front, blue's front, green's back, blue's back.
    picture.surfaces.push_back(surface_of(block({-1, -2, -1}, {1, 1, 1}), half_blue));
    picture.surfaces.push_back(surface_of(block({-1, -1, -1}, {1, 2, 1}), half_green));
    const Rgb middle = at(drawn(picture), width / 2, height / 2);
    // Shares of green and blue in back-to-front blending are 1/2 + 1/8 and 1/4 + 1/16.
    const double ratio = static_cast<double>(middle.g) / middle.b;
    EXPECT_GT(ratio, 1.5) << "quality " << static_cast<int>(quality);
    std::swap(picture.surfaces[0], picture.surfaces[1]);
    const Rgb swapped = at(drawn(picture), width / 2, height / 2);
    EXPECT_NEAR(swapped.g, middle.g, 1);
    EXPECT_NEAR(swapped.b, middle.b, 1);
  }
}

TEST(Renderer, SectionCutsAwayThePositiveSide) {
  Picture picture = plain_picture();
  picture.surfaces.push_back(surface_of(block({-1.5, -1, -1}, {1.5, 1, 1}), red));
  picture.section = {true, {1, 0, 0, 0}};
  const Image image = drawn(picture);
  // The camera looks along -y: +x is on its left.
  EXPECT_EQ(at(image, width / 2 - 20, height / 2).g, 255);
  EXPECT_EQ(at(image, width / 2 + 20, height / 2).g, 0);
}

TEST(Renderer, EdgesAreWholeOnTheirFaces) {
  Picture picture = plain_picture();
  picture.camera.azimuth = 0.9;
  picture.camera.elevation = 0.5;
  picture.surfaces.push_back(surface_of(block({-1, -1, -1}, {1, 1, 1}), {1, 1, 1, 1}));
  picture.surfaces[0].edges = true;
  picture.surroundings.edge = {0, 0, 0, 1};
  const Image image = drawn(picture);
  // Along the three edges that meet in the nearest corner.
  const glm::dvec3 corner(1, 1, 1);
  for (int axis = 0; axis < 3; ++axis) {
    for (double t = 0.1; t < 1.9; t += 0.02) {
      glm::dvec3 p = corner;
      p[axis] -= t;
      const glm::dvec3 pixel = picture.camera.project(p, {width, height});
      EXPECT_LT(at(image, static_cast<int>(pixel.x), static_cast<int>(pixel.y)).g, 150)
          << axis << ' ' << t;
    }
  }
}

TEST(Renderer, HighlightedSurfaceIsOutlined) {
  Picture picture = plain_picture();
  picture.surfaces.push_back(surface_of(block({-1, -1, -1}, {1, 1, 1}), red));
  picture.surfaces[0].highlighted = true;
  picture.surroundings.outline = {0, 0, 1, 1};
  const Image image = drawn(picture);
  int blue = 0;
  for (int x = 0; x < width; ++x) {
    const Rgb pixel = at(image, x, height / 2);
    if (pixel.b > 200 && pixel.r < 60) ++blue;
  }
  EXPECT_GE(blue, 4);
  EXPECT_LE(blue, 10);
}

TEST(Renderer, MarksOnTopShowThroughSurfaces) {
  for (const bool on_top : {false, true}) {
    Picture picture = plain_picture();
    picture.surfaces.push_back(surface_of(block({-1, -1, -1}, {1, 1, 1}), red));
    picture.lines.push_back({{{-3, -2, 0}, {3, -2, 0}}, {0, 0, 1, 1}, 6, on_top});
    const Image image = drawn(picture);
    const Rgb covered = at(image, width / 2, height / 2);
    const Rgb beside = at(image, width / 2 - 60, height / 2);
    EXPECT_GT(beside.b, beside.r + 200);
    if (on_top)
      EXPECT_GT(covered.b, 40);
    else
      EXPECT_EQ(covered.b, 0);
  }
}

TEST(Renderer, IsDeterministicToThePixel) {
  for (DemoPicture& demo : demo_pictures()) {
    const Image once = drawn(demo.picture);
    const Image twice = drawn(demo.picture);
    EXPECT_EQ(once.rgba, twice.rgba) << demo.name;
  }
}

TEST(Renderer, SwitchesBetweenContexts) {
  Picture picture = plain_picture();
  picture.surfaces.push_back(surface_of(block({-1, -1, -1}, {1, 1, 1}), red));
  const auto first_context = make_offscreen_context(width, height);
  auto second_context = make_offscreen_context(width, height);
  Renderer first(*first_context);
  auto second = std::make_unique<Renderer>(*second_context);
  const Image a = drawn(first, picture), b = drawn(*second, picture), c = drawn(first, picture);
  EXPECT_EQ(a.rgba, b.rgba);
  EXPECT_EQ(a.rgba, c.rgba);
  second.reset();
  second_context.reset();
  EXPECT_EQ(a.rgba, drawn(first, picture).rgba);
}

TEST(Renderer, BuffersFollowTheirMeshes) {
  const auto context = make_offscreen_context(width, height);
  Renderer renderer(*context);
  Picture picture = plain_picture();
  for (int i = 0; i < 20; ++i) {
    // A new mesh may lie where the last one was.
    picture.surfaces.clear();
    const double size = i % 2 ? 1.0 : 0.2;
    picture.surfaces.push_back(surface_of(block({-size, -size, -size}, {size, size, size}), red));
    const Rgb beside = at(drawn(renderer, picture), width / 2 - 25, height / 2);
    EXPECT_EQ(beside.g, i % 2 ? 0 : 255);
  }
}

TEST(Renderer, DrawsTheInterfaceOverThePicture) {
  const auto context = make_offscreen_context(width, height, 2);
  Renderer renderer(*context);
  ImGui::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.DisplaySize = {width / 2.0f, height / 2.0f};
  io.DisplayFramebufferScale = {2, 2};
  for (int round = 0; round < 2; ++round) {
    // The second time the font atlas was built anew.
    io.Fonts->Clear();
    ImFontConfig config;
    config.FontDataOwnedByAtlas = false;
    const std::string_view font = embedded_file("Inter-Regular.otf");
    io.Fonts->AddFontFromMemoryTTF(const_cast<char*>(font.data()), static_cast<int>(font.size()),
                                   30, &config);
    io.Fonts->Build();
    io.Fonts->SetTexID(nullptr);
    ImGui::NewFrame();
    ImDrawList& list = *ImGui::GetForegroundDrawList();
    list.AddRectFilled({10, 10}, {60, 50}, IM_COL32(0, 128, 0, 255));
    list.AddText({80, 20}, IM_COL32(0, 0, 0, 255), "HHH");
    list.PushClipRect({100, 80}, {110, 90});
    list.AddRectFilled({0, 60}, {160, 120}, IM_COL32(0, 0, 255, 128));
    list.PopClipRect();
    ImGui::Render();
    renderer.begin_frame();
    renderer.draw(plain_picture(), {0, 0, width, height});
    renderer.draw(*ImGui::GetDrawData());
    const Image image = renderer.read_frame();
    EXPECT_EQ(at(image, 70, 60).g, 128);
    EXPECT_EQ(at(image, 70, 60).r, 0);
    EXPECT_EQ(at(image, 70, 110).r, 255);
    EXPECT_NEAR(at(image, 210, 170).r, 127, 1);
    EXPECT_EQ(at(image, 190, 170).r, 255);
    int dark = 0;
    for (int y = 40; y < 100; ++y)
      for (int x = 160; x < 240; ++x) dark += at(image, x, y).r < 100;
    EXPECT_GT(dark, 200);
    EXPECT_LT(dark, 2000);
  }
  ImGui::DestroyContext();
}

// On a machine without OSMesa the two are one.
TEST(OffscreenContext, EglDrawsAsOsmesaDoes) {
  const Picture picture = demo_pictures().front().picture;
  const auto drawn_in = [&](GraphicsContext& context) {
    Renderer renderer(context);
    renderer.begin_frame();
    renderer.draw(picture, {0, 0, 320, 240});
    return renderer.read_frame();
  };
  const auto chosen = make_offscreen_context(320, 240), egl = make_egl_context(320, 240);
  const Image by_egl = drawn_in(*egl);
  EXPECT_LT(compare_images(drawn_in(*chosen), by_egl).share, 0.001);
  EXPECT_EQ(drawn_in(*egl).rgba, by_egl.rgba) << "the contexts take turns";
}

TEST(OffscreenContext, RefusesImpossibleSizes) {
  EXPECT_THROW(make_offscreen_context(0, 100), std::runtime_error);
  EXPECT_THROW(make_offscreen_context(100, 100000), std::runtime_error);
  EXPECT_THROW(make_egl_context(0, 100), std::runtime_error);
}

TEST(Embedded, HoldsFontsAndShaders) {
  EXPECT_EQ(embedded_file("surface.vert").substr(0, 8), "#version");
  EXPECT_GT(embedded_file("Inter-Regular.otf").size(), 100000u);
  EXPECT_THROW(embedded_file("missing"), std::out_of_range);
}

class PngTest : public testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(folder_); }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  const std::filesystem::path folder_ =
      std::filesystem::path(testing::TempDir()) /
      (std::string("png-") + testing::UnitTest::GetInstance()->current_test_info()->name());
};

TEST_F(PngTest, ComesBackAsItWas) {
  Image image{3, 2, {}};
  for (int i = 0; i < 24; ++i) image.rgba.push_back(static_cast<std::uint8_t>(i * 10));
  const std::string path = (folder_ / "a.png").string();
  write_png(path, image);
  const Image read = read_png(path);
  EXPECT_EQ(read.width, 3);
  EXPECT_EQ(read.height, 2);
  EXPECT_EQ(read.rgba, image.rgba);
}

TEST_F(PngTest, ReportsWhatCannotBeDone) {
  const Image image{1, 1, {1, 2, 3, 255}};
  EXPECT_THROW(write_png((folder_ / "no" / "a.png").string(), image), std::runtime_error);
  EXPECT_THROW(write_png((folder_ / "b.png").string(), Image{2, 2, {0}}), std::runtime_error);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "b.png"));
  EXPECT_THROW(read_png((folder_ / "b.png").string()), std::runtime_error);
  std::ofstream(folder_ / "c.png") << "no picture";
  EXPECT_THROW(read_png((folder_ / "c.png").string()), std::runtime_error);
}

TEST(ImageDifference, ToleratesNoiseButNotShapes) {
  Image grey{64, 64, std::vector<std::uint8_t>(64 * 64 * 4, 128)};
  EXPECT_EQ(compare_images(grey, grey).mean, 0);
  Image noisy = grey;
  std::mt19937 random(5);
  for (std::uint8_t& value : noisy.rgba)
    value = static_cast<std::uint8_t>(value + static_cast<int>(random() % 9) - 4);
  EXPECT_EQ(compare_images(grey, noisy).share, 0);
  Image square = grey;
  for (std::size_t y = 10; y < 20; ++y)
    for (std::size_t x = 30; x < 40; ++x) square.rgba[(y * 64 + x) * 4] = 255;
  const ImageDifference difference = compare_images(grey, square);
  EXPECT_NEAR(difference.share, 100.0 / (64 * 64), 60.0 / (64 * 64));
  EXPECT_GT(at(difference.picture, 35, 15).r, at(difference.picture, 35, 15).g + 50);
  EXPECT_EQ(at(difference.picture, 5, 50).r, at(difference.picture, 5, 50).g);
  EXPECT_EQ(compare_images(grey, Image{1, 1, {0, 0, 0, 255}}).share, 1);
}

}  // namespace
}  // namespace sectile::viewer
