// What the renderer makes of a picture, pixel by pixel.
#include "render/renderer.h"

#include <gtest/gtest.h>

#include <memory>
#include <utility>

#include "demo_pictures.h"
#include "drawn_pictures.h"
#include "picture/surface_mesh.h"
#include "render/image_difference.h"
#include "sectile/primitives.h"

namespace sectile::viewer {
namespace {

const Colour red{1, 0, 0, 1}, half_blue{0, 0, 1, 0.5f}, half_green{0, 1, 0, 0.5f};

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

}  // namespace
}  // namespace sectile::viewer
