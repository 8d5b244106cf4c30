#include <algorithm>

#include "primitives/arguments.h"
#include "primitives/profile.h"
#include "primitives/soup_builder.h"

namespace sectile {

namespace {

using Ring = std::vector<std::uint32_t>;

Ring add_ring(SoupBuilder& soup, const ProfileLoop& loop, double z) {
  Ring ring;
  ring.reserve(loop.size());
  for (const Vec2& p : loop) ring.push_back(soup.add_position({p.x, p.y, z}));
  return ring;
}

// Pairs of corners above each other: these quadrilaterals are exactly planar.
void add_walls(SoupBuilder& soup, const Ring& bottom, const Ring& top) {
  for (std::size_t i = 0; i < bottom.size(); ++i) {
    const std::size_t j = (i + 1) % bottom.size();
    soup.add_face({bottom[i], bottom[j], top[j], top[i]});
  }
}

}  // namespace

Solid extrude(const Profile& profile, double height) {
  require_length(height, "height");
  const std::vector<ProfileLoop> loops = mended_loops(profile);
  std::uint64_t corners = 0;
  for (const ProfileLoop& loop : loops) corners += loop.size();
  require_size(2 * corners);

  SoupBuilder soup;
  std::vector<Ring> bottoms, tops;
  for (const ProfileLoop& loop : loops) {
    bottoms.push_back(add_ring(soup, loop, 0));
    tops.push_back(add_ring(soup, loop, height));
    add_walls(soup, bottoms.back(), tops.back());
  }
  soup.add_face(tops);
  for (Ring& ring : bottoms) std::reverse(ring.begin(), ring.end());
  soup.add_face(bottoms);
  return soup.solid();
}

}  // namespace sectile
