#include "selftest/self_test.h"

#include <algorithm>
#include <bit>
#include <mutex>
#include <optional>
#include <tuple>
#include <unordered_set>
#include <utility>

#include "numbers/threshold.h"
#include "parallel/parallel.h"
#include "parallel/scratch.h"
#include "search/hub_fans.h"
#include "search/oriented_box.h"
#include "search/space_partition.h"
#include "sectile/errors.h"
#include "selftest/chain_fans.h"
#include "selftest/edges_on_line.h"
#include "selftest/flat_block.h"
#include "selftest/flat_patches.h"
#include "selftest/node_labels.h"
#include "selftest/patch_pairs.h"
#include "selftest/slanted_nodes.h"
#include "selftest/triangle_pair.h"
#include "selftest/triangle_tree.h"

namespace sectile {
namespace {

struct CornersOf {
  const TriangleSurface& surface;
  template <class Visit>
  void operator()(std::uint32_t triangle, const Visit& visit) const {
    for (const PointId p : surface.corners[triangle]) visit(p);
  }
};

struct Found {
  std::vector<SelfContact> contacts;
  std::size_t tests = 0, node_pairs = 0;
};

// The work is divided by the nodes of one level: each meets itself and those that come after it.
class Traversal {
 public:
  Traversal(const TriangleSurface& surface, const Kernel& kernel, const SelfTestControl& control)
      : surface_(surface),
        control_(control),
        patches_(surface, kernel),
        tree_(surface, kernel.geometry(), patches_.rest()),
        patch_pairs_(patches_, surface, kernel.geometry(), tree_),
        blocks_(surface, tree_, kernel),
        slanted_(surface, kernel.geometry(), tree_),
        faces_(tree_, labels_of_faces()),
        geometry_(kernel.geometry()),
        kernel_(kernel),
        hubs_(fans_around_hubs(tree_.order())),
        chains_(surface, kernel, tree_.order(), hubs_.spines(CornersOf{surface})),
        settled_(tree_, labels_of_settled()),
        pairs_(surface, kernel) {
    find_first_fans();
  }

  std::vector<SelfContact> run() {
    while (!traversed()) start_again();
    if (control_.progress) control_.progress(1);
    return sorted();
  }

 private:
  /// There is a better way for very many triangles that are near each other.
  struct Crowded {};

  // More tests than so many for each triangle are a reason to look for lines along which many meet,
  // and for points in which their edges cross; more tests and pairs of nodes, to give all nodes
  // oriented boxes, as the triangles of surfaces that lie in layers are apart as layers are; and
  // then, to divide space.
  static constexpr std::size_t many_tests = threshold(32, 2), very_many = threshold(128, 4);
  static constexpr std::size_t counted_at_a_time = 1024;
  static constexpr std::size_t least_cells = threshold(64, 2);

  bool traversed() {
    try {
      traverse();
      return true;
    } catch (const Crowded&) {
      return false;
    }
  }

  void start_again() {
    if (more_fans_) {
      hubs_ = *std::move(more_fans_);
      more_fans_.reset();
      label_fans();
    } else if (!slanted_.are_most()) {
      slanted_ = SlantedNodes(surface_, geometry_, tree_, SlantedNodes::Which::all);
      most_tests_ *= 4;
    } else {
      space_.emplace(rods(), labels_of_untested(), triangles());
      find_oriented_boxes();
    }
    is_crowded_ = false;
    tests_ = node_pairs_ = 0;
    found_.emplace();
    begun_at_ = told_;
  }

  void traverse() {
    const std::size_t level = std::min<std::size_t>(tree_.levels() - 1, 2);
    std::vector<SpacePartition::Cell> cells;
    if (space_) cells = space_->cells(least_cells);
    const std::size_t count = space_ ? cells.size() : tree_.nodes(level);
    steps_ = count + chains_.part_count() + hubs_.count() + patch_pairs_.count();
    done_ = 0;
    parallel::loop(0, count, [&](std::size_t part) {
      check_cancelled();
      found_->lend([&](Found& found) {
        space_ ? test_cell(cells[part], found) : test_node(level, part, found);
      });
      note_step();
    });
    parallel::loop(0, chains_.part_count(), [&](std::size_t part) {
      check_cancelled();
      found_->lend([&](Found& found) { test_chain(part, found); });
      note_step();
    });
    parallel::loop(0, hubs_.count(), [&](std::size_t fan) {
      check_cancelled();
      found_->lend([&](Found& found) { test_fan(fan, found); });
      note_step();
    });
    parallel::loop(0, patch_pairs_.count(), [&](std::size_t patch) {
      check_cancelled();
      found_->lend([&](Found& found) { test_pairs_of_patch(patch, found); });
      note_step();
    });
  }

  void test_node(std::size_t level, std::size_t node, Found& found) {
    Visitor visitor{*this, found};
    visitor.meet_itself(level, node);
    visitor.meet_later(level, node, tree_.boxes(level, node).all(), tree_.levels() - 1, 0);
  }

  void test_cell(const SpacePartition::Cell& cell, Found& found) {
    space_->for_each_pair(cell, [&](std::uint32_t i, std::uint32_t j) {
      const std::uint32_t s = tree_.order()[i], t = tree_.order()[j];
      if (!same_fan(s, t) && !apart(oriented_[i], oriented_[j])) test(s, t, found);
    });
  }

  struct Visitor {
    Traversal& all;
    Found& found;

    void meet_itself(std::size_t level, std::size_t node) {
      if (all.blocks_.flat(level, node) || all.known(level, node, node)) return;
      const EightBoxes& boxes = all.tree_.boxes(level, node);
      const unsigned count = all.tree_.children(level, node);
      for (unsigned i = 0; i < count; ++i) {
        if (level > 0) meet_itself(level - 1, 8 * node + i);
        const unsigned later = boxes.overlapping(boxes.get(i)) & ~((2u << i) - 1);
        meet_children(level, 8 * node + i, 8 * node, later);
      }
    }

    // What comes after the node in the order, within another one of any higher level.
    void meet_later(std::size_t level, std::size_t node, const Box& box, std::size_t at_level,
                    std::size_t at) {
      if (at_level == level) return;
      const std::size_t shift = 3 * (at_level - level - 1);
      const std::size_t own = node >> shift;  // the child of `at`'s level that contains the node
      if (own >= 8 * at && own < 8 * at + 8 && all.blocks_.flat(at_level, at)) return;
      for (unsigned bits = all.tree_.boxes(at_level, at).overlapping(box); bits != 0;
           bits &= bits - 1) {
        const std::size_t child = 8 * at + static_cast<unsigned>(std::countr_zero(bits));
        if (child < own) continue;
        if (at_level - 1 > level)
          meet_later(level, node, box, at_level - 1, child);
        else if (child > node)
          meet(level, node, child);
      }
    }

    // Two nodes of one level.
    void meet(std::size_t level, std::size_t a, std::size_t b) {
      if (++found.node_pairs % counted_at_a_time == 0) all.note_node_pairs();
      if (all.known(level, a, b)) return;
      const EightBoxes &of_a = all.tree_.boxes(level, a), &of_b = all.tree_.boxes(level, b);
      for (unsigned bits = of_a.overlapping(of_b.all()); bits != 0; bits &= bits - 1) {
        const auto i = static_cast<unsigned>(std::countr_zero(bits));
        meet_children(level, 8 * a + i, 8 * b, of_b.overlapping(of_a.get(i)));
      }
    }

    void meet_children(std::size_t level, std::size_t i, std::size_t first, unsigned bits) {
      for (; bits != 0; bits &= bits - 1) {
        const std::size_t j = first + static_cast<unsigned>(std::countr_zero(bits));
        if (level > 0) {
          meet(level - 1, i, j);
          continue;
        }
        const std::uint32_t s = all.tree_.order()[i], t = all.tree_.order()[j];
        if (!all.same_fan(s, t)) all.test(s, t, found);
      }
    }
  };

  // Is nothing to be tested between two nodes?
  bool known(std::size_t level, std::size_t a, std::size_t b) const {
    return enough_.load(std::memory_order_relaxed) || faces_.same(level, a, b) ||
           fans_.same(level, a, b) || settled_.same(level, a, b) ||
           (a != b && slanted_.apart(level, a, b));
  }

  std::vector<std::uint32_t> labels_of_settled() const {
    std::vector<std::uint32_t> labels(surface_.settled.size(), NodeLabels::none);
    for (std::size_t t = 0; t < labels.size(); ++t)
      if (surface_.settled[t] != 0) labels[t] = 0;
    return labels;
  }

  // Not needed if each face is one triangle.
  std::vector<std::uint32_t> labels_of_faces() const {
    if (each_face_is_a_triangle()) return {};
    std::vector<std::uint32_t> labels = surface_.face;
    if (!surface_.doubtful.empty())
      for (std::uint32_t& label : labels)
        if (surface_.doubtful[label] != 0) label = NodeLabels::none;
    return labels;
  }

  void test(std::uint32_t s, std::uint32_t t, Found& found) {
    if (enough_.load(std::memory_order_relaxed)) return;
    if (++found.tests % counted_at_a_time == 0) note_tests();
    const auto contact = pairs_.test(std::min(s, t), std::max(s, t));
    if (!contact) return;
    found.contacts.push_back(*contact);
    if (control_.is_enough && control_.is_enough(surface_.face[s], surface_.face[t]))
      enough_.store(true, std::memory_order_relaxed);
  }

  HubFans fans_around_hubs(std::span<const std::uint32_t> triangles) const {
    return HubFans(triangles, surface_.size(), geometry_.positions.size(), CornersOf{surface_});
  }
  // Those that are in no fan around a chain.
  std::vector<std::uint32_t> around_no_chain() const {
    std::vector<std::uint32_t> rest;
    for (const std::uint32_t t : tree_.order())
      if (chains_.of_triangle()[t] == ChainFans::none) rest.push_back(t);
    return rest;
  }
  void find_first_fans() {
    if (!chains_.empty()) {
      around_no_chain_ = around_no_chain();
      hubs_ = fans_around_hubs(around_no_chain_);
    }
    hubs_.join_along_spines(not_around_chains(), kernel_, CornersOf{surface_});
    label_fans();
  }
  std::span<const std::uint32_t> not_around_chains() const {
    return chains_.empty() ? tree_.order() : around_no_chain_;
  }
  // The fans of chains are the first ones.
  void label_fans() {
    fan_of_ = hubs_.of_polygon();
    if (!chains_.empty()) {
      if (fan_of_.empty()) fan_of_.assign(surface_.size(), NodeLabels::none);
      for (std::size_t t = 0; t < fan_of_.size(); ++t)
        if (const std::uint32_t chain = chains_.of_triangle()[t]; chain != ChainFans::none)
          fan_of_[t] = chain;
        else if (fan_of_[t] != Hubs::none)
          fan_of_[t] += static_cast<std::uint32_t>(chains_.count());
    }
    fans_ = NodeLabels(tree_, fan_of_);
  }
  // Two of one fan are not tested, or with it.
  bool same_fan(std::uint32_t s, std::uint32_t t) const {
    return !fan_of_.empty() && fan_of_[s] != NodeLabels::none && fan_of_[s] == fan_of_[t];
  }

  void note_tests() {
    tests_ += counted_at_a_time;
    if (tests_ > many_tests * surface_.size()) look_for_fans();
    note_crowd();
  }
  void note_node_pairs() {
    node_pairs_ += counted_at_a_time;
    note_crowd();
  }
  void note_crowd() {
    if (!space_ && tests_ + node_pairs_ > most_tests_ * surface_.size()) is_crowded_ = true;
    if (is_crowded_) throw Crowded();
  }

  // Of walls that have one line in common, or one point within their edges, each meets all others:
  // the boxes of all hold it.
  void look_for_fans() {
    const std::unique_lock lock(looking_, std::try_to_lock);
    if (!lock || is_crowded_) return;
    if (!std::exchange(looked_for_lines_, true)) {
      HubFans along_lines = fans_around_hubs(not_around_chains());
      along_lines.join_along_crowded_lines(not_around_chains(), kernel_, CornersOf{surface_});
      if (along_lines.any_lines()) return start_again_with(std::move(along_lines));
    }
    if (!std::exchange(looked_for_crossings_, true)) {
      const CrossingFans crossings(kernel_, sided_triangles());
      if (crossings.count() == 0) return;
      HubFans around_crossings = hubs_;
      around_crossings.join_around_crossings(tree_.order(), crossings);
      start_again_with(std::move(around_crossings));
    }
  }
  void start_again_with(HubFans fans) {
    more_fans_ = std::move(fans);
    is_crowded_ = true;
  }

  // In the order of the tree.
  SidedPolygons sided_triangles() const {
    SidedPolygons sided;
    for (const std::uint32_t t : tree_.order()) {
      for (int k = 0; k < 3; ++k)
        sided.add_side(surface_.corners[t][static_cast<std::size_t>(k)],
                       surface_.corners[t][static_cast<std::size_t>(k < 2 ? k + 1 : 0)],
                       surface_.plane[surface_.neighbour(t, k)]);
      sided.end_polygon(surface_.plane[t], SidedPolygons::no_label);
    }
    return sided;
  }

  std::array<Vec3, 3> corners(std::uint32_t t) const {
    std::array<Vec3, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) corners[k] = geometry_.position(surface_.corners[t][k]);
    return corners;
  }
  // Of the triangles in the order of the tree.
  std::vector<SpacePartition::Rod> rods() const {
    std::vector<SpacePartition::Rod> rods;
    rods.reserve(tree_.order().size());
    for (const std::uint32_t t : tree_.order()) rods.emplace_back(corners(t));
    return rods;
  }
  std::vector<SpacePartition::Triangle> triangles() const {
    std::vector<SpacePartition::Triangle> triangles;
    triangles.reserve(tree_.order().size());
    for (const std::uint32_t t : tree_.order()) triangles.push_back(corners(t));
    return triangles;
  }
  // Slivers that all have an end near one line are side by side in cells that no plane divides.
  void find_oriented_boxes() {
    oriented_.clear();
    for (const std::uint32_t t : tree_.order()) oriented_.emplace_back(corners(t));
  }
  std::vector<std::uint32_t> labels_of_untested() const {
    std::vector<std::uint32_t> labels;
    for (const std::uint32_t t : tree_.order())
      labels.push_back(fan_of_.empty() ? NodeLabels::none : fan_of_[t]);
    return labels;
  }

  void test_chain(std::size_t part, Found& found) {
    chains_.for_each_pair(part, [&](std::uint32_t s, std::uint32_t t) { test(s, t, found); });
  }

  // What leaves a line in different directions meets in edges on it only.
  void test_fan(std::size_t fan, Found& found) {
    const auto test_pair = [&](std::uint32_t s, std::uint32_t t) { test(s, t, found); };
    hubs_.for_each_pair(fan, geometry_, CornersOf{surface_}, test_pair);
    if (!hubs_.is_along_line(fan)) return;
    if (!EdgesOnLine(surface_, kernel_, hubs_.polygons(fan), hubs_.points(fan)).alternate())
      hubs_.for_each_other_pair(fan, geometry_, CornersOf{surface_}, test_pair);
  }

  // Two faces that lie on each other do so in very many slivers.
  void test_pairs_of_patch(std::size_t patch, Found& found) {
    const bool once = control_.overlaps_once && !each_face_is_a_triangle();
    std::unordered_set<std::uint64_t> known;
    patch_pairs_.for_each_pair(patch, [&](std::uint32_t s, std::uint32_t t) {
      const std::uint64_t faces = std::uint64_t(surface_.face[s]) << 32 | surface_.face[t];
      if (!known.empty() && known.contains(faces)) return;
      const std::size_t before = found.contacts.size();
      test(s, t, found);
      if (once && found.contacts.size() > before &&
          found.contacts.back().kind == SelfContact::Kind::overlap)
        known.insert(faces);
    });
  }

  bool each_face_is_a_triangle() const { return surface_.face.back() + 1 == surface_.size(); }

  void check_cancelled() const {
    if (control_.cancel && control_.cancel->load(std::memory_order_relaxed)) throw Cancelled();
  }
  void note_step() {
    ++done_;
    if (!control_.progress || !telling_.try_lock()) return;
    const std::lock_guard lock(telling_, std::adopt_lock);
    const std::size_t done = done_;  // asked for here, so that it rises
    if (done >= steps_) return;
    told_ = begun_at_ + (1 - begun_at_) * double(done) / double(steps_);
    control_.progress(told_);
  }

  std::vector<SelfContact> sorted() {
    std::vector<SelfContact> all;
    found_->for_each([&](const Found& some) {
      all.insert(all.end(), some.contacts.begin(), some.contacts.end());
    });
    std::sort(all.begin(), all.end(), [](const SelfContact& a, const SelfContact& b) {
      return std::tie(a.first, a.second) < std::tie(b.first, b.second);
    });
    const auto same = [](const SelfContact& a, const SelfContact& b) {
      return a.first == b.first && a.second == b.second;
    };
    all.erase(std::unique(all.begin(), all.end(), same), all.end());
    return all;
  }

  const TriangleSurface& surface_;
  const SelfTestControl& control_;
  FlatPatches patches_;
  TriangleTree tree_;  // of the triangles in no patch
  PatchPairs patch_pairs_;
  FlatBlocks blocks_;
  SlantedNodes slanted_;
  NodeLabels faces_;
  const Geometry& geometry_;
  const Kernel& kernel_;
  HubFans hubs_;
  ChainFans chains_;
  std::vector<std::uint32_t> around_no_chain_;  // if there are chains
  std::optional<HubFans> more_fans_;            // with which to start again
  std::vector<std::uint32_t> fan_of_;           // per triangle; empty if there are no fans
  NodeLabels fans_, settled_;
  TrianglePairs pairs_;
  std::optional<SpacePartition> space_;  // if triangles are crowded
  std::vector<OrientedBox> oriented_;    // then, in the order of the tree
  std::optional<parallel::Scratch<Found>> found_{std::in_place};
  std::atomic<bool> enough_{false}, is_crowded_{false};
  bool looked_for_lines_ = false, looked_for_crossings_ = false;
  std::atomic<std::size_t> tests_{0}, node_pairs_{0}, done_{0};
  std::size_t most_tests_ = very_many, steps_ = 0;
  double begun_at_ = 0, told_ = 0;  // parts of the progress
  std::mutex telling_, looking_;
};

}  // namespace

std::vector<SelfContact> self_contacts(const TriangleSurface& surface, const Kernel& kernel,
                                       const SelfTestControl& control) {
  if (surface.size() == 0) return {};
  std::vector<SelfContact> found;
  parallel::isolate([&] { found = Traversal(surface, kernel, control).run(); });
  return found;
}

}  // namespace sectile
