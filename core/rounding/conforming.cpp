#include "rounding/conforming.h"

#include <algorithm>
#include <tuple>

#include "rounding/triangle_corners.h"
#include "search/edges_by_line.h"
#include "sectile/errors.h"

namespace sectile {
namespace {

class Conforming {
 public:
  Conforming(TriangleSurface& surface, const Kernel& kernel) : surface_(surface), kernel_(kernel) {}

  void run() {
    find_open();
    if (open_.empty()) return;
    for (const Open& e : open_) {
      points_.push_back(e.from);
      points_.push_back(e.to);
    }
    std::sort(points_.begin(), points_.end());
    points_.erase(std::unique(points_.begin(), points_.end()), points_.end());
    // A division makes smaller open edges, of which there are finitely many.
    while (divide_one_each()) find_open();
    match();
  }

 private:
  struct Open {
    PointId from, to;
    std::uint32_t triangle, k;
    PointId low() const { return std::min(from, to); }
    PointId high() const { return std::max(from, to); }
  };

  void find_open() {
    open_.clear();
    for (std::uint32_t t = 0; t < surface_.size(); ++t)
      for (std::uint32_t k = 0; k < 3; ++k)
        if ((surface_.mate[t][k] & TriangleSurface::partial) != 0)
          open_.push_back({surface_.corners[t][k], surface_.corners[t][next_corner(k)], t, k});
  }

  // At most one edge of each triangle, at one point.
  bool divide_one_each() {
    bool divided = false;
    std::uint32_t last = 0xFFFFFFFFu;
    for (const Open& e : open_) {
      if (e.triangle == last) continue;
      for (const PointId p : points_) {
        if (!is_within_edge(kernel_, p, e.from, e.to)) continue;
        divide(e, p);
        last = e.triangle;
        divided = true;
        break;
      }
    }
    return divided;
  }

  // (from, to, apex) becomes (from, p, apex), and (p, to, apex) is new.
  void divide(const Open& e, PointId p) {
    const auto added = static_cast<std::uint32_t>(surface_.size());
    const std::size_t k = e.k, to = next_corner(k), apex = next_corner(to);
    surface_.corners.push_back(surface_.corners[e.triangle]);
    surface_.plane.push_back(surface_.plane[e.triangle]);
    surface_.face.push_back(surface_.face[e.triangle]);
    surface_.mate.push_back(surface_.mate[e.triangle]);
    surface_.corners[added][k] = p;
    surface_.corners[e.triangle][to] = p;
    const std::uint32_t across = surface_.mate[added][to];
    if ((across & TriangleSurface::partial) == 0) {
      for (std::size_t j = 0; j < 3; ++j)
        if (surface_.mate[across][j] == e.triangle &&
            surface_.corners[across][next_corner(j)] == e.to)
          surface_.mate[across][j] = added;
    }
    surface_.mate[added][apex] = e.triangle;
    surface_.mate[e.triangle][to] = added;
  }

  void match() {
    find_open();
    std::sort(open_.begin(), open_.end(), [](const Open& a, const Open& b) {
      return std::tuple(a.low(), a.high(), a.from, a.triangle) <
             std::tuple(b.low(), b.high(), b.from, b.triangle);
    });
    for (std::size_t begin = 0, end; begin < open_.size(); begin = end) {
      for (end = begin; end < open_.size() && open_[end].low() == open_[begin].low() &&
                        open_[end].high() == open_[begin].high();)
        ++end;
      const std::size_t half = (end - begin) / 2;
      for (std::size_t i = begin; i < begin + half; ++i) pair(open_[i], open_[i + half]);
      if (2 * half != end - begin)
        throw InternalError("the triangles of a solid do not fit together");
    }
  }

  void pair(const Open& a, const Open& b) {
    if (a.from != b.to || a.to != b.from)
      throw InternalError("the triangles of a solid do not fit together");
    surface_.mate[a.triangle][a.k] = b.triangle;
    surface_.mate[b.triangle][b.k] = a.triangle;
  }

  TriangleSurface& surface_;
  const Kernel& kernel_;
  std::vector<Open> open_;
  std::vector<PointId> points_;
};

}  // namespace

void make_conforming(TriangleSurface& surface, const Kernel& kernel) {
  Conforming(surface, kernel).run();
}

}  // namespace sectile
