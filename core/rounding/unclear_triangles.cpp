#include "rounding/unclear_triangles.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <utility>

#include "numbers/threshold.h"
#include "parallel/parallel.h"
#include "parallel/scratch.h"
#include "rounding/clear_stars.h"
#include "rounding/flat_groups.h"

namespace sectile {
namespace {

// How much each triangle may meet. Where all is long and thin, around hubs and in faces of many
// corners, boxes of very many overlap. Then oriented boxes tell them apart, or else the exact test,
// which has its own ways: it gets what meets more than this.
struct Patience {
  std::uint32_t groups_by_boxes;  // beyond these, oriented boxes are asked
  std::uint32_t groups, pairs;
};
constexpr Patience normal = threshold(Patience{0xFFFFFFFFu, 8192, 1024}, Patience{1, 64, 16}),
                   little = threshold(Patience{8, 256, 32}, Patience{1, 32, 8});
// Patience ends when so much more was met, for each triangle that moved.
constexpr std::uint64_t most_beyond = 16;

class Finder {
  using Triangles = RoundedTriangles::Triangles;

 public:
  Finder(const RoundedTriangles& mesh, const RoundingSteps& steps)
      : mesh_(mesh), steps_(steps), slack_(mesh.farthest_move()), unsettled_(mesh.unsettled()) {}

  UnclearTriangles run() {
    parallel::invoke([&] { look_at(); },
                     [&] { clear_stars_ = clear_stars(mesh_, unsettled_, slack_); });
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
    // The pieces of a face come one after another.
    std::vector<std::uint32_t> ends;
    for (std::uint32_t i = 1; i < unsettled_.size(); ++i)
      if (mesh_.source(unsettled_[i]) != mesh_.source(unsettled_[i - 1])) ends.push_back(i);
    if (!unsettled_.empty()) ends.push_back(static_cast<std::uint32_t>(unsettled_.size()));
    moved_ =
        FlatGroups([&](std::uint32_t i) { return placed(unsettled_[i]); }, ends, slack_, extent());
    for (std::uint32_t place = 0; place < moved_.size(); ++place)
      if (!moved_.triangle(place).view.clear()) give_up({number(place)});
    for (const std::uint32_t t : mesh_.cut())
      if (!mesh_.is_unsettled(t) && !ViewedTriangle(placed(t), 0).view.clear()) give_up({t});
  }
  std::uint32_t number(std::uint32_t place) const { return unsettled_[moved_.number(place)]; }

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

  void meet_each_other() {
    constexpr std::uint32_t some = 32;
    parallel::loop(0, (moved_.count() + some - 1) / some, [&](std::size_t part) {
      steps_.check();
      found_.lend([&](UnclearTriangles& found) {
        const auto first = static_cast<std::uint32_t>(part) * some;
        for (std::uint32_t g = first; g < std::min(first + some, moved_.count()); ++g)
          meet_before(g, found);
      });
    });
  }

  // A group with itself and with those before it.
  void meet_before(std::uint32_t g, UnclearTriangles& found) const {
    const std::uint32_t first = moved_.first(g), end = moved_.first(g + 1);
    const Patience patience = this->patience();
    std::uint32_t groups = 0, pairs = 0, last = none;
    ClearCorners clear;
    const auto oriented = [&]() -> const OrientedBox& { return moved_.oriented(g); };
    const auto meet = [&](std::uint32_t i, std::uint32_t j) {
      if (++pairs > patience.pairs * (end - first)) return false;
      const ViewedTriangle &s = moved_.triangle(i), &t = moved_.triangle(j);
      if (std::exchange(last, i) != i) clear = clear_corners(s.placed);
      if (!clear.any_of(t.placed) && !clearly_meet_in_corners(s, t, slack_))
        found.all.insert(found.all.end(), {number(i), number(j)});
      return true;
    };
    const auto meet_group = [&](std::uint32_t h) {
      return ++groups <= patience.groups && moved_.near_pairs(g, h, meet);
    };
    const bool all_met =
        moved_.overlapping(moved_.box(g), patience.groups_by_boxes, oriented, g + 1, meet_group);
    note(groups, pairs / (end - first));
    if (all_met) return;
    for (std::uint32_t i = first; i < end; ++i) found.not_looked_at.push_back(number(i));
  }

  void meet_others() {
    parallel::loop(0, mesh_.slot_count(), [&](std::size_t s) {
      steps_.check();
      if (!moved_.any_overlaps(mesh_.bounds(s))) return;
      found_.lend([&](UnclearTriangles& found) { meet_slot(s, found); });
    });
  }

  // Those of the slot that did not move against those that did, some at one go.
  void meet_slot(std::size_t s, UnclearTriangles& found) const {
    Few few;
    const auto [first, end] = mesh_.triangles(s);
    for (std::uint32_t t = first; t < end; ++t) {
      if (mesh_.is_unsettled(t)) continue;
      few.number[few.count++] = t;
      for (const std::uint32_t v : mesh_.corners(t)) few.bounds.add(mesh_.positions()[v]);
      if (few.count < Few::most) continue;
      meet_moved(few, found);
      few.count = 0;
      few.bounds = Bounds();
    }
    if (few.count > 0) meet_moved(few, found);
  }

  // One that is not beside the plane of another one: this may be beside its own.
  bool clearly_meet(const ViewedTriangle& t, const ViewedTriangle& other) const {
    return t.view.clear() ? clearly_meet_in_corners(t, other, slack_)
                          : clearly_meet_in_corners(other, t, slack_);
  }

  // Of a triangle, those at which all is clear.
  struct ClearCorners {
    std::array<std::uint32_t, 3> vertex;
    bool any_of(const PlacedTriangle& other) const {
      bool any = false;
      for (const std::uint32_t v : vertex)
        for (const std::uint32_t w : other.vertex) any |= v == w;
      return any;
    }
  };

  // Triangles that come one after another.
  struct Few {
    static constexpr unsigned most = 8;
    std::array<std::uint32_t, most> number;
    unsigned count = 0;
    Bounds bounds;
    // Once anything is near them all.
    std::array<PlacedTriangle, most> placed;
    std::array<Box, most> box;
    std::array<ClearCorners, most> clear_corners;
    std::array<std::uint32_t, most> pairs;
    EightBoxes boxes;
    // Of those whose bit is set: once anything is near them.
    std::array<ViewedTriangle, most> viewed;
    std::array<OrientedBox, most> oriented;  // where many groups are near
    unsigned is_viewed, is_oriented;

    const ViewedTriangle& view(unsigned i, double slack) {
      if ((is_viewed >> i & 1) == 0) viewed[i] = ViewedTriangle(placed[i], slack);
      is_viewed |= 1u << i;
      return viewed[i];
    }
    const OrientedBox& oriented_box(unsigned i) {
      if ((is_oriented >> i & 1) == 0) oriented[i] = OrientedBox(placed[i].at);
      is_oriented |= 1u << i;
      return oriented[i];
    }
  };

  void look_at(Few& few) const {
    few.boxes = EightBoxes();
    few.pairs = {};
    few.is_viewed = few.is_oriented = 0;
    for (unsigned i = 0; i < few.count; ++i) {
      few.placed[i] = placed(few.number[i]);
      few.box[i] = box_around(few.placed[i], 0);
      few.boxes.set(i, few.box[i]);
      few.clear_corners[i] = clear_corners(few.placed[i]);
    }
  }

  void meet_moved(Few& few, UnclearTriangles& found) const {
    const Patience patience = this->patience();
    std::uint32_t groups = 0;
    unsigned left = ~0u >> (32 - few.count);
    bool looked = false;
    const auto leave = [&](unsigned i) {
      left &= ~(1u << i);
      found.not_looked_at.push_back(few.number[i]);
    };
    const Box all = few.bounds.box();
    const auto oriented = [&] { return around(few); };
    const auto meet = [&](std::uint32_t g) {
      if (++groups > patience.groups) return false;
      if (moved_.slab(g).always_clear_of(all)) return true;
      if (!std::exchange(looked, true)) look_at(few);
      for (unsigned hit = few.boxes.overlapping(moved_.box(g)) & left; hit != 0; hit &= hit - 1) {
        const auto i = static_cast<unsigned>(std::countr_zero(hit));
        if (groups > patience.groups_by_boxes && apart(moved_.oriented(g), few.oriented_box(i)))
          continue;
        if (!meet_group(few, i, g, patience.pairs, found)) leave(i);
      }
      return true;
    };
    const bool all_met =
        moved_.overlapping(all, patience.groups_by_boxes, oriented, moved_.count(), meet);
    note(groups, looked ? *std::max_element(few.pairs.begin(), few.pairs.end()) : 0);
    if (!all_met)
      while (left != 0) leave(static_cast<unsigned>(std::countr_zero(left)));
  }

  OrientedBox around(const Few& few) const {
    std::array<Vec3, 3 * Few::most> points;
    std::size_t count = 0;
    for (unsigned i = 0; i < few.count; ++i)
      for (const std::uint32_t v : mesh_.corners(few.number[i]))
        points[count++] = mesh_.positions()[v];
    return OrientedBox(std::span(points).first(count));
  }

  // False if it would be too many.
  bool meet_group(Few& few, unsigned i, std::uint32_t g, std::uint32_t most_pairs,
                  UnclearTriangles& found) const {
    return moved_.near(g, few.placed[i], few.box[i], [&](std::uint32_t place) {
      if (++few.pairs[i] > most_pairs) return false;
      const ViewedTriangle& s = moved_.triangle(place);
      if (!few.clear_corners[i].any_of(s.placed) && !clearly_meet(few.view(i, slack_), s))
        found.all.insert(found.all.end(), {number(place), few.number[i]});
      return true;
    });
  }

  Patience patience() const {
    return beyond_.load(std::memory_order_relaxed) > most_beyond * moved_.size() ? little : normal;
  }
  void note(std::uint32_t groups, std::uint32_t pairs) const {
    const auto beyond = [](std::uint32_t count, std::uint32_t few) {
      return count > few ? count - few : 0;
    };
    const std::uint32_t more = beyond(groups, little.groups_by_boxes) + beyond(pairs, little.pairs);
    if (more > 0) beyond_.fetch_add(more, std::memory_order_relaxed);
  }

  ClearCorners clear_corners(const PlacedTriangle& t) const {
    ClearCorners clear;
    for (std::size_t k = 0; k < 3; ++k)
      clear.vertex[k] = clear_stars_[t.vertex[k]] != 0 ? t.vertex[k] : none;
    return clear;
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
  static constexpr std::uint32_t none = 0xFFFFFFFFu;
  const RoundedTriangles& mesh_;
  const RoundingSteps& steps_;
  const double slack_;
  const Triangles unsettled_;
  FlatGroups moved_;                       // those of them that are looked at here
  std::vector<std::uint8_t> clear_stars_;  // per vertex
  mutable std::atomic<std::uint64_t> beyond_ = 0;
  parallel::Scratch<UnclearTriangles> found_;
  UnclearTriangles result_;
};

}  // namespace

UnclearTriangles unclear_triangles(const RoundedTriangles& mesh, const RoundingSteps& steps) {
  return Finder(mesh, steps).run();
}

}  // namespace sectile
