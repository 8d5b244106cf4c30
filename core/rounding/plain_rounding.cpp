#include "rounding/plain_rounding.h"

#include <algorithm>
#include <cmath>

#include "rounding/enclosed_volume.h"
#include "rounding/rounded_triangles.h"
#include "rounding/rounding_repair.h"
#include "rounding/unclear_triangles.h"
#include "rounding/wrong_shell.h"

namespace sectile {
namespace {

// What is changed may meet what was far from the triangles for which it was changed. So often that
// is looked at, before the whole is.
constexpr int most_rounds = 4;
// So far from a triangle with which something is wrong, in vertices, changes may reach.
constexpr int most_rings = 3;

class PlainRounding {
  using Triangles = RoundedTriangles::Triangles;

 public:
  PlainRounding(RoundedTriangles mesh, const RoundingGrid& grid, const Rounding& options,
                RoundingSteps& steps)
      : mesh_(std::move(mesh)), grid_(grid), options_(options), steps_(steps) {}

  std::optional<RoundedMesh> run() {
    const bool moved = !mesh_.moved().empty();
    if (moved && (!all_finite() || !make_legal())) return {};
    const bool shells_known = !moved || shells_stay();
    note_report(result_.report);
    mesh_.move_into(result_);
    if (!shells_known && !result_.mesh.face_sizes.empty() &&
        face_of_wrong_shell(result_.mesh, options_.cancel))
      return {};
    return std::move(result_);
  }

 private:
  bool make_legal() {
    UnclearTriangles unclear = unclear_triangles(mesh_, steps_);
    steps_.pass(0.8);
    mesh_.note_unclear(unclear.all, unclear.not_looked_at);
    if (unclear.all.empty()) return true;
    Triangles suspects = std::move(unclear.all), looked_at = mesh_.around(suspects);
    for (int round = 0; round < most_rounds; ++round) {
      steps_.check();
      const std::optional<Triangles> faulty = find_faulty(std::move(looked_at), suspects);
      if (!faulty) return false;
      if (faulty->empty()) return true;
      if (round == 0 && mesh_.has_crowded_edges(*faulty)) return false;
      if (!mend(*faulty, suspects)) return false;
      looked_at = mesh_.around(suspects);
    }
    return false;
  }

  bool shells_stay() const { return mesh_.shells_stay() || is_one_shell_around_volume(); }
  bool is_one_shell_around_volume() const {
    return mesh_.one_shell() && result_.report.merged == 0 &&
           clearly_encloses_volume(mesh_.positions(), mesh_.indices());
  }

  // Every pair with a suspect is tested. What decides about such a pair is near, too. Nothing if
  // there are edges of more than two triangles, as vertices were joined.
  std::optional<Triangles> find_faulty(Triangles looked_at, const Triangles& suspects) {
    if (looked_at.empty()) return Triangles();
    MeshPart part = mesh_.part(std::move(looked_at), suspects);
    if (!part.is_manifold) return {};
    steps_.check();
    Triangles faulty =
        faulty_triangles(part.rounded, Kernel(part.rounded.geometry), steps_.part(0.5));
    steps_.check();
    for (std::uint32_t& t : faulty) t = part.triangle[t];
    return faulty;
  }

  // What was changed is suspect then. False if changes nearby do not help.
  bool mend(const Triangles& faulty, Triangles& suspects) {
    const Triangles near = mesh_.neighbours(faulty, most_rings);
    steps_.check();
    MeshPart part = mesh_.part(mesh_.around(near), mesh_.unsettled());
    if (!part.is_manifold) return false;
    steps_.check();
    Kernel kernel(part.rounded.geometry);
    ignore_flat(part.rounded, kernel);
    RoundingRepair repair(part.rounded, kernel, grid_, options_);
    Triangles in_part;
    for (const std::uint32_t t : faulty)
      in_part.push_back(static_cast<std::uint32_t>(
          std::lower_bound(part.triangle.begin(), part.triangle.end(), t) - part.triangle.begin()));
    if (!repair.run(std::move(in_part)).empty()) return false;
    suspects = mesh_.take_back(part, repair.gone_to());
    steps_.check();
    result_.report.merged += repair.merged();
    result_.report.flipped += repair.flipped();
    if (repair.widest_flip() > result_.report.largest_move) {
      result_.report.largest_move = repair.widest_flip();
      result_.report.largest_at = repair.widest_flip_at();
    }
    return true;
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
      const Vec3& to = mesh_.position(m.vertex);
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

}  // namespace

std::optional<RoundedMesh> plain_rounding(const SolidData& data, const RoundingGrid& grid,
                                          const Rounding& options, RoundingSteps& steps) {
  auto triangles = block_triangles(data);
  if (!triangles) return {};
  steps.pass(0.3);
  RoundedTriangles mesh(data, std::move(*triangles), grid);
  steps.pass(0.3);
  return PlainRounding(std::move(mesh), grid, options, steps).run();
}

}  // namespace sectile
