#include "rounding/rounding_attempt.h"

#include <algorithm>
#include <cmath>

#include "geometry/axes.h"
#include "numbers/none.h"
#include "numbers/threshold.h"
#include "rounding/enclosed_volume.h"
#include "rounding/resolved.h"
#include "rounding/separation.h"
#include "rounding/wrong_shell.h"
#include "search/box_tree.h"
#include "sectile/errors.h"

namespace sectile {
namespace {

// So many vertices at a place, moved apart, are looked at once more.
constexpr std::size_t small_crowd = threshold(32, 4);

// The least box of a triangle, and those around it.
struct Surroundings {
  Vec3 low, high;
  bool contain(const Vec3& p, double distance) const {
    for (int k = 0; k < 3; ++k)
      if (component(p, k) < component(low, k) - distance ||
          component(p, k) > component(high, k) + distance)
        return false;
    return true;
  }
};

}  // namespace

RoundingAttempt::RoundingAttempt(const SolidData& data, const RoundingGrid& grid,
                                 const Rounding& options, RoundedSurface::Lines lines,
                                 const Displacement& before, RoundingSteps& steps)
    : options_(options),
      grid_(grid),
      before_(before),
      steps_(steps),
      rounded_(data, grid, lines, steps.part(0.4)),
      kernel_(rounded_.geometry) {}

RoundingRepair& RoundingAttempt::repair() {
  if (!repair_) repair_.emplace(rounded_, kernel_, grid_, options_);
  return *repair_;
}

bool RoundingAttempt::run() {
  if (rounded_.anything_moved()) {
    // Each change leaves fewer vertices, or as many and less that is wrong.
    for (auto faulty = faulty_triangles(rounded_, kernel_, steps_.part(0.5)); !faulty.empty();
         faulty = faulty_triangles(rounded_, kernel_, steps_.part(0.5))) {
      has_lines_that_meet_ = std::ranges::any_of(faulty, [&](std::uint32_t t) {
        return std::ranges::any_of(rounded_.corners[t],
                                   [&](std::uint32_t v) { return rounded_.is_apart(v); });
      });
      if (has_lines_that_meet_) return false;
      stuck_ = repair().run(std::move(faulty));
      if (!stuck_.empty()) return false;
    }
  }
  if (options_.separate_touching && !separate()) return false;
  make_mesh();
  if ((!rounded_.anything_moved() && separated_ == 0) || triangle_.empty()) return true;
  const std::uint32_t wrong = wrong_shell();
  if (wrong == none) return true;
  stuck_ = {wrong};
  shell_is_wrong_ = true;
  return false;
}

bool RoundingAttempt::separate() {
  const auto [moved, most_at_a_place, cramped] =
      Separation(rounded_, kernel_, grid_, options_).run();
  separated_ = rounded_.moved_apart() + moved;
  if (cramped.empty()) {
    if (most_at_a_place <= small_crowd) check_separated();
    return true;
  }
  is_cramped_ = true;
  std::vector<std::uint8_t> touches(rounded_.point.size(), 0);
  for (const std::uint32_t v : cramped) touches[v] = 1;
  for (std::uint32_t t = 0; t < rounded_.corners.size(); ++t) {
    const RoundedSurface::Corners& c = rounded_.corners[t];
    if (rounded_.alive[t] != 0 && (touches[c[0]] | touches[c[1]] | touches[c[2]]) != 0)
      stuck_.push_back(t);
  }
  return false;
}

// What was told apart by cones meets nowhere, if all is right. The self-test compares all of a
// crowd with each other.
void RoundingAttempt::check_separated() {
  if (separated_ == rounded_.moved_apart()) return;
  kernel_.refresh();
  if (!faulty_triangles(rounded_, kernel_, steps_.part(0.5)).empty())
    throw InternalError("what was moved apart meets");
}

void RoundingAttempt::make_mesh() {
  std::vector<std::uint32_t> number(rounded_.point.size(), none);
  for (std::uint32_t t = 0; t < rounded_.corners.size(); ++t) {
    if (t % 0x10000 == 0) steps_.check();
    if (rounded_.alive[t] == 0) continue;
    for (const std::uint32_t v : rounded_.corners[t]) {
      if (number[v] == none) {
        number[v] = static_cast<std::uint32_t>(mesh_.positions.size());
        mesh_.positions.push_back(rounded_.position(v));
      }
      mesh_.indices.push_back(number[v]);
    }
    mesh_.face_sizes.push_back(3);
    sources_.push_back(rounded_.source[t]);
    triangle_.push_back(t);
  }
}

// What no two faces show: a shell that was turned inside out, or came to lie in another one. A
// triangle of it, or none.
std::uint32_t RoundingAttempt::wrong_shell() const {
  if (is_one_shell() && clearly_encloses_volume(mesh_.positions, mesh_.indices)) return none;
  const std::optional<std::uint32_t> face = face_of_wrong_shell(mesh_, options_.cancel);
  return face ? triangle_[*face] : none;
}

bool RoundingAttempt::is_one_shell() const {
  std::vector<std::uint8_t> seen(rounded_.corners.size(), 0);
  std::vector<std::uint32_t> front{triangle_.front()};
  seen[front.front()] = 1;
  std::size_t count = 1;
  while (!front.empty()) {
    const std::uint32_t t = front.back();
    front.pop_back();
    for (const std::uint32_t mate : rounded_.surface.mate[t]) {
      if (seen[mate] != 0) continue;
      seen[mate] = 1;
      ++count;
      front.push_back(mate);
    }
  }
  return count == triangle_.size();
}

double RoundingAttempt::move_of(std::uint32_t vertex, const Vec3& to) const {
  const Vec3& from = rounded_.origin[vertex];
  double move = std::hypot(to.x - from.x, to.y - from.y, to.z - from.z) + before_.at(from);
  // The place itself is off by half a unit in the last place of each coordinate at most.
  if (rounded_.is_exact[vertex] == 0) {
    const double half = 0x1p-53;
    move += std::hypot(half * from.x, half * from.y, half * from.z);
  }
  return move;
}

void RoundingAttempt::take(RoundedMesh& result) {
  note_report(result.report);
  result.mesh = std::move(mesh_);
  result.sources = std::move(sources_);
}

void RoundingAttempt::note_report(RoundingReport& report) const {
  if (repair_) {
    report.merged += repair_->merged();
    report.flipped += repair_->flipped();
  }
  report.separated = separated_;
  report.largest_move = before_.largest();
  report.largest_at = before_.largest_at();
  if (repair_ && repair_->widest_flip() > report.largest_move) {
    report.largest_move = repair_->widest_flip();
    report.largest_at = repair_->widest_flip_at();
  }
  std::vector<double> moves;
  for (std::uint32_t v = 0; v < rounded_.point.size(); ++v) {
    const Vec3& to = rounded_.position(repair_ ? repair_->gone_to(v) : v);
    if (!(to == grid_.nearest(rounded_.origin[v]))) ++report.displaced;
    const double move = move_of(v, to);
    if (move == 0) continue;
    moves.push_back(move);
    if (move <= report.largest_move) continue;
    report.largest_move = move;
    report.largest_at = rounded_.origin[v];
  }
  report.moved = moves.size();
  if (moves.empty()) return;
  const auto middle = moves.begin() + static_cast<std::ptrdiff_t>(moves.size() / 2);
  std::nth_element(moves.begin(), middle, moves.end());
  report.median_move = *middle;
}

std::vector<std::uint8_t> RoundingAttempt::vertices_near_stuck(double distance) const {
  std::vector<Surroundings> around;
  std::vector<Box> boxes;
  for (const std::uint32_t t : stuck_) {
    Surroundings s;
    Bounds bounds;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& p = rounded_.position(rounded_.corners[t][k]);
      s.low =
          k == 0 ? p : Vec3{std::min(s.low.x, p.x), std::min(s.low.y, p.y), std::min(s.low.z, p.z)};
      s.high =
          k == 0 ? p
                 : Vec3{std::max(s.high.x, p.x), std::max(s.high.y, p.y), std::max(s.high.z, p.z)};
    }
    bounds.add({s.low.x - distance, s.low.y - distance, s.low.z - distance});
    bounds.add({s.high.x + distance, s.high.y + distance, s.high.z + distance});
    around.push_back(s);
    boxes.push_back(bounds.box());
  }
  const BoxTree tree(boxes);
  std::vector<std::uint8_t> near(rounded_.point.size(), 0);
  for (std::uint32_t v = 0; v < near.size(); ++v) {
    const Vec3& p = rounded_.position(v);
    tree.query([&](const Box& b) { return near[v] == 0 && b.contains(p); },
               [&](std::uint32_t i) { near[v] = near[v] != 0 || around[i].contain(p, distance); });
  }
  return near;
}

std::shared_ptr<const SolidData> RoundingAttempt::coarser(double coarseness, Displacement& moved) {
  double step = 0;
  for (const std::uint32_t t : stuck_)
    for (const std::uint32_t v : rounded_.corners[t])
      step = std::max(step, grid_.step(rounded_.position(v)));
  const double spacing = coarseness * step;
  // To resolve a shell that lies in another one, or is inside out, nothing has to move at first.
  const std::vector<std::uint8_t> near = shell_is_wrong_ && before_.largest() == 0
                                             ? std::vector<std::uint8_t>(rounded_.point.size(), 0)
                                             : vertices_near_stuck(spacing);
  TriangleSoup soup;
  for (std::uint32_t v = 0; v < rounded_.point.size(); ++v) {
    const Vec3& p = rounded_.position(v);
    soup.positions.push_back(near[v] != 0 ? grid_.nearest({nearest_multiple(p.x, spacing),
                                                           nearest_multiple(p.y, spacing),
                                                           nearest_multiple(p.z, spacing)})
                                          : p);
  }
  for (std::uint32_t v = 0; v < rounded_.point.size(); ++v) {
    const Vec3& to = soup.positions[repair_ ? repair_->gone_to(v) : v];
    moved.add(to, move_of(v, to));
  }
  for (std::uint32_t t = 0; t < rounded_.corners.size(); ++t) {
    if (rounded_.alive[t] == 0) continue;
    soup.corners.push_back(rounded_.corners[t]);
    soup.source.push_back(rounded_.source[t]);
  }
  return resolved(soup, {options_.cancel, {}});
}

}  // namespace sectile
