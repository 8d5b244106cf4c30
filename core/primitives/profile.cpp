#include "primitives/profile.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "numbers/dyadic.h"
#include "primitives/arguments.h"

namespace sectile {

namespace {

bool same(const Vec2& a, const Vec2& b) {
  return a.x == b.x && a.y == b.y;
}

ProfileLoop without_repeats(ProfileLoop loop) {
  loop.erase(std::unique(loop.begin(), loop.end(), same), loop.end());
  while (loop.size() > 1 && same(loop.front(), loop.back())) loop.pop_back();
  return loop;
}

Sign orientation(const ProfileLoop& loop) {
  Dyadic twice_area;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec2& a = loop[i];
    const Vec2& b = loop[(i + 1) % loop.size()];
    twice_area = twice_area + Dyadic(a.x) * Dyadic(b.y) - Dyadic(b.x) * Dyadic(a.y);
  }
  return twice_area.sign();
}

ProfileLoop mended(const ProfileLoop& given, Sign wanted, const std::string& name) {
  for (std::size_t i = 0; i < given.size(); ++i)
    require(std::isfinite(given[i].x) && std::isfinite(given[i].y),
            "Corner " + std::to_string(i) + " of " + name + " is not finite.");
  ProfileLoop loop = without_repeats(given);
  require(loop.size() >= 3, "The profile needs at least three different corners in " + name + ".");
  const Sign found = orientation(loop);
  require(found != Sign::zero, "The profile has no area in " + name + ".");
  if (found != wanted) std::reverse(loop.begin(), loop.end());
  return loop;
}

}  // namespace

std::vector<ProfileLoop> mended_loops(const Profile& profile) {
  std::vector<ProfileLoop> loops;
  loops.push_back(mended(profile.outer, Sign::positive, "the outer loop"));
  for (std::size_t i = 0; i < profile.holes.size(); ++i)
    loops.push_back(mended(profile.holes[i], Sign::negative, "hole " + std::to_string(i)));
  return loops;
}

}  // namespace sectile
