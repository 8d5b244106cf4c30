#include "rounding/unclear_triangles.h"

#include <algorithm>
#include <optional>

#include "parallel/parallel.h"
#include "parallel/scratch.h"
#include "rounding/clear_pairs.h"
#include "search/box_index.h"

namespace sectile {
namespace {

// Of very many triangles, as around hubs, in faces of many corners and where all is long and thin,
// boxes overlap. The exact test has its own ways then: it gets what meets more than these. And it
// is faster where most triangles moved.
constexpr int most_pairs = 1024;

class UnclearTriangles {
  using Triangles = RoundedTriangles::Triangles;

 public:
  UnclearTriangles(const RoundedTriangles& mesh, const RoundingSteps& steps)
      : mesh_(mesh), steps_(steps), slack_(mesh.farthest_move()) {}

  Triangles run() {
    const Triangles unsettled = mesh_.unsettled();
    if (2 * unsettled.size() > mesh_.size()) return united(unsettled, flat_cut_ones());
    look_at(unsettled);
    if (!moved_.empty()) {
      meet_each_other();
      meet_others();
    }
    unclear_.for_each(
        [&](const Triangles& some) { result_.insert(result_.end(), some.begin(), some.end()); });
    return united(std::move(result_), flat_cut_ones());
  }

 private:
  // Those without area are unclear.
  void look_at(const Triangles& unsettled) {
    std::vector<Box> boxes;
    for (const std::uint32_t t : unsettled) {
      const ViewedTriangle triangle(placed(t), slack_);
      if (!triangle.view.clear()) {
        result_.push_back(t);
        continue;
      }
      moved_.push_back(triangle);
      number_.push_back(t);
      boxes.push_back(box_of(triangle.placed, 2 * slack_));
    }
    index_ = BoxIndex(boxes);
  }

  void meet_each_other() {
    parallel::loop(tbb::blocked_range<std::size_t>(0, moved_.size(), 64), [&](const auto& range) {
      steps_.check();
      unclear_.lend([&](Triangles& unclear) {
        for (std::size_t j = range.begin(); j < range.end(); ++j)
          meet_moved(number_[j], moved_[j].placed, static_cast<std::uint32_t>(j), unclear);
      });
    });
  }

  void meet_others() {
    parallel::loop(0, mesh_.slot_count(), [&](std::size_t s) {
      steps_.check();
      if (index_.any_overlaps(mesh_.bounds(s))) meet_slot(s);
    });
  }

  // Those of the slot that did not move against those that did.
  void meet_slot(std::size_t s) {
    unclear_.lend([&](Triangles& unclear) {
      const auto [first, end] = mesh_.triangles(s);
      for (std::uint32_t t = first; t < end; ++t)
        if (!mesh_.is_unsettled(t))
          meet_moved(t, placed(t), static_cast<std::uint32_t>(moved_.size()), unclear);
    });
  }

  // The first ones of those that moved against another triangle.
  void meet_moved(std::uint32_t t, const PlacedTriangle& at, std::uint32_t end,
                  Triangles& unclear) const {
    std::optional<ViewedTriangle> viewed;
    const auto triangle = [&]() -> const ViewedTriangle& {
      return viewed ? *viewed : viewed.emplace(at, slack_);
    };
    int pairs = 0;
    const bool few = index_.overlapping(box_of(at, 0), [&](std::uint32_t i) {
      if (i >= end) return true;
      if (++pairs > most_pairs) return false;
      if (clearly_meet_in_corners(moved_[i], triangle(), slack_)) return true;
      unclear.push_back(number_[i]);
      unclear.push_back(t);
      return true;
    });
    if (!few) unclear.push_back(t);
  }

  // Of those that did not move, which may have no area.
  Triangles flat_cut_ones() const {
    Triangles flat;
    for (const std::uint32_t t : mesh_.cut())
      if (!mesh_.is_unsettled(t) && !ViewedTriangle(placed(t), 0).view.clear()) flat.push_back(t);
    return flat;
  }

  // Ascending.
  static Triangles united(Triangles a, const Triangles& b) {
    a.insert(a.end(), b.begin(), b.end());
    std::sort(a.begin(), a.end());
    a.erase(std::unique(a.begin(), a.end()), a.end());
    return a;
  }

  PlacedTriangle placed(std::uint32_t t) const {
    const RoundedTriangles::Corners c = mesh_.corners(t);
    const std::vector<Vec3>& at = mesh_.positions();
    return {c, {at[c[0]], at[c[1]], at[c[2]]}};
  }
  static Box box_of(const PlacedTriangle& triangle, double wider) {
    Bounds bounds;
    for (const Vec3& p : triangle.at) bounds.add(p);
    bounds.low = {bounds.low.x - wider, bounds.low.y - wider, bounds.low.z - wider};
    bounds.high = {bounds.high.x + wider, bounds.high.y + wider, bounds.high.z + wider};
    return bounds.box();
  }

  const RoundedTriangles& mesh_;
  const RoundingSteps& steps_;
  const double slack_;
  std::vector<ViewedTriangle> moved_;  // those that are looked at here
  std::vector<std::uint32_t> number_;  // of each
  BoxIndex index_;                     // of them
  parallel::Scratch<Triangles> unclear_;
  Triangles result_;
};

}  // namespace

RoundedTriangles::Triangles unclear_triangles(const RoundedTriangles& mesh,
                                              const RoundingSteps& steps) {
  return UnclearTriangles(mesh, steps).run();
}

}  // namespace sectile
