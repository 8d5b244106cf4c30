#include "selftest/flat_patches.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "geometry/four_points.h"
#include "numbers/rounding.h"
#include "numbers/threshold.h"
#include "parallel/parallel.h"
#include "search/approximate.h"
#include "search/box_tree.h"
#include "selftest/rim_sweep.h"

namespace sectile {
namespace {

// Fewer triangles are not worth a look.
constexpr std::size_t many = threshold(16, 2);

// Edges between triangles of one plane, as bits per triangle.
class FlatEdges {
 public:
  FlatEdges(const TriangleSurface& surface, const Kernel& kernel)
      : surface_(surface), kernel_(kernel), bits_(surface.size(), 0) {
    parallel::loop(
        parallel::Range<std::uint32_t>(0, static_cast<std::uint32_t>(surface.size()), 1024),
        [&](const auto& range) {
          for (std::uint32_t t = range.begin(); t < range.end(); ++t) {
            if (!surface.flat.empty() && surface.flat[t] == 0) continue;
            for (unsigned k = 0; k < 3; ++k) look_across(t, k);
          }
        });
  }

  std::uint8_t of(std::uint32_t t) const { return bits_[t]; }

 private:
  // Sets the bit on both sides.
  void look_across(std::uint32_t t, unsigned k) {
    const std::uint32_t mate = surface_.mate[t][k];
    if ((mate & TriangleSurface::partial) != 0 || mate <= t) return;
    const auto &mine = surface_.corners[t], &others = surface_.corners[mate];
    unsigned j = 0;
    while (j < 3 && (others[j] != mine[(k + 1) % 3] || others[(j + 1) % 3] != mine[k])) ++j;
    if (j == 3 || !is_flat(t, mate, others[(j + 2) % 3])) return;
    set(t, k);
    set(mate, j);
  }

  bool is_flat(std::uint32_t t, std::uint32_t mate, PointId apex) const {
    if (!surface_.ignored.empty() && (surface_.ignored[t] != 0 || surface_.ignored[mate] != 0))
      return false;
    const std::uint32_t face = surface_.face[t];
    if (face == surface_.face[mate])
      return surface_.doubtful.empty() || surface_.doubtful[face] == 0;
    const PlaneId a = surface_.plane[t], b = surface_.plane[mate];
    return !clearly_off_plane(kernel_.geometry(), apex, a) && kernel_.side(apex, a) == Sign::zero &&
           kernel_.parallel(a, b) && kernel_.same_direction(a, b);
  }

  void set(std::uint32_t t, unsigned k) {
    std::atomic_ref(bits_[t]).fetch_or(static_cast<std::uint8_t>(1u << k),
                                       std::memory_order_relaxed);
  }

  const TriangleSurface& surface_;
  const Kernel& kernel_;
  std::vector<std::uint8_t> bits_;
};

// Sets of many triangles that hang together over flat edges, in the order of their first ones.
std::vector<std::vector<std::uint32_t>> plane_sets(const TriangleSurface& surface,
                                                   const FlatEdges& flat) {
  std::vector<std::vector<std::uint32_t>> sets;
  std::vector<std::uint8_t> seen;
  for (std::uint32_t first = 0; first < surface.size(); ++first) {
    if (flat.of(first) == 0 || (!seen.empty() && seen[first] != 0)) continue;
    if (seen.empty()) seen.assign(surface.size(), 0);
    std::vector<std::uint32_t> set{first};
    seen[first] = 1;
    for (std::size_t i = 0; i < set.size(); ++i)
      for (unsigned k = 0; k < 3; ++k) {
        if ((flat.of(set[i]) >> k & 1u) == 0) continue;
        const std::uint32_t mate = surface.mate[set[i]][k];
        if (seen[mate] != 0) continue;
        seen[mate] = 1;
        set.push_back(mate);
      }
    if (set.size() < many) continue;
    std::sort(set.begin(), set.end());
    sets.push_back(std::move(set));
  }
  return sets;
}

class PatchFinder {
 public:
  PatchFinder(const TriangleSurface& surface, const Kernel& kernel)
      : surface_(surface), kernel_(kernel), sweep_(kernel) {}

  /// The set if its triangles do not overlap, or else those of its faces of which that is known.
  std::vector<FlatPatch> run(std::vector<std::uint32_t> set) {
    const PlaneId plane = surface_.plane[set[0]];
    std::vector<FlatPatch> found;
    if (surface_.face[set.front()] == surface_.face[set.back()] || winds_once(set, plane)) {
      found.push_back({std::move(set), plane});
      return found;
    }
    for (std::size_t from = 0, to; from < set.size(); from = to) {
      const std::uint32_t face = surface_.face[set[from]];
      for (to = from; to < set.size() && surface_.face[set[to]] == face;) ++to;
      const bool doubtful = !surface_.doubtful.empty() && surface_.doubtful[face] != 0;
      const auto at = [&](std::size_t i) { return set.begin() + static_cast<std::ptrdiff_t>(i); };
      if (to - from >= many && !doubtful) found.push_back({{at(from), at(to)}, plane});
    }
    return found;
  }

 private:
  bool winds_once(const std::vector<std::uint32_t>& set, PlaneId plane) {
    rim_.clear();
    for (const std::uint32_t t : set)
      for (unsigned k = 0; k < 3; ++k) {
        const std::uint32_t mate = surface_.mate[t][k];
        const bool whole = (mate & TriangleSurface::partial) == 0;
        if (whole && std::binary_search(set.begin(), set.end(), mate)) continue;
        rim_.push_back({surface_.corners[t][k], surface_.corners[t][k < 2 ? k + 1 : 0]});
      }
    const int axis = kernel_.main_axis(plane);
    return sweep_.winds_once(rim_, axis, kernel_.normal(plane, axis) == Sign::negative);
  }

  const TriangleSurface& surface_;
  const Kernel& kernel_;
  RimSweep sweep_;
  std::vector<RimEdge> rim_;
};

Bounds bounds_of(const TriangleSurface& surface, const Geometry& geometry, std::uint32_t t) {
  Bounds bounds;
  for (const PointId p : surface.corners[t]) bounds.add(geometry.position(p));
  return bounds;
}

double half_surface(const Bounds& b) {
  using namespace approximate;
  const Vec3 size = b.high - b.low;
  return size.x * size.y + size.y * size.z + size.z * size.x;
}

// The box around a patch, if its triangles leave most of that empty; or else none.
Box hollow_box(const FlatPatch& patch, const TriangleSurface& surface, const Geometry& geometry) {
  Bounds all;
  double sum = 0;
  for (const std::uint32_t t : patch.triangles) {
    const Bounds bounds = bounds_of(surface, geometry, t);
    sum += half_surface(bounds);
    all.add(bounds.low);
    all.add(bounds.high);
  }
  return sum < half_surface(all) ? all.box() : Box();
}

// Boxes of rings in rings all overlap; those of their triangles do not.
void drop_nested(std::vector<FlatPatch>& patches, const TriangleSurface& surface,
                 const Geometry& geometry) {
  constexpr std::size_t many_others = threshold(8, 1);
  if (patches.size() <= many_others) return;
  std::vector<Box> boxes(patches.size());
  parallel::loop(0, patches.size(),
                 [&](std::size_t i) { boxes[i] = hollow_box(patches[i], surface, geometry); });
  const auto is_none = [](const Box& box) { return box.low[0] > box.high[0]; };
  std::vector<Box> hollow;
  std::ranges::remove_copy_if(boxes, std::back_inserter(hollow), is_none);
  if (hollow.size() <= many_others) return;
  const BoxTree tree(hollow);
  const auto is_nested = [&](const Box& box) {
    std::size_t around = 0;  // itself among them
    tree.query([&](const Box& other) { return around <= many_others + 1 && other.overlaps(box); },
               [&](std::uint32_t) { ++around; });
    return around > many_others + 1;
  };
  std::size_t kept = 0;
  for (std::size_t i = 0; i < patches.size(); ++i)
    if (is_none(boxes[i]) || !is_nested(boxes[i])) std::swap(patches[kept++], patches[i]);
  patches.resize(kept);
}

}  // namespace

FlatPatches::FlatPatches(const TriangleSurface& surface, const Kernel& kernel)
    : surface_(surface), kernel_(kernel) {
  if (surface.size() < many) return;
  auto sets = plane_sets(surface, FlatEdges(surface, kernel));
  std::vector<std::vector<FlatPatch>> found(sets.size());
  parallel::loop(0, sets.size(), [&](std::size_t i) {
    found[i] = PatchFinder(surface, kernel).run(std::move(sets[i]));
  });
  for (auto& some : found) std::move(some.begin(), some.end(), std::back_inserter(patches_));
  drop_nested(patches_, surface, kernel.geometry());
  number();
}

void FlatPatches::number() {
  if (patches_.empty()) return;
  of_triangle_.assign(surface_.size(), none);
  at_point_.assign(kernel_.geometry().positions.size(), none);
  for (std::uint32_t i = 0; i < patches_.size(); ++i)
    for (const std::uint32_t t : patches_[i].triangles) {
      of_triangle_[t] = i;
      for (const PointId p : surface_.corners[t]) at_point_[p.value()] = i;
    }
}

std::vector<std::uint32_t> FlatPatches::rest() const {
  std::vector<std::uint32_t> rest;
  rest.reserve(surface_.size());
  for (std::uint32_t t = 0; t < surface_.size(); ++t)
    if ((of_triangle_.empty() || of_triangle_[t] == none) &&
        (surface_.ignored.empty() || surface_.ignored[t] == 0))
      rest.push_back(t);
  return rest;
}

bool FlatPatches::stands_on(std::uint32_t t, std::size_t patch) const {
  const auto& corners = surface_.corners[t];
  std::array<bool, 3> on_plane;
  unsigned count = 0;
  Sign side = Sign::zero;
  for (unsigned k = 0; k < 3; ++k) {
    const bool is_corner = at_point_[corners[k].value()] == patch;
    const Sign s = is_corner ? Sign::zero : kernel_.side(corners[k], patches_[patch].plane);
    on_plane[k] = s == Sign::zero;
    if (on_plane[k]) {
      ++count;
    } else {
      if (side != Sign::zero && side != s) return false;
      side = s;
    }
  }
  if (count < 2) return true;
  for (unsigned k = 0; count == 2 && k < 3; ++k) {
    const std::uint32_t mate = surface_.mate[t][k];
    if (on_plane[k] && on_plane[k < 2 ? k + 1 : 0])
      return (mate & TriangleSurface::partial) == 0 && of_triangle_[mate] == patch;
  }
  return false;
}

// Numbers that are too large for doubles compare as not sure.
bool FlatPatches::is_beside(const Box& box, std::size_t patch) const {
  const PlaneValue& plane = kernel_.value(patches_[patch].plane);
  double at = plane.d, reach = 0, size = std::abs(plane.d), far = 0;
  for (int k = 0; k < 3; ++k) {
    const double low = box.low[k], high = box.high[k], n = plane.n[k];
    const double middle = low / 2 + high / 2, half = high / 2 - low / 2;
    const double most = std::max(std::abs(low), std::abs(high));
    at += n * middle;
    reach += std::abs(n) * half;
    size += 2 * std::abs(n) * most;
    far += most;
  }
  const double error = 32 * rounding::unit * size + plane.d_error +
                       plane.n_error * far * (1 + 32 * rounding::unit) + 0x1p-1000;
  return std::abs(at) > reach + error;
}

}  // namespace sectile
