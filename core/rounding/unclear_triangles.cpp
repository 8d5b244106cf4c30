#include "rounding/unclear_triangles.h"

#include <algorithm>

#include "parallel/parallel.h"
#include "parallel/scratch.h"
#include "rounding/clear_pairs.h"
#include "search/box_index.h"
#include "search/curve_order.h"

namespace sectile {
namespace {

// Of very many triangles, as around hubs, in faces of many corners and where all is long and thin,
// boxes overlap. The exact test has its own ways then: it gets what meets more than these.
constexpr int most_pairs = 1024;

class Finder {
  using Triangles = RoundedTriangles::Triangles;

 public:
  Finder(const RoundedTriangles& mesh, const RoundingSteps& steps)
      : mesh_(mesh), steps_(steps), slack_(mesh.farthest_move()) {}

  UnclearTriangles run() {
    look_at(mesh_.unsettled());
    if (!moved_.empty()) {
      meet_each_other();
      meet_others();
    }
    found_.for_each([&](const UnclearTriangles& some) {
      result_.all.insert(result_.all.end(), some.all.begin(), some.all.end());
      give_up(some.not_looked_at);
    });
    sort(result_.all);
    sort(result_.not_looked_at);
    return std::move(result_);
  }

 private:
  // Those without area are unclear, also among those that did not move.
  void look_at(const Triangles& unsettled) {
    std::vector<ViewedTriangle> viewed(unsettled.size());
    parallel::loop(parallel::Range<std::size_t>(0, viewed.size(), 1024), [&](const auto& range) {
      for (std::size_t i = range.begin(); i < range.end(); ++i)
        viewed[i] = ViewedTriangle(placed(unsettled[i]), slack_);
    });
    std::vector<std::uint32_t> clear;
    std::vector<Box> boxes;
    for (std::uint32_t i = 0; i < viewed.size(); ++i) {
      if (!viewed[i].view.clear()) {
        give_up({unsettled[i]});
        continue;
      }
      clear.push_back(i);
      boxes.push_back(box_of(viewed[i].placed, 2 * slack_));
    }
    for (const std::uint32_t t : mesh_.cut())
      if (!mesh_.is_unsettled(t) && !ViewedTriangle(placed(t), 0).view.clear()) give_up({t});
    const std::vector<std::uint32_t> order = order_along_curve(boxes);
    std::vector<Box> ordered;
    for (const std::uint32_t i : order) {
      moved_.push_back(viewed[clear[i]]);
      number_.push_back(unsettled[clear[i]]);
      ordered.push_back(boxes[i]);
    }
    index_ = BoxIndex(ordered, true);
  }
  void give_up(const Triangles& triangles) {
    for (Triangles* all : {&result_.all, &result_.not_looked_at})
      all->insert(all->end(), triangles.begin(), triangles.end());
  }

  void meet_each_other() {
    parallel::loop(parallel::Range<std::size_t>(0, moved_.size(), 64), [&](const auto& range) {
      steps_.check();
      found_.lend([&](UnclearTriangles& found) {
        for (std::size_t j = range.begin(); j < range.end(); ++j)
          meet_moved(number_[j], moved_[j], static_cast<std::uint32_t>(j), found);
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
    found_.lend([&](UnclearTriangles& found) {
      const auto [first, end] = mesh_.triangles(s);
      for (std::uint32_t t = first; t < end; ++t) {
        if (mesh_.is_unsettled(t)) continue;
        const PlacedTriangle at = placed(t);
        if (index_.any_overlaps(box_of(at, 0)))
          meet_moved(t, ViewedTriangle(at, slack_), static_cast<std::uint32_t>(moved_.size()),
                     found);
      }
    });
  }

  // The first ones of those that moved against another triangle.
  void meet_moved(std::uint32_t t, const ViewedTriangle& triangle, std::uint32_t first,
                  UnclearTriangles& found) const {
    int pairs = 0;
    const bool few = index_.overlapping(box_of(triangle.placed, 0), first, [&](std::uint32_t i) {
      if (++pairs > most_pairs) return false;
      if (clearly_meet_in_corners(moved_[i], triangle, slack_)) return true;
      found.all.push_back(number_[i]);
      found.all.push_back(t);
      return true;
    });
    if (!few) found.not_looked_at.push_back(t);
  }

  static void sort(Triangles& triangles) {
    std::sort(triangles.begin(), triangles.end());
    triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
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
  parallel::Scratch<UnclearTriangles> found_;
  UnclearTriangles result_;
};

}  // namespace

UnclearTriangles unclear_triangles(const RoundedTriangles& mesh, const RoundingSteps& steps) {
  return Finder(mesh, steps).run();
}

}  // namespace sectile
