// How solids look: edges by angle, bent surfaces, light and shadow, outlines, grids.
#include <gtest/gtest.h>

#include <algorithm>

#include "picture/surface_mesh.h"
#include "picture/theme.h"
#include "render/renderer.h"
#include "sectile/primitives.h"

namespace sectile::viewer {
namespace {

constexpr int width = 320, height = 240;

Image drawn(const Picture& picture) {
  const auto context = make_osmesa_context(width, height);
  Renderer renderer(*context);
  renderer.begin_frame();
  renderer.draw(picture, {0, 0, width, height});
  return renderer.read_frame();
}

const std::uint8_t* pixel(const Image& image, int x, int y) {
  return &image.rgba[static_cast<std::size_t>(4 * (y * image.width + x))];
}

// The middle of a place's pixel, red channel.
int red_at(const Image& image, const Camera& camera, const glm::dvec3& place) {
  const glm::dvec3 at = camera.project(place, {width, height});
  return *pixel(image, static_cast<int>(at.x), static_cast<int>(at.y));
}

Surface surface_of(const Solid& solid) {
  Surface surface;
  surface.mesh = surface_mesh(solid);
  surface.colour = {0.8f, 0.8f, 0.8f, 1};
  return surface;
}

Picture picture_of(std::vector<Surface> surfaces, Quality quality = Quality::full) {
  Picture picture;
  picture.surfaces = std::move(surfaces);
  picture.quality = quality;
  picture.surroundings = theme(false).surroundings;
  picture.surroundings.show_grid = picture.surroundings.show_axes = false;
  picture.surroundings.show_shadow = false;
  picture.camera.look_at(picture.bounds(), double{width} / height);
  return picture;
}

TEST(Edges, OfRoundThingsAreSmooth) {
  const auto ball = surface_mesh(sphere(1, 48, 25));
  EXPECT_TRUE(ball->hard_edges.empty());
  EXPECT_FALSE(ball->smooth_edges.empty());
  // The rims of a cylinder are hard, its sides are not.
  const auto rod = surface_mesh(cylinder(1, 2, 36));
  EXPECT_EQ(rod->hard_edges.size(), 2u * 72);
  EXPECT_EQ(rod->smooth_edges.size(), 2u * 36);
  // Eight sides are meant to be seen.
  EXPECT_EQ(surface_mesh(cylinder(1, 2, 8))->hard_edges.size(), 2u * 24);
}

TEST(Edges, NormalsAreSharedAcrossSmoothOnesOnly) {
  const auto rod = surface_mesh(cylinder(1, 2, 36));
  for (std::size_t i = 0; i < rod->positions.size(); ++i) {
    const glm::vec3 p = rod->positions[i], n = rod->normals[i];
    const glm::vec3 out = glm::normalize(glm::vec3(p.x, p.y, 0));
    // On a cap along the axis; on the side exactly outwards, not as each flat piece is.
    EXPECT_TRUE(std::abs(n.z) > 0.9999f || glm::dot(n, out) > 0.9999f) << i;
  }
}

TEST(Edges, BetweenOperandsAreHardHoweverFlat) {
  // A wedge of 6 degrees on a block: bent by less than what is smooth within one solid.
  const Solid base = block({0, 0, 0}, {10, 10, 1}), roof = wedge({0, 0, 0}, {10, 10, 2});
  const auto united = surface_mesh(boolean(base, roof, Operation::unite));
  const auto on_top = [](const glm::vec3& p) { return p.z > 0.9f && p.z < 1.1f; };
  int crossing = 0;
  for (std::size_t i = 0; i < united->hard_edges.size(); i += 2)
    crossing += on_top(united->hard_edges[i]) && on_top(united->hard_edges[i + 1]) &&
                std::abs(united->hard_edges[i].y - united->hard_edges[i + 1].y) > 9.9f;
  EXPECT_GT(crossing, 0);
}

TEST(Edges, BehindFacesAreDrawnOnDemand) {
  Picture picture = picture_of({surface_of(block({-1, -1, -1}, {1, 1, 1}))});
  const Image without = drawn(picture);
  picture.hidden_lines = true;
  const Image with = drawn(picture);
  // Half-way down the edge that is farthest from the eye.
  const glm::dvec3 away = picture.camera.forward();
  const glm::dvec3 hidden(away.x > 0 ? 1 : -1, away.y > 0 ? 1 : -1, -0.4);
  EXPECT_LT(red_at(with, picture.camera, hidden), red_at(without, picture.camera, hidden) - 10);
  Picture faces_only = picture;
  faces_only.hidden_lines = false;
  faces_only.surfaces[0].edges = false;
  EXPECT_EQ(red_at(without, picture.camera, hidden),
            red_at(drawn(faces_only), picture.camera, hidden));
}

TEST(Light, TellsTheTopFromTheSides) {
  for (const Quality quality : {Quality::fast, Quality::full}) {
    const Picture picture = picture_of({surface_of(block({-1, -1, -1}, {1, 1, 1}))}, quality);
    const Image image = drawn(picture);
    const int top = red_at(image, picture.camera, {0, 0, 1}),
              front = red_at(image, picture.camera, {0, -1, 0}),
              side = red_at(image, picture.camera, {1, 0, 0});
    EXPECT_GT(top, front + 25);
    EXPECT_GT(front, side + 25);
    EXPECT_GT(side, 60);
  }
}

TEST(Light, CornersAreDarkerAtRest) {
  const Solid step =
      boolean(block({-1, -1, 0}, {1, 1, 0.2}), block({-1, 0, 0}, {1, 1, 1.2}), Operation::unite);
  Picture picture = picture_of({surface_of(step)});
  const Image rest = drawn(picture);
  picture.quality = Quality::fast;
  const Image moving = drawn(picture);
  const auto darker = [&](const glm::dvec3& place) {
    return red_at(moving, picture.camera, place) - red_at(rest, picture.camera, place);
  };
  EXPECT_GT(darker({0, -0.05, 0.2}), 20) << "at the foot of the wall";
  EXPECT_LT(darker({0, -0.9, 0.2}), 8) << "far from it";
  EXPECT_LT(darker({0, 0.5, 1.2}), 8) << "on top";
}

TEST(Light, SolidsThrowAShadowOnTheGround) {
  Picture picture = picture_of({surface_of(block({-1, -1, 0}, {1, 1, 1}))});
  picture.surroundings.background_top = picture.surroundings.background_bottom = {1, 1, 1, 1};
  picture.camera.distance *= 1.5;
  const glm::dvec3 beside(1.08, 0.3, 0), far_away(2.2, 0.3, 0);
  EXPECT_EQ(red_at(drawn(picture), picture.camera, beside), 255);
  picture.surroundings.show_shadow = true;
  const Image image = drawn(picture);
  EXPECT_LT(red_at(image, picture.camera, beside), 235);
  EXPECT_EQ(red_at(image, picture.camera, far_away), 255);
  EXPECT_EQ(red_at(image, picture.camera, {0.5, 0.5, 1}),
            red_at(drawn(picture_of(picture.surfaces)), picture_of(picture.surfaces).camera,
                   {0.5, 0.5, 1}));
  // A handle is no part of the scene.
  picture.surfaces[0].is_tool = true;
  EXPECT_EQ(red_at(drawn(picture), picture.camera, beside), 255);
}

// How many pixels of a row have the outline's colour.
int outlined_in_row(const Image& image, const Colour& outline, int y, float tolerance = 40) {
  int count = 0;
  for (int x = 0; x < width; ++x) {
    bool same = true;
    for (int c = 0; c < 3; ++c)
      same &= std::abs(pixel(image, x, y)[c] - 255 * outline[c]) < tolerance;
    count += same;
  }
  return count;
}

TEST(Outline, StaysAroundDenseMeshes) {
  for (const Quality quality : {Quality::fast, Quality::full}) {
    Picture picture = picture_of({surface_of(sphere(1, 320, 157))}, quality);
    ASSERT_GT(picture.surfaces[0].mesh->faces.size(), 99000u);
    const Colour& outline = picture.surroundings.outline;
    EXPECT_EQ(outlined_in_row(drawn(picture), outline, height / 2), 0);
    picture.surfaces[0].highlighted = true;
    const int count = outlined_in_row(drawn(picture), outline, height / 2);
    EXPECT_GE(count, 4);
    EXPECT_LE(count, 12);
  }
}

TEST(Outline, OfAnOperandEndsWhereSomethingHidesIt) {
  Surface operand = surface_of(sphere(1, 48, 25));
  operand.colour = {1, 0, 0, 1};
  operand.faces = false;
  operand.silhouette = true;
  Picture picture = picture_of({operand});
  picture.camera.elevation = 0;
  const int open = outlined_in_row(drawn(picture), operand.colour, height / 2, 110);
  EXPECT_GE(open, 2);
  // A wall before it.
  const glm::dvec3 before = -picture.camera.forward() * 2.0;
  Surface wall = surface_of(block({-0.01, -5, -5}, {0.01, 5, 5}));
  const glm::dvec3 x = -picture.camera.forward(), y = picture.camera.right();
  wall.model =
      glm::dmat4(glm::dvec4(x, 0), glm::dvec4(y, 0), glm::dvec4(0, 0, 1, 0), glm::dvec4(before, 1));
  picture.surfaces.push_back(wall);
  EXPECT_EQ(outlined_in_row(drawn(picture), operand.colour, height / 2, 110), 0);
}

TEST(Outline, DoesNotRunAroundHandles) {
  for (const Quality quality : {Quality::fast, Quality::full})
    for (const bool selected : {false, true}) {
      Surface ball = surface_of(sphere(1, 48, 25));
      if (!selected) ball.colour = {1, 0, 0, 1};
      if (selected)
        ball.highlighted = true;
      else
        ball.faces = false, ball.silhouette = true;
      Picture picture = picture_of({ball}, quality);
      picture.camera.elevation = 0;
      const Colour colour = selected ? picture.surroundings.outline : ball.colour;
      const int without = outlined_in_row(drawn(picture), colour, height / 2, 90);
      ASSERT_GE(without, 2);
      Surface handle = surface_of(block({-0.2, -0.2, -0.2}, {0.2, 0.2, 0.2}));
      handle.colour = {0, 0, 1, 1};
      handle.is_tool = true;
      handle.edges = false;
      handle.model[3] = glm::dvec4(-picture.camera.forward() * 2.0, 1);
      picture.surfaces.push_back(handle);
      EXPECT_EQ(outlined_in_row(drawn(picture), colour, height / 2, 90), without)
          << (quality == Quality::fast) << selected;
    }
}

TEST(Tint, IsSeenWhereTheResultIsNot) {
  const Solid whole = block({-1, -1, -1}, {1, 1, 1}), hole = block({-0.5, -0.5, -2}, {0.5, 0.5, 2});
  Surface removed = surface_of(whole);
  removed.colour = {1, 0, 0, 0.5f};
  removed.translucent = removed.yields = true;
  removed.edges = false;
  Picture picture = picture_of({surface_of(boolean(whole, hole, Operation::subtract))});
  const Image without = drawn(picture);
  picture.surfaces.push_back(removed);
  const Image with = drawn(picture);
  const auto green = [&](const Image& image, const glm::dvec3& place) {
    const glm::dvec3 at = picture.camera.project(place, {width, height});
    return pixel(image, static_cast<int>(at.x), static_cast<int>(at.y))[1];
  };
  for (const glm::dvec3 on_result :
       {glm::dvec3(0.75, 0.2, 1), glm::dvec3(1, 0.1, 0.1), glm::dvec3(-0.2, -1, -0.3)})
    EXPECT_EQ(green(with, on_result), green(without, on_result));
  EXPECT_LT(green(with, {0, 0, 1}), green(without, {0, 0, 1}) - 20);
}

TEST(Grid, StandsUprightInSideViews) {
  Picture picture = picture_of({surface_of(block({-1, -1, 0}, {1, 1, 1}))});
  picture.surroundings.show_grid = true;
  for (const double azimuth : {0.0, -1.5707963267948966, 3.141592653589793}) {
    picture.camera.azimuth = azimuth;
    for (const double elevation : {0.0, 0.05}) {
      picture.camera.elevation = elevation;
      const Image image = drawn(picture);
      // Above the block: lines that stand upright are dark in one column and not in the next.
      int steps = 0;
      for (int x = 1; x < width; ++x)
        steps += std::abs(*pixel(image, x, 12) - *pixel(image, x - 1, 12)) > 8;
      if (elevation == 0)
        EXPECT_GT(steps, 3) << azimuth;
      else
        EXPECT_EQ(steps, 0) << azimuth;
    }
  }
}

}  // namespace
}  // namespace sectile::viewer
