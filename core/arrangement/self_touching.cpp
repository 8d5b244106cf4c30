#include "arrangement/self_touching.h"

#include "numbers/threshold.h"
#include "parallel/parallel.h"
#include "search/piece_tree.h"

namespace sectile::arrangement {
namespace {

class TouchTest {
 public:
  TouchTest(const Facets& facets, std::uint32_t face, const Kernel& kernel)
      : facets_(facets),
        face_(face),
        kernel_(kernel),
        axis_(kernel.main_axis(facets.plane[face])) {}

  bool touches() const {
    const std::uint32_t first = facets_.begin(face_), end = facets_.end(face_);
    constexpr std::uint32_t few = threshold(16, 1);
    if (end - first > few) return touches_in_boxes();
    for (std::uint32_t c = first; c < end; ++c)
      for (std::uint32_t d = first; d < end; ++d)
        if (is_within(facets_.from(d), c)) return true;
    return false;
  }

 private:
  bool touches_in_boxes() const {
    const Geometry& g = kernel_.geometry();
    std::vector<PieceTree::Edge> corners, edges;
    const std::uint32_t first = facets_.begin(face_);
    for (std::uint32_t c = first; c < facets_.end(face_); ++c) {
      corners.push_back({g.position(facets_.from(c)), g.position(facets_.from(c))});
      edges.push_back({g.position(facets_.from(c)), g.position(facets_.to(c))});
    }
    bool found = false;
    PieceTree::overlaps(PieceTree(corners), PieceTree(edges),
                        [&](std::uint32_t i, std::uint32_t j) {
                          found = found || is_within(facets_.from(first + i), first + j);
                        });
    return found;
  }

  // Does a corner lie strictly between the ends of the edge that leaves corner c?
  bool is_within(PointId p, std::uint32_t c) const {
    const PointId from = facets_.from(c), to = facets_.to(c);
    return p != from && p != to && kernel_.turn(from, to, p, axis_) == Sign::zero &&
           kernel_.is_between(from, p, to);
  }

  const Facets& facets_;
  std::uint32_t face_;
  const Kernel& kernel_;
  int axis_;
};

}  // namespace

std::vector<std::uint8_t> find_self_touching(const Facets& facets,
                                             const std::vector<std::uint8_t>& convex,
                                             const Kernel& kernel) {
  std::vector<std::uint8_t> touching(facets.face_count(), 0);
  parallel::loop(parallel::Range<std::size_t>(0, touching.size(), 256), [&](const auto& range) {
    for (std::size_t f = range.begin(); f < range.end(); ++f)
      if (!convex[f])
        touching[f] = TouchTest(facets, static_cast<std::uint32_t>(f), kernel).touches();
  });
  return touching;
}

}  // namespace sectile::arrangement
