#include "arrangement/face_locator.h"

#include "numbers/threshold.h"

namespace sectile::arrangement {
namespace {

// The rounded corners of a face, loop after loop, and where the loops end.
struct RoundedCorners {
  std::vector<Vec3> corners;
  std::vector<std::uint32_t> loop_ends;

  void read(const Facets& facets, std::size_t f, const Geometry& geometry) {
    const Polygons& polygons = facets.polygons;
    corners.clear();
    loop_ends.clear();
    for (std::uint32_t c = facets.begin(f); c < facets.end(f); ++c)
      corners.push_back(geometry.position(facets.from(c)));
    for (std::uint32_t l = polygons.first_loop(f); l < polygons.face_end[f]; ++l)
      loop_ends.push_back(polygons.loop_end[l] - facets.begin(f));
  }
};

}  // namespace

FaceLocator::FaceLocator(const Facets& facets, const EdgeLines& lines,
                         const std::vector<std::uint8_t>& wanted, const Kernel& kernel)
    : facets_(facets), lines_(lines), kernel_(kernel), outlines_(facets.face_count()) {
  constexpr std::uint32_t many = threshold(32, 1);
  RoundedCorners rounded;
  for (std::size_t f = 0; f < facets.face_count(); ++f) {
    if (!wanted[f] || facets.size(f) < many) continue;
    rounded.read(facets, f, kernel.geometry());
    outlines_[f] = std::make_unique<OutlineTree>(rounded.corners, rounded.loop_ends,
                                                 kernel.main_axis(facets.plane[f]));
  }
}

OutlineTree::Target FaceLocator::as_target(std::uint32_t face) const {
  if (const OutlineTree* outline = outlines_[face].get()) return outline->as_target();
  RoundedCorners rounded;
  rounded.read(facets_, face, kernel_.geometry());
  return OutlineTree::Target(rounded.corners);
}

}  // namespace sectile::arrangement
