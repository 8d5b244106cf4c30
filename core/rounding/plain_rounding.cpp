#include "rounding/plain_rounding.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "parallel/parallel.h"
#include "rounding/enclosed_volume.h"
#include "rounding/rounded_triangles.h"
#include "rounding/rounding_repair.h"

namespace sectile {
namespace {

// Where more than this part of the corners moves, the whole is looked at.
constexpr std::size_t least_share = 8;
// What is changed may meet what was far from the triangles for which it was changed. So often that
// is looked at, before the whole is.
constexpr int most_rounds = 4;
// So far from a triangle with which something is wrong, in vertices, changes may reach.
constexpr int rings = 3;

class PlainRounding {
  using Triangles = RoundedTriangles::Triangles;

 public:
  PlainRounding(RoundedTriangles mesh, const RoundingGrid& grid, const Rounding& options,
                RoundingSteps& steps)
      : mesh_(std::move(mesh)), grid_(grid), options_(options), steps_(steps) {}

  std::optional<RoundedMesh> run() {
    if (!mesh_.moved().empty() && (!all_finite() || !make_legal() || !shells_stay())) return {};
    note_report(result_.report);
    mesh_.move_into(result_);
    return std::move(result_);
  }

 private:
  bool make_legal() {
    Triangles suspects = mesh_.unsettled(), looked_at = mesh_.around(suspects);
    looked_at.insert(looked_at.end(), mesh_.cut().begin(), mesh_.cut().end());  // at their area
    for (int round = 0; round < most_rounds; ++round) {
      steps_.check();
      const Triangles faulty = find_faulty(std::move(looked_at), suspects);
      if (faulty.empty()) return true;
      if (!mend(faulty, suspects)) return false;
      looked_at = mesh_.around(suspects);
    }
    return false;
  }

  bool shells_stay() const {
    return mesh_.shells_stay() ||
           (mesh_.one_shell() && clearly_encloses_volume(mesh_.positions(), mesh_.indices()));
  }

  // Every pair with a suspect is tested. What decides about such a pair is near, too.
  Triangles find_faulty(Triangles looked_at, const Triangles& suspects) {
    sort_unique(looked_at);
    if (looked_at.empty()) return {};
    MeshPart part = mesh_.part(std::move(looked_at), suspects);
    steps_.check();
    Triangles faulty =
        faulty_triangles(part.rounded, Kernel(part.rounded.geometry), steps_.part(0.5));
    steps_.check();
    for (std::uint32_t& t : faulty) t = part.triangle[t];
    return faulty;
  }

  // What was changed is suspect then. False if changes nearby do not help. Joined vertices are not
  // taken: they may end a shell, or divide it.
  bool mend(const Triangles& faulty, Triangles& suspects) {
    Triangles near = mesh_.neighbours(faulty, rings);
    steps_.check();
    const Triangles others = mesh_.around(near);
    near.insert(near.end(), others.begin(), others.end());
    sort_unique(near);
    MeshPart part = mesh_.part(std::move(near), mesh_.unsettled());
    steps_.check();
    Kernel kernel(part.rounded.geometry);
    ignore_flat(part.rounded, kernel);
    RoundingRepair repair(part.rounded, kernel, grid_, options_);
    Triangles in_part;
    for (const std::uint32_t t : faulty)
      in_part.push_back(static_cast<std::uint32_t>(
          std::lower_bound(part.triangle.begin(), part.triangle.end(), t) - part.triangle.begin()));
    if (!repair.run(std::move(in_part)).empty() || repair.merged() > 0) return false;
    suspects = mesh_.take_back(part);
    steps_.check();
    result_.report.flipped += repair.flipped();
    if (repair.widest_flip() > result_.report.largest_move) {
      result_.report.largest_move = repair.widest_flip();
      result_.report.largest_at = repair.widest_flip_at();
    }
    return true;
  }

  static void sort_unique(Triangles& triangles) {
    std::sort(triangles.begin(), triangles.end());
    triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
  }

  // What is too large for the numbers is refused where the whole is looked at.
  bool all_finite() const {
    return std::all_of(mesh_.moved().begin(), mesh_.moved().end(), [&](const auto& m) {
      const Vec3& p = mesh_.positions()[m.vertex];
      return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
    });
  }

  void note_report(RoundingReport& report) const {
    report.corners = mesh_.positions().size();
    std::vector<double> moves;
    for (const RoundedTriangles::Moved& m : mesh_.moved()) {
      const Vec3& to = mesh_.positions()[m.vertex];
      if (!(to == grid_.nearest(m.from))) ++report.displaced;
      double move = std::hypot(to.x - m.from.x, to.y - m.from.y, to.z - m.from.z);
      // The place itself is off by half a unit in the last place of each coordinate at most.
      if (!m.was_exact) {
        const double half = 0x1p-53;
        move += std::hypot(half * m.from.x, half * m.from.y, half * m.from.z);
      }
      if (move == 0) continue;
      moves.push_back(move);
      if (move <= report.largest_move) continue;
      report.largest_move = move;
      report.largest_at = m.from;
    }
    report.moved = moves.size();
    if (moves.empty()) return;
    const auto middle = moves.begin() + static_cast<std::ptrdiff_t>(moves.size() / 2);
    std::nth_element(moves.begin(), middle, moves.end());
    report.median_move = *middle;
  }

  RoundedTriangles mesh_;
  const RoundingGrid& grid_;
  const Rounding& options_;
  RoundingSteps& steps_;
  RoundedMesh result_;
};

// Where most corners move, as they do in floats, the whole has to be tested.
bool most_stay(const SolidData& data, const RoundingGrid& grid) {
  const auto slots = data.slots();
  std::vector<std::size_t> moved(slots.size(), 0), all(slots.size(), 0);
  parallel::loop(0, slots.size(), [&](std::size_t s) {
    if (slots[s].empty()) return;
    const Geometry& g = slots[s].block->geometry();
    all[s] = g.positions.size();
    for (std::size_t i = 0; i < all[s]; ++i) {
      const PointId p(i);
      moved[s] += !g.is_explicit(p) || !(grid.nearest(g.position(p)) == g.position(p));
    }
  });
  const auto sum = [](const auto& counts) {
    return std::accumulate(counts.begin(), counts.end(), std::size_t(0));
  };
  return sum(moved) <= sum(all) / least_share;
}

}  // namespace

std::optional<RoundedMesh> plain_rounding(const SolidData& data, const RoundingGrid& grid,
                                          const Rounding& options, RoundingSteps& steps) {
  if (!most_stay(data, grid)) return {};
  steps.check();
  auto triangles = block_triangles(data);
  if (!triangles) return {};
  steps.check();
  RoundedTriangles mesh(data, std::move(*triangles), grid);
  steps.check();
  return PlainRounding(std::move(mesh), grid, options, steps).run();
}

}  // namespace sectile
