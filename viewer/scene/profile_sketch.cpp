#include "scene/profile_sketch.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <stdexcept>

#include "scene/primitive_kind.h"
#include "scene/transforms.h"

namespace sectile::viewer {
namespace {

double doubled_area(const Loop& loop) {
  double area = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec2& a = loop[i];
    const Vec2& b = loop[(i + 1) % loop.size()];
    area += a.x * b.y - b.x * a.y;
  }
  return area;
}

}  // namespace

SketchSide side_between(const Vec2& from, const Vec2& to) {
  const double x = to.x - from.x, y = to.y - from.y;
  return {std::hypot(x, y), glm::degrees(std::atan2(y, x))};
}

Vec2 end_of(const Vec2& from, const SketchSide& side) {
  // Turned exactly where that can be done.
  const Vec3 way = Transform::rotation_degrees({0, 0, 1}, side.degrees)({side.length, 0, 0});
  return {from.x + way.x, from.y + way.y};
}

ProfileSketch::ProfileSketch(const Profile& profile) {
  if (!profile.outer.empty()) now_.loops.push_back(profile.outer);
  now_.loops.insert(now_.loops.end(), profile.holes.begin(), profile.holes.end());
}

Vec2 ProfileSketch::before(const Corner& corner) const {
  const Loop& loop = now_.loops.at(corner.loop);
  return loop.at((corner.corner + loop.size() - 1) % loop.size());
}

void ProfileSketch::add_corner(const Vec2& place) {
  const Loop& drawn = now_.drawn;
  if (!drawn.empty() && drawn.back().x == place.x && drawn.back().y == place.y) return;
  keep();
  now_.drawn.push_back(place);
}

bool ProfileSketch::close() {
  if (now_.drawn.size() < 3) return false;
  keep();
  now_.loops.push_back(std::move(now_.drawn));
  now_.drawn.clear();
  return true;
}

void ProfileSketch::add_loop(Loop loop) {
  keep();
  now_.loops.push_back(std::move(loop));
}

void ProfileSketch::move(const Corner& corner, const Vec2& place) {
  keep();
  now_.loops.at(corner.loop).at(corner.corner) = place;
}

void ProfileSketch::insert_before(const Corner& corner, const Vec2& place) {
  keep();
  Loop& loop = now_.loops.at(corner.loop);
  loop.insert(loop.begin() + static_cast<std::ptrdiff_t>(corner.corner), place);
}

void ProfileSketch::remove(const Corner& corner) {
  if (now_.loops.at(corner.loop).size() <= 3) return remove_loop(corner.loop);
  keep();
  Loop& loop = now_.loops[corner.loop];
  loop.erase(loop.begin() + static_cast<std::ptrdiff_t>(corner.corner));
}

void ProfileSketch::remove_loop(std::size_t loop) {
  keep();
  now_.loops.erase(now_.loops.begin() + static_cast<std::ptrdiff_t>(loop));
}

void ProfileSketch::undo() {
  if (before_.empty()) return;
  now_ = std::move(before_.back());
  before_.pop_back();
  moving_ = false;
}

Profile ProfileSketch::profile() const {
  Profile made;
  std::size_t outer = 0;
  for (std::size_t i = 1; i < now_.loops.size(); ++i)
    if (std::abs(doubled_area(now_.loops[i])) > std::abs(doubled_area(now_.loops[outer])))
      outer = i;
  for (std::size_t i = 0; i < now_.loops.size(); ++i) {
    if (i == outer)
      made.outer = now_.loops[i];
    else
      made.holes.push_back(now_.loops[i]);
  }
  return made;
}

std::string ProfileSketch::problem(Primitive primitive) const {
  if (now_.drawn.size() >= 3)
    return "Close the outline being drawn: click its first corner, or press Enter.";
  if (now_.loops.empty() || !now_.drawn.empty())
    return "Draw the outline: click its corners one after the other, the first one again to close "
           "it.";
  primitive.profile = profile();
  try {
    solid_of(primitive);
  } catch (const std::exception& error) {
    return error.what();
  }
  return {};
}

Loop rectangle_loop(const Vec2& centre, double width, double height) {
  const double x = 0.5 * width, y = 0.5 * height;
  return {{centre.x - x, centre.y - y},
          {centre.x + x, centre.y - y},
          {centre.x + x, centre.y + y},
          {centre.x - x, centre.y + y}};
}

Loop circle_loop(const Vec2& centre, double radius, std::uint32_t corners) {
  Loop made;
  for (std::uint32_t i = 0; i < corners; ++i)
    made.push_back(end_of(centre, {radius, 360.0 * i / corners}));
  return made;
}

Placement placement_on_plane(const Vec3& point, const Vec3& normal) {
  const glm::dvec3 n = to_glm(normal), p = to_glm(point);
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(n[axis]) < 1 - 1e-12) continue;
    glm::dvec3 origin(0);
    origin[axis] = p[axis];
    const bool plus = n[axis] > 0;
    const Vec3 rotation = axis == 0   ? Vec3{0, plus ? 90.0 : -90.0, 0}
                          : axis == 1 ? Vec3{plus ? -90.0 : 90.0, 0, 0}
                                      : Vec3{plus ? 0.0 : 180.0, 0, 0};
    return {from_glm(origin), rotation, {1, 1, 1}};
  }
  const glm::dvec3 axis = glm::cross(glm::dvec3(0, 0, 1), n);
  Placement made = Placement::of(Transform::rotation_degrees(
      from_glm(glm::normalize(axis)), glm::degrees(std::atan2(glm::length(axis), n.z))));
  made.position = from_glm(n * glm::dot(n, p));
  return made;
}

}  // namespace sectile::viewer
