#include "rounding/unclear_triangles.h"

#include <algorithm>
#include <atomic>

#include "parallel/parallel.h"
#include "parallel/scratch.h"
#include "rounding/clear_pairs.h"
#include "search/box_tree.h"

namespace sectile {
namespace {

// Around hubs boxes of very many triangles overlap, and those within faces of many corners. The
// exact test has its own ways then, and where most triangles moved: it gets these at once, and
// everything if there are still more pairs than these.
constexpr std::uint8_t most_around_a_corner = 24;
constexpr std::size_t most_of_a_face = 64;
constexpr std::size_t pairs_per_triangle = 64, pairs_at_least = 0x4000;

class UnclearTriangles {
  using Triangles = RoundedTriangles::Triangles;

 public:
  explicit UnclearTriangles(const RoundedTriangles& mesh) : mesh_(mesh) {}

  Triangles run() {
    const Triangles unsettled = mesh_.unsettled();
    if (2 * unsettled.size() > mesh_.size()) return united(unsettled, flat_cut_ones());
    look_at(unsettled);
    if (!moved_.empty()) {
      most_pairs_ = pairs_at_least + pairs_per_triangle * moved_.size();
      meet_each_other();
      meet_others();
    }
    if (is_crowded()) return united(unsettled, flat_cut_ones());
    unclear_.for_each(
        [&](const Triangles& some) { result_.insert(result_.end(), some.begin(), some.end()); });
    return united(std::move(result_), flat_cut_ones());
  }

 private:
  // Stops where there are too many pairs.
  struct NothingApart : BoxTree::NothingApart {
    const UnclearTriangles& all;
    bool nodes(BoxTree::Node, BoxTree::Node) const { return all.is_crowded(); }
  };

  // Those around hubs, of large faces, and without area are unclear.
  void look_at(const Triangles& unsettled) {
    std::vector<std::uint8_t> around(mesh_.positions().size(), 0);
    for (const std::uint32_t t : unsettled)
      for (const std::uint32_t v : mesh_.corners(t))
        if (around[v] <= most_around_a_corner) ++around[v];
    const std::vector<std::uint8_t> of_large_face = of_large_faces();
    for (const std::uint32_t t : unsettled) {
      const RoundedTriangles::Corners c = mesh_.corners(t);
      const bool at_hub =
          std::max({around[c[0]], around[c[1]], around[c[2]]}) > most_around_a_corner;
      const TriangleView view =
          at_hub || of_large_face[t] != 0 ? TriangleView() : clear_view(placed(t));
      if (!view.clear()) {
        result_.push_back(t);
        continue;
      }
      moved_.push_back(t);
      views_.push_back(view);
    }
    std::vector<Box> boxes(moved_.size());
    for (std::size_t i = 0; i < boxes.size(); ++i) boxes[i] = mesh_.box(moved_[i]);
    tree_ = BoxTree(boxes, {}, true);
  }

  void meet_each_other() {
    const std::vector<BoxTree::SelfPart> parts = tree_.self_parts(256);
    parallel::loop(0, parts.size(), [&](std::size_t p) {
      unclear_.lend([&](Triangles& unclear) {
        std::size_t pairs = 0;
        tree_.self_overlaps(
            parts[p],
            [&](std::uint32_t i, std::uint32_t j) {
              count(pairs);
              meet(i, moved_[j], unclear);
            },
            NothingApart{{}, *this});
        pairs_ += pairs;
      });
    });
  }

  void meet_others() {
    parallel::loop(0, mesh_.slot_count(), [&](std::size_t s) {
      const Box& bounds = mesh_.bounds(s);
      bool any = false;
      tree_.query([&](const Box& b) { return !any && b.overlaps(bounds); },
                  [&](std::uint32_t) { any = true; });
      if (any) meet_slot(s);
    });
  }

  // Those of the slot that did not move against those that did.
  void meet_slot(std::size_t s) {
    const auto [first, end] = mesh_.triangles(s);
    Triangles others;
    std::vector<Box> boxes;
    for (std::uint32_t t = first; t < end; ++t) {
      if (mesh_.is_unsettled(t)) continue;
      others.push_back(t);
      boxes.push_back(mesh_.box(t));
    }
    if (others.empty()) return;
    unclear_.lend([&](Triangles& unclear) {
      std::size_t pairs = 0;
      BoxTree::overlaps(
          tree_, BoxTree(boxes, {}, true),
          [&](std::uint32_t i, std::uint32_t j) {
            count(pairs);
            meet(i, others[j], unclear);
          },
          [](std::uint32_t, std::uint32_t) { return false; }, NothingApart{{}, *this});
      pairs_ += pairs;
    });
  }

  void meet(std::uint32_t i, std::uint32_t t, Triangles& unclear) const {
    if (clearly_meet_in_corners(placed(moved_[i]), views_[i], placed(t))) return;
    unclear.push_back(moved_[i]);
    unclear.push_back(t);
  }

  void count(std::size_t& pairs) {
    if (++pairs < 0x400) return;
    pairs_ += pairs;
    pairs = 0;
  }
  bool is_crowded() const { return pairs_.load(std::memory_order_relaxed) > most_pairs_; }

  // Of those that did not move, which may have no area.
  Triangles flat_cut_ones() const {
    Triangles flat;
    for (const std::uint32_t t : mesh_.cut())
      if (!mesh_.is_unsettled(t) && !clear_view(placed(t)).clear()) flat.push_back(t);
    return flat;
  }

  // Per triangle: is it one of many of a face?
  std::vector<std::uint8_t> of_large_faces() const {
    std::vector<std::uint8_t> marks(mesh_.size(), 0);
    const Triangles& cut = mesh_.cut();
    for (std::size_t begin = 0, end = 0; begin < cut.size(); begin = end) {
      while (end < cut.size() && mesh_.source(cut[end]) == mesh_.source(cut[begin])) ++end;
      if (end - begin > most_of_a_face)
        for (std::size_t i = begin; i < end; ++i) marks[cut[i]] = 1;
    }
    return marks;
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

  const RoundedTriangles& mesh_;
  Triangles moved_;                  // those that are looked at here
  std::vector<TriangleView> views_;  // of each
  BoxTree tree_;
  std::atomic<std::size_t> pairs_{0};
  std::size_t most_pairs_ = 0;
  parallel::Scratch<Triangles> unclear_;
  Triangles result_;
};

}  // namespace

RoundedTriangles::Triangles unclear_triangles(const RoundedTriangles& mesh) {
  return UnclearTriangles(mesh).run();
}

}  // namespace sectile
