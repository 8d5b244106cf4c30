#include "arrangement/cells.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "arrangement/middle.h"
#include "geometry/around_line.h"
#include "geometry/face_predicates.h"
#include "geometry/triangulation.h"
#include "import/edge_buckets.h"
#include "numbers/disjoint_sets.h"
#include "numbers/threshold.h"
#include "parallel/parallel.h"
#include "sectile/errors.h"

namespace sectile::arrangement {
namespace {

// Which sub-faces meet in each edge.
class EdgeFinder {
 public:
  EdgeFinder(const SubFaces& faces, const Kernel& kernel, Cells& cells)
      : faces_(faces), kernel_(kernel), cells_(cells), buckets_(faces.polygons) {}

  void run() {
    find_faces();
    cells_.rows = find_rows(faces_, cells_.face_of, kernel_);
    cells_.mate.assign(faces_.polygons.corners.size(), none);
    constexpr std::uint32_t block = 4096;
    std::vector<Found> found((buckets_.count() + block - 1) / block);
    parallel::loop(0, found.size(), [&](std::size_t b) {
      const auto from = static_cast<std::uint32_t>(b) * block;
      for (std::uint32_t p = from; p < std::min(from + block, buckets_.count()); ++p)
        match_bucket(PointId(p), buckets_[p], found[b]);
    });
    for (const Found& f : found) {
      const auto offset = static_cast<std::uint32_t>(cells_.sides.size());
      cells_.sides.insert(cells_.sides.end(), f.sides.begin(), f.sides.end());
      for (const EdgeFan& fan : f.fans)
        cells_.fans.push_back({fan.first + offset, fan.end + offset});
    }
  }

 private:
  struct Found {
    std::vector<EdgeFan> fans;
    std::vector<EdgeFan::Side> sides;
  };

  void find_faces() {
    const Polygons& polygons = faces_.polygons;
    cells_.face_of.resize(polygons.corners.size());
    parallel::loop(parallel::Range<std::size_t>(0, faces_.size(), 4096), [&](const auto& range) {
      for (std::size_t f = range.begin(); f < range.end(); ++f) {
        const std::uint32_t begin = polygons.loop_begin(polygons.first_loop(f)),
                            end = polygons.loop_end[polygons.face_end[f] - 1];
        for (std::uint32_t c = begin; c < end; ++c)
          cells_.face_of[c] = static_cast<std::uint32_t>(f);
      }
    });
  }

  void match_bucket(PointId low, std::span<LineEntry> all, Found& found) {
    const std::span<LineEntry> bucket = not_in_rows(all);
    std::sort(bucket.begin(), bucket.end(), [](const LineEntry& a, const LineEntry& b) {
      return a.high != b.high ? a.high < b.high : a.corner < b.corner;
    });
    for (std::size_t from = 0, to; from < bucket.size(); from = to) {
      for (to = from + 1; to < bucket.size() && bucket[to].high == bucket[from].high;) ++to;
      const auto entries = bucket.subspan(from, to - from);
      if (entries.size() == 2 && entries[0].forward != entries[1].forward && same_step(entries)) {
        cells_.mate[entries[0].corner] = entries[1].corner;
        cells_.mate[entries[1].corner] = entries[0].corner;
      } else {
        add_fan(low, entries, found);
      }
    }
  }
  std::span<LineEntry> not_in_rows(std::span<LineEntry> entries) const {
    if (faces_.row.empty()) return entries;
    const auto end = std::remove_if(entries.begin(), entries.end(), [&](const LineEntry& e) {
      return faces_.row[e.corner] != none;
    });
    return entries.first(static_cast<std::size_t>(end - entries.begin()));
  }
  bool same_step(std::span<const LineEntry> entries) const {
    return faces_.step_of[cells_.face_of[entries[0].corner]] ==
           faces_.step_of[cells_.face_of[entries[1].corner]];
  }

  LineSide side(const LineEntry& e) const {
    return {faces_.plane[cells_.face_of[e.corner]], e.forward};
  }

  void add_fan(PointId low, std::span<LineEntry> entries, Found& found) const {
    int axis = -1;
    for (const LineEntry& e : entries)
      if ((axis = kernel_.cross_axis(side(entries[0]).plane, side(e).plane)) >= 0) break;
    const Sign up = axis < 0 ? Sign::zero : kernel_.compare(low, entries[0].high, axis);
    const AroundLine around(kernel_, axis, up);
    const LineSide start = side(entries[0]);
    std::sort(entries.begin() + 1, entries.end(), [&](const LineEntry& a, const LineEntry& b) {
      return around.before(start, side(a), side(b), a.corner < b.corner);
    });
    const auto first = static_cast<std::uint32_t>(found.sides.size());
    for (std::size_t i = 0; i < entries.size(); ++i) {
      const LineEntry &e = entries[i], &next = entries[i + 1 < entries.size() ? i + 1 : 0];
      if (entries.size() > 1 && around.tied(side(e), side(next)))
        throw InternalError("faces that lie on each other were not found to be one");
      found.sides.push_back({e.corner, e.forward});
    }
    found.fans.push_back({first, static_cast<std::uint32_t>(found.sides.size())});
  }

  const SubFaces& faces_;
  const Kernel& kernel_;
  Cells& cells_;
  EdgeBuckets buckets_;
};

// Sub-faces that are simply neighbours form patches; what is before all of a patch is one cell, and
// so is what is behind it.
class CellFinder {
 public:
  CellFinder(const SubFaces& faces, const Facets& facets, const BoxTree& tree, Counting counting,
             const Kernel& kernel, const Steering& steering, Cells& cells)
      : faces_(faces),
        facets_(facets),
        tree_(tree),
        counting_(counting),
        kernel_(kernel),
        steering_(steering),
        cells_(cells) {}

  void run(InsideOut inside_out) {
    find_patches();
    unite_sides();
    find_components();
    cast_rays();
    if (inside_out == InsideOut::turn) find_turned();
    number_cells();
  }

 private:
  struct Component {
    std::vector<std::uint32_t> patches;
    std::vector<WindingRay::Hit> hits;
    std::uint32_t base = none;
  };

  std::size_t patch_count() const { return patch_face_.size(); }

  void find_patches() {
    patch_of_.assign(faces_.size(), none);
    const Polygons& polygons = faces_.polygons;
    std::vector<std::uint32_t> front;
    for (std::uint32_t f = 0; f < faces_.size(); ++f) {
      if (patch_of_[f] != none) continue;
      const auto number = static_cast<std::uint32_t>(patch_face_.size());
      patch_face_.push_back(f);
      patch_of_[f] = number;
      front.push_back(f);
      while (!front.empty()) {
        const std::uint32_t at = front.back();
        front.pop_back();
        const std::uint32_t begin = polygons.loop_begin(polygons.first_loop(at)),
                            end = polygons.loop_end[polygons.face_end[at] - 1];
        for (std::uint32_t c = begin; c < end; ++c) {
          if (cells_.mate[c] == none) continue;
          const std::uint32_t beyond = cells_.face_of[cells_.mate[c]];
          if (patch_of_[beyond] != none) continue;
          patch_of_[beyond] = number;
          front.push_back(beyond);
        }
      }
    }
  }

  // A side of a patch: 2p is what is before it, 2p + 1 what is behind it.
  template <class Side>
  std::uint32_t side_after(const Side& s) const {
    return 2 * patch(s) + (s.forward ? 0 : 1);
  }
  template <class Side>
  std::uint32_t side_before(const Side& s) const {
    return 2 * patch(s) + (s.forward ? 1 : 0);
  }
  template <class Side>
  std::uint32_t patch(const Side& s) const {
    return patch_of_[cells_.face_of[s.corner]];
  }

  void unite_sides() {
    DisjointSets sides(2 * patch_count()), components(patch_count());
    const auto unite = [&](const auto& side, const auto& next) {
      sides.unite(side_after(side), side_before(next));
      components.unite(patch(side), patch(next));
    };
    for (const EdgeFan& fan : cells_.fans) {
      const auto around = cells_.of(fan);
      for (std::size_t i = 0; i < around.size(); ++i)
        unite(around[i], around[i + 1 < around.size() ? i + 1 : 0]);
    }
    for (const EdgeRow& row : cells_.rows)
      for (const Neighbours& n : neighbours(row, std::vector<std::uint8_t>(row.sides.size(), 1))) {
        const EdgeRow::Side &side = row.sides[n.side], &next = row.sides[n.next];
        if (n.side != n.next && side.direction == next.direction)
          throw InternalError("faces that lie on each other were not found to be one");
        unite(side, next);
      }
    cell_of_.resize(2 * patch_count());
    for (std::uint32_t s = 0; s < cell_of_.size(); ++s) cell_of_[s] = sides.first(s);
    component_of_.resize(patch_count());
    for (std::uint32_t p = 0; p < component_of_.size(); ++p) component_of_[p] = components.first(p);
  }

  // Numbers the components, and lists their patches.
  void find_components() {
    std::vector<std::uint32_t> number(patch_count(), none);
    for (std::uint32_t p = 0; p < patch_count(); ++p) {
      std::uint32_t& n = number[component_of_[p]];
      if (n == none) {
        n = static_cast<std::uint32_t>(components_.size());
        components_.emplace_back();
      }
      component_of_[p] = n;
      components_[n].patches.push_back(p);
    }
  }

  // A triangle within a sub-face.
  std::array<PointId, 3> triangle(std::uint32_t f) const {
    const Polygons& polygons = faces_.polygons;
    const auto corners = polygons.face_corners(f);
    std::vector<std::uint32_t> ends;
    const std::uint32_t begin = polygons.loop_begin(polygons.first_loop(f));
    for (std::uint32_t l = polygons.first_loop(f); l < polygons.face_end[f]; ++l)
      ends.push_back(polygons.loop_end[l] - begin);
    const PlaneId plane = faces_.plane[f];
    const int axis = kernel_.main_axis(plane);
    const FacePredicates exact(kernel_, axis, kernel_.normal(plane, axis) == Sign::negative,
                               corners);
    std::vector<std::array<std::uint32_t, 3>> triangles;
    triangulate(exact, std::span<const std::uint32_t>(ends), triangles);
    if (triangles.empty()) throw InternalError("a part of a face has no area");
    const auto& t = triangles.front();
    return {corners[t[0]], corners[t[1]], corners[t[2]]};
  }

  RayStart ray_start(const Component& component) const {
    const auto [p, q, r] = triangle(patch_face_[component.patches[0]]);
    return RayStart(exact_centre(kernel_, p, q, r));
  }

  // Parts that stand in a row hide each other along it: there, rays go where they meet least.
  WindingRay best_ray() const {
    const std::size_t sample = std::min<std::size_t>(components_.size(), 64);
    std::array<std::size_t, 3> met{};
    for (std::size_t i = 0; i < sample; ++i) {
      const RayStart start = ray_start(components_[i * components_.size() / sample]);
      for (int axis = 0; axis < 3; ++axis)
        met[static_cast<std::size_t>(axis)] +=
            WindingRay(facets_, tree_, kernel_, axis).near_faces(start).size();
    }
    const auto least = std::min_element(met.begin(), met.end()) - met.begin();
    return WindingRay(facets_, tree_, kernel_, static_cast<int>(least));
  }

  // One ray for each component; the windings of its other cells follow.
  void cast_rays() {
    constexpr std::size_t few = threshold(16, 1);
    const WindingRay ray =
        components_.size() <= few ? WindingRay(facets_, tree_, kernel_, 0) : best_ray();
    winding_.resize(cell_of_.size());
    known_.assign(cell_of_.size(), 0);
    links_ = Links(cell_of_);
    parallel::loop(0, components_.size(), [&](std::size_t i) {
      steering_.check();
      Component& component = components_[i];
      const std::uint32_t f = patch_face_[component.patches[0]];
      const RayStart start = ray_start(component);
      component.hits = ray.hits(start);
      const bool before = ray.side(start, faces_.plane[f]) == Sign::positive;
      component.base = cell_of_[2 * patch_of_[f] + (before ? 0 : 1)];
      Winding winding;
      for (const WindingRay::Hit& hit : component.hits)
        add(winding, {{facets_.operand[hit.face], hit.sign}}, 1, counting_);
      spread(component.base, std::move(winding));
    });
  }

  void spread(std::uint32_t base, Winding winding) {
    std::vector<std::uint32_t> front{base};
    known_[base] = 1;
    winding_[base] = std::move(winding);
    while (!front.empty()) {
      const std::uint32_t cell = front.back();
      front.pop_back();
      for (const std::uint32_t side : links_.of(cell)) {
        const std::uint32_t beyond = cell_of_[side ^ 1u];
        Winding there = winding_[cell];
        add(there, faces_.steps[faces_.step_of[patch_face_[side / 2]]], side % 2 == 0 ? 1 : -1,
            counting_);
        if (!known_[beyond]) {
          known_[beyond] = 1;
          winding_[beyond] = std::move(there);
          front.push_back(beyond);
        } else if (winding_[beyond] != there) {
          throw InternalError("the winding numbers around the faces contradict each other");
        }
      }
    }
  }

  // How often a component goes around another one, if not never.
  struct Depth {
    std::uint32_t component;
    std::int32_t number;
  };
  std::vector<std::vector<Depth>> find_depths() const {
    std::vector<std::uint32_t> component_of_face(facets_.face_count(), none);
    for (std::uint32_t f = 0; f < faces_.size(); ++f)
      for (const std::uint32_t g : faces_.cover_of(f))
        component_of_face[g] = component_of_[patch_of_[f]];
    std::vector<std::vector<Depth>> depths(components_.size());
    std::vector<std::pair<std::uint32_t, std::int32_t>> hits;
    for (std::uint32_t i = 0; i < components_.size(); ++i) {
      hits.clear();
      for (const WindingRay::Hit& hit : components_[i].hits)
        if (const std::uint32_t c = component_of_face[hit.face]; c != none && c != i)
          hits.push_back({c, hit.sign});
      std::sort(hits.begin(), hits.end());
      for (std::size_t from = 0, to; from < hits.size(); from = to) {
        Depth depth{hits[from].first, 0};
        for (to = from; to < hits.size() && hits[to].first == depth.component; ++to)
          depth.number += hits[to].second;
        if (depth.number != 0) depths[i].push_back(depth);
      }
    }
    return depths;
  }

  std::int32_t number(std::uint32_t cell) const {
    return winding_[cell].empty() ? 0 : winding_[cell][0].second;
  }

  // What lies within a component that is turned is turned with it, unless it would then have to be
  // turned itself. What goes around another component has fewer components around it.
  void find_turned() {
    const auto depths = find_depths();
    std::vector<std::uint32_t> order(components_.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
      return depths[i].size() < depths[j].size();
    });
    std::vector<std::int32_t> turn(components_.size(), 1);
    for (const std::uint32_t i : order) {
      std::int32_t around = 0, around_before = 0;
      std::uint32_t innermost = none;
      for (const Depth& d : depths[i]) {
        around_before += d.number;
        around += turn[d.component] * d.number;
        if (innermost == none || depths[d.component].size() > depths[innermost].size())
          innermost = d.component;
      }
      std::int32_t& mine = turn[i] = innermost == none ? 1 : turn[innermost];
      const std::vector<std::uint32_t> cells = cells_of(components_[i]);
      std::int32_t least = 0, most = 0;
      for (const std::uint32_t c : cells) {
        const std::int32_t n = mine * (number(c) - around_before);
        least = std::min(least, n);
        most = std::max(most, n);
      }
      if (around == 0 && most == 0 && least < 0) {
        mine = -mine;
        cells_.turned.push_back(faces_.cover_of(patch_face_[components_[i].patches[0]])[0]);
      }
      for (const std::uint32_t c : cells) {
        const std::int32_t n = around + mine * (number(c) - around_before);
        winding_[c].clear();
        if (n != 0) winding_[c].push_back({0, n});
      }
    }
  }
  std::vector<std::uint32_t> cells_of(const Component& component) const {
    std::vector<std::uint32_t> cells;
    for (const std::uint32_t p : component.patches)
      cells.insert(cells.end(), {cell_of_[2 * p], cell_of_[2 * p + 1]});
    std::sort(cells.begin(), cells.end());
    cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
    return cells;
  }

  void number_cells() {
    std::vector<std::uint32_t> number(cell_of_.size(), none);
    for (std::uint32_t s = 0; s < cell_of_.size(); ++s) {
      std::uint32_t& n = number[cell_of_[s]];
      if (n != none) continue;
      n = static_cast<std::uint32_t>(cells_.winding.size());
      cells_.winding.push_back(std::move(winding_[cell_of_[s]]));
    }
    cells_.before.resize(faces_.size());
    cells_.behind.resize(faces_.size());
    for (std::uint32_t f = 0; f < faces_.size(); ++f) {
      cells_.before[f] = number[cell_of_[2 * patch_of_[f]]];
      cells_.behind[f] = number[cell_of_[2 * patch_of_[f] + 1]];
    }
  }

  // The sides of patches that are of one cell.
  class Links {
   public:
    Links() = default;
    explicit Links(const std::vector<std::uint32_t>& cell_of) : end_(cell_of.size(), 0) {
      for (const std::uint32_t c : cell_of) ++end_[c];
      std::partial_sum(end_.begin(), end_.end(), end_.begin());
      begin_ = end_;
      sides_.resize(cell_of.size());
      for (auto s = static_cast<std::uint32_t>(cell_of.size()); s-- > 0;)
        sides_[--begin_[cell_of[s]]] = s;
    }
    std::span<const std::uint32_t> of(std::uint32_t cell) const {
      return std::span(sides_).subspan(begin_[cell], end_[cell] - begin_[cell]);
    }

   private:
    std::vector<std::uint32_t> begin_, end_, sides_;
  };

  const SubFaces& faces_;
  const Facets& facets_;
  const BoxTree& tree_;
  Counting counting_;
  const Kernel& kernel_;
  const Steering& steering_;
  Cells& cells_;
  std::vector<std::uint32_t> patch_of_;      // per sub-face
  std::vector<std::uint32_t> patch_face_;    // per patch: one of its sub-faces
  std::vector<std::uint32_t> cell_of_;       // per side of a patch
  std::vector<std::uint32_t> component_of_;  // per patch
  std::vector<Component> components_;
  Links links_;
  std::vector<Winding> winding_;  // per cell
  std::vector<std::uint8_t> known_;
};

}  // namespace

Cells find_cells(const SubFaces& faces, const Facets& facets, const BoxTree& tree,
                 Counting counting, InsideOut inside_out, const Kernel& kernel,
                 const Steering& steering) {
  Cells cells;
  EdgeFinder(faces, kernel, cells).run();
  steering.step(0.7);
  CellFinder(faces, facets, tree, counting, kernel, steering, cells).run(inside_out);
  return cells;
}

}  // namespace sectile::arrangement
