#include "rounding/unclear_triangles.h"

#include <algorithm>
#include <optional>

#include "parallel/parallel.h"
#include "parallel/scratch.h"
#include "rounding/flat_groups.h"

namespace sectile {
namespace {

// Of very many triangles, as around hubs, in faces of many corners and where all is long and thin,
// boxes overlap. The exact test has its own ways then: it gets what meets more than these.
constexpr int most_pairs = 1024;

class Finder {
  using Triangles = RoundedTriangles::Triangles;

 public:
  Finder(const RoundedTriangles& mesh, const RoundingSteps& steps)
      : mesh_(mesh), steps_(steps), slack_(mesh.farthest_move()), unsettled_(mesh.unsettled()) {}

  UnclearTriangles run() {
    look_at();
    if (moved_.size() > 0) {
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
  void look_at() {
    std::vector<ViewedTriangle> viewed(unsettled_.size());
    std::vector<Box> boxes(unsettled_.size());
    parallel::loop(parallel::Range<std::size_t>(0, viewed.size(), 1024), [&](const auto& range) {
      for (std::size_t i = range.begin(); i < range.end(); ++i) {
        viewed[i] = ViewedTriangle(placed(unsettled_[i]), slack_);
        boxes[i] = box_around(viewed[i].placed, 2 * slack_);
      }
    });
    // The pieces of a face come one after another.
    std::vector<std::uint32_t> clear, ends;
    for (std::uint32_t i = 0; i < viewed.size(); ++i) {
      if (!viewed[i].view.clear()) {
        give_up({unsettled_[i]});
        continue;
      }
      if (!clear.empty() && mesh_.source(unsettled_[clear.back()]) != mesh_.source(unsettled_[i]))
        ends.push_back(static_cast<std::uint32_t>(clear.size()));
      clear.push_back(i);
    }
    for (const std::uint32_t t : mesh_.cut())
      if (!mesh_.is_unsettled(t) && !ViewedTriangle(placed(t), 0).view.clear()) give_up({t});
    if (clear.empty()) return;
    ends.push_back(static_cast<std::uint32_t>(clear.size()));
    moved_ = FlatGroups(viewed, boxes, std::move(clear), ends, slack_, extent());
  }
  std::uint32_t number(std::uint32_t place) const { return unsettled_[moved_.chosen(place)]; }

  // No two coordinates are farther apart.
  double extent() const {
    Box all;
    for (std::size_t s = 0; s < mesh_.slot_count(); ++s) all.add(mesh_.bounds(s));
    double extent = 0;
    for (int k = 0; k < 3; ++k) extent = std::max(extent, double(all.high[k]) - double(all.low[k]));
    return extent * (1 + 0x1p-40);
  }
  void give_up(const Triangles& triangles) {
    for (Triangles* all : {&result_.all, &result_.not_looked_at})
      all->insert(all->end(), triangles.begin(), triangles.end());
  }

  // Groups along the curve, some at one go.
  void meet_each_other() {
    constexpr std::uint32_t some = 32;
    parallel::loop(0, (moved_.count() + some - 1) / some, [&](std::size_t part) {
      steps_.check();
      const auto first = static_cast<std::uint32_t>(part) * some,
                 end = std::min(first + some, moved_.count());
      Box all;
      for (std::uint32_t g = first; g < end; ++g) all.add(moved_.box(g));
      const FlatGroups::Selection near = moved_.near(all, end);
      found_.lend([&](UnclearTriangles& found) {
        for (std::uint32_t j = moved_.first(first); j < moved_.first(end); ++j) {
          const ViewedTriangle& t = moved_.triangle(j);
          const auto view = [&]() -> const ViewedTriangle& { return t; };
          meet_moved(number(j), t.placed, view, near, j, found);
        }
      });
    });
  }

  void meet_others() {
    parallel::loop(0, mesh_.slot_count(), [&](std::size_t s) {
      steps_.check();
      const FlatGroups::Selection near = moved_.near(mesh_.bounds(s), moved_.count());
      if (!near.is_empty()) meet_slot(s, near);
    });
  }

  // Those of the slot that did not move against those that did.
  void meet_slot(std::size_t s, const FlatGroups::Selection& near) {
    found_.lend([&](UnclearTriangles& found) {
      const auto [first, end] = mesh_.triangles(s);
      for (std::uint32_t t = first; t < end; ++t) {
        if (mesh_.is_unsettled(t)) continue;
        const PlacedTriangle at = placed(t);
        std::optional<ViewedTriangle> viewed;  // as soon as anything is near
        const auto view = [&]() -> const ViewedTriangle& {
          return viewed ? *viewed : viewed.emplace(at, slack_);
        };
        meet_moved(t, at, view, near, moved_.size(), found);
      }
    });
  }

  // A triangle with those that moved and come before `end`.
  template <class View>
  void meet_moved(std::uint32_t t, const PlacedTriangle& at, const View& view,
                  const FlatGroups::Selection& near, std::uint32_t end,
                  UnclearTriangles& found) const {
    int pairs = 0;
    const bool few = moved_.near(near, at, box_around(at, 0), end, [&](std::uint32_t place) {
      if (++pairs > most_pairs) return false;
      if (clearly_meet_in_corners(moved_.triangle(place), view(), slack_)) return true;
      found.all.push_back(number(place));
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
  const RoundedTriangles& mesh_;
  const RoundingSteps& steps_;
  const double slack_;
  const Triangles unsettled_;
  FlatGroups moved_;  // those of them that are looked at here
  parallel::Scratch<UnclearTriangles> found_;
  UnclearTriangles result_;
};

}  // namespace

UnclearTriangles unclear_triangles(const RoundedTriangles& mesh, const RoundingSteps& steps) {
  return Finder(mesh, steps).run();
}

}  // namespace sectile
