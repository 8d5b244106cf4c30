#include "boolean/joining/face_parts.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

#include "boolean/collect.h"
#include "boolean/joining/next_loops.h"
#include "boolean/ray_count.h"
#include "boolean/reduction/standing.h"
#include "geometry/axes.h"
#include "geometry/loop_area.h"
#include "numbers/threshold.h"
#include "search/box_tree.h"
#include "search/bucket_sort.h"
#include "search/lowest_first.h"
#include "sectile/errors.h"
#include "topology/euler.h"

namespace sectile {
namespace {

// Settles the parts of one loaded face at a time.
class PartSettler {
 public:
  PartSettler(Workspace& w, Operand operand)
      : w_(w), kernel_(w.tests()), patch_(w.patch[operand]), brep_(patch_.brep) {}

  void settle(FaceId root, std::span<const FaceId> faces) {
    root_ = root;
    axis_ = kernel_.main_axis(patch_.plane(root));
    up_ = kernel_.normal(patch_.plane(root), axis_);
    if (keep_one_loop_each(faces)) return;
    find_loops(faces);
    // The face of a half-space has a part without an outer loop, which reaches to infinity.
    if (outer_.size() + (patch_.unbounded ? 1 : 0) != faces.size())
      throw InternalError("the parts of a cut face do not fit together");
    const std::vector<LoopId> part_of_inner = parts_around_inner();
    for (const FaceId f : faces) brep_.outer_loop[f] = LoopId();
    for (const LoopId l : outer_) brep_.next_loop[l] = LoopId();
    for (const LoopId l : inner_) brep_.next_loop[l] = LoopId();
    place_outer(faces);
    for (std::size_t i = 0; i < inner_.size(); ++i) {
      const LoopId part = part_of_inner[i];
      Euler(brep_).move_loop(inner_[i], part.valid() ? brep_.loop_face[part] : endless_, false);
    }
  }

 private:
  // As a rule each part has an outer loop and nothing else, but for loops that joining has used up.
  bool keep_one_loop_each(std::span<const FaceId> faces) {
    if (patch_.unbounded) return false;
    for (const FaceId f : faces)
      if (const LoopId l = only_loop(f); !l.valid() || !turns_left(l)) return false;
    for (const FaceId f : faces) {
      const LoopId l = only_loop(f);
      brep_.outer_loop[f] = l;
      brep_.next_loop[l] = LoopId();
    }
    return true;
  }

  // The one with half-edges, or none if there are several.
  LoopId only_loop(FaceId f) const {
    LoopId only;
    for (LoopId l = brep_.outer_loop[f]; l.valid(); l = brep_.next_loop[l]) {
      if (!brep_.loop_half_edge[l].valid()) continue;
      if (only.valid()) return {};
      only = l;
    }
    return only;
  }

  void find_loops(std::span<const FaceId> faces) {
    outer_.clear();
    inner_.clear();
    for (const FaceId f : faces)
      for (LoopId l = brep_.outer_loop[f]; l.valid(); l = brep_.next_loop[l])
        if (brep_.loop_half_edge[l].valid()) (turns_left(l) ? outer_ : inner_).push_back(l);
  }

  bool turns_left(LoopId l) {
    if (const Estimate area = area_of(l); area.decided()) return area.sign() == up_;
    collect_points(l);
    return points_.size() > 2 && is_counter_clockwise(kernel_, patch_.plane(root_), points_);
  }

  // Null edges do not change it.
  Estimate area_of(LoopId l) const {
    LoopArea area(next_axis(axis_), next_next_axis(axis_));
    for_each_in_loop(brep_, l, [&](HalfEdgeId h) { area.add(w_.geometry.position(start(h))); });
    return area.estimate();
  }

  void collect_points(LoopId l) {
    points_.clear();
    for_each_in_loop(brep_, l, [&](HalfEdgeId h) {
      const PointId p = start(h);
      if (points_.empty() || points_.back() != p) points_.push_back(p);
    });
    if (points_.size() > 1 && points_.back() == points_.front()) points_.pop_back();
  }

  // Loops stay with their face where possible.
  void place_outer(std::span<const FaceId> faces) {
    std::vector<LoopId> homeless;
    for (const LoopId l : outer_) {
      const FaceId f = brep_.loop_face[l];
      if (brep_.outer_loop[f].valid())
        homeless.push_back(l);
      else
        Euler(brep_).move_loop(l, f, true);
    }
    for (const FaceId f : faces) {
      if (brep_.outer_loop[f].valid()) continue;
      if (homeless.empty()) {
        endless_ = f;
        continue;
      }
      Euler(brep_).move_loop(homeless.back(), f, true);
      homeless.pop_back();
    }
  }

  std::vector<LoopId> parts_around_inner() {
    if (outer_.size() == 1 && !patch_.unbounded) return std::vector(inner_.size(), outer_[0]);
    tried_ = 0;
    next_.reset();
    std::vector<std::optional<LoopId>> part(inner_.size());
    std::vector<std::uint32_t> in_one;
    for (std::uint32_t first = 0; first < inner_.size(); ++first) {
      // Holes that lie in one part lead from one to the next.
      in_one.clear();
      std::uint32_t l = first;
      for (; l < inner_.size() && !part[l]; l = next_loop(l)) in_one.push_back(l);
      LoopId around_all;
      if (l == NextLoops::none)
        around_all = around(inner_[in_one.back()]);
      else
        around_all = l < inner_.size() ? *part[l] : outer_[l - inner_.size()];
      for (const std::uint32_t i : in_one) part[i] = around_all;
    }
    std::vector<LoopId> all;
    for (const std::optional<LoopId>& p : part) all.push_back(*p);
    return all;
  }

  // Of the same part as an inner loop: another inner one, or the outer one. None where that is not
  // known, and as long as it takes less to try the outer loops.
  std::uint32_t next_loop(std::uint32_t inner) {
    constexpr std::size_t few_tries = threshold(16, 0);
    if (!next_ && tried_ <= few_tries * corners_) return NextLoops::none;
    if (!next_) find_next_loops();
    return (*next_)[inner];
  }

  void find_next_loops() {
    std::vector<PointId> corners;
    std::vector<std::uint32_t> loop_ends;
    for (const std::vector<LoopId>* loops : {&inner_, &outer_})
      for (const LoopId l : *loops) {
        for_each_in_loop(brep_, l, [&](HalfEdgeId h) {
          if (patch_.side(h).valid()) corners.push_back(start(h));  // no null edge
        });
        loop_ends.push_back(static_cast<std::uint32_t>(corners.size()));
      }
    next_.emplace(kernel_, patch_.plane(root_), corners, loop_ends,
                  static_cast<std::uint32_t>(inner_.size()));
  }

  // The innermost of the outer loops that surround an inner one: the smallest ones are tried first,
  // and none that is clearly larger than one that was found.
  LoopId around(LoopId inner) {
    build_loop_tree();
    const HalfEdgeId any = brep_.loop_half_edge[inner];
    const Vec3& at = w_.geometry.position(start(any));
    if (!patch_.unbounded)
      if (const LoopId only = only_one_near(at); only.valid()) return only;  // some loop does
    build_outlines();
    std::uint32_t innermost = none;
    double largest = std::numeric_limits<double>::infinity();
    // Areas that overflow say nothing: they are no numbers.
    const auto may_be_innermost = [&](const Box& b) {
      return !(b.low[axis_] > largest) && is_near(b, at);
    };
    visit_lowest_first(loop_tree_, axis_, may_be_innermost, [&](std::uint32_t i) {
      if (!may_be_innermost(loop_boxes_[i]) || !surrounds(i, inner)) return;
      if (innermost != none && !is_within(i, innermost)) return;
      innermost = i;
      largest = largest_side(areas_[i]);
    });
    if (innermost != none) return outer_[innermost];
    if (!patch_.unbounded) throw InternalError("an inner loop lies in no part of its face");
    return {};
  }

  bool is_near(const Box& b, const Vec3& at) const {
    const auto holds_along = [&](int k) {
      return b.low[k] <= component(at, k) && component(at, k) <= b.high[k];
    };
    return holds_along(next_axis(axis_)) && holds_along(next_next_axis(axis_));
  }

  // The outer loop whose box contains a point, if there are not several.
  LoopId only_one_near(const Vec3& at) const {
    std::uint32_t near = none;
    bool several = false;
    loop_tree_.query([&](const Box& b) { return !several && is_near(b, at); },
                     [&](std::uint32_t i) {
                       several = near != none;
                       near = i;
                     });
    return near == none || several ? LoopId() : outer_[near];
  }

  // The sides of squares that are as large as an outer loop at least, and at most.
  static float smallest_side(const Estimate& area) {
    return round_down(
        std::sqrt(std::max(0.0, std::nextafter(std::abs(area.value) - area.error, 0.0))));
  }
  static double largest_side(const Estimate& area) {
    return std::sqrt(
        std::nextafter(std::abs(area.value) + area.error, std::numeric_limits<double>::infinity()));
  }

  // Loops do not cross, so one point of a loop tells for all, or, if all are on the outer loop, one
  // edge that leads away from it.
  bool surrounds(std::uint32_t outer, LoopId loop) {
    if (goes_back_along(outer, loop)) return false;
    bool decided = false, inside = false;
    std::vector<Entity> touched;
    const auto by_point = [&](HalfEdgeId h) {
      if (decided) return;
      const PointId p = start(h);
      const Probe probe(kernel_, p);
      RayCount count(kernel_, patch_, patch_.plane(root_), probe, touched);
      count_crossings(outer, count);
      if (!count.touched().empty()) return;
      decided = true;
      inside = count.odd();
    };
    const auto by_direction = [&](HalfEdgeId h) {
      if (decided || !patch_.side(h).valid()) return;
      const PointId p = start(h);
      const Probe probe(kernel_, p);
      RayCount count(kernel_, patch_, patch_.plane(root_), probe, touched);
      count_crossings(outer, count);
      const Standing::Where where = standing_of(h, outer_[outer], count.touched());
      if (where == Standing::Where::along) return;
      decided = true;
      inside = where == Standing::Where::inside;
    };
    for_each_in_loop(brep_, loop, by_point);
    if (!decided) for_each_in_loop(brep_, loop, by_direction);
    return inside;
  }

  // What is cut out and the hole that is left have the same corners, the other way around.
  bool goes_back_along(std::uint32_t outer, LoopId loop) {
    points_.clear();
    for_each_in_loop(brep_, loop, [&](HalfEdgeId h) {
      if (patch_.side(h).valid()) points_.push_back(start(h));
    });
    const auto edges = edges_of(outer);
    tried_ += points_.size() + (outlines_[outer] ? 1 : edges.size());
    if (edges.size() != points_.size() || edges.empty()) return false;
    const auto first = std::ranges::find(points_, start(edges[0]));
    if (first == points_.end()) return false;
    std::rotate(points_.begin(), first, points_.end());
    std::reverse(points_.begin() + 1, points_.end());
    return std::ranges::equal(edges, points_, {}, [&](HalfEdgeId h) { return start(h); });
  }
  PointId start(HalfEdgeId h) const { return brep_.point_of(brep_.from(h)); }

  Standing::Where standing_of(HalfEdgeId h, LoopId outer,
                              const std::vector<Entity>& touched) const {
    std::vector<BoundaryItem> items;
    for (const Entity entity : touched) {
      const auto add = [&](HalfEdgeId i) {
        if (brep_.loop_of(i) == outer) items.push_back({entity, i});
      };
      if (entity.is_edge()) {
        add(Brep::half_edge(entity.edge(), 0));
        add(Brep::half_edge(entity.edge(), 1));
      } else {
        for_each_around(brep_, brep_.vertex_half_edge[entity.vertex()], add);
      }
    }
    if (items.empty()) return Standing::Where::along;
    return standing(kernel_, patch_, brep_.loop_face[outer], items,
                    direction_of(kernel_, patch_, h))
        .where;
  }

  // Of two outer loops around one point: is the first one within the second?
  bool is_within(std::uint32_t first, std::uint32_t second) {
    const Estimate a = areas_[first], b = areas_[second];
    const double larger = std::abs(b.value) - std::abs(a.value);
    if (std::abs(larger) > a.error + b.error) return larger > 0;
    return surrounds(second, outer_[first]);
  }

  // Those of an outer loop, without null edges.
  std::span<const HalfEdgeId> edges_of(std::uint32_t outer) const {
    const std::uint32_t first = outer == 0 ? 0 : outer_end_[outer - 1];
    return std::span(outer_edges_).subspan(first, outer_end_[outer] - first);
  }

  void count_crossings(std::uint32_t outer, RayCount& count) const {
    const auto edges = edges_of(outer);
    if (const OutlineTree* outline = outlines_[outer].get())
      count.add(*outline, edges);
    else
      for (const HalfEdgeId h : edges) count.add(h);
  }

  // The boxes tell of where a loop is in the face, and, along the axis, of its size.
  void build_loop_tree() {
    if (loops_root_ == root_) return;
    loops_root_ = root_;
    areas_.clear();
    loop_boxes_.clear();
    for (const LoopId l : outer_) {
      Bounds bounds;
      for_each_in_loop(brep_, l, [&](HalfEdgeId h) { bounds.add(w_.geometry.position(start(h))); });
      areas_.push_back(area_of(l));
      Box box = bounds.box();
      box.low[axis_] = box.high[axis_] = smallest_side(areas_.back());
      loop_boxes_.push_back(box);
    }
    loop_tree_ = BoxTree(loop_boxes_);
  }

  void build_outlines() {
    if (edges_root_ == root_) return;
    edges_root_ = root_;
    outer_edges_.clear();
    outer_end_.clear();
    outlines_.clear();
    std::vector<Vec3> corners;
    for (const LoopId l : outer_) {
      corners.clear();
      for_each_in_loop(brep_, l, [&](HalfEdgeId h) {
        if (!patch_.side(h).valid()) return;  // a null edge
        outer_edges_.push_back(h);
        corners.push_back(w_.geometry.position(start(h)));
      });
      outer_end_.push_back(static_cast<std::uint32_t>(outer_edges_.size()));
      const std::uint32_t all[] = {static_cast<std::uint32_t>(corners.size())};
      outlines_.push_back(corners.size() < many_edges
                              ? nullptr
                              : std::make_unique<OutlineTree>(corners, all, axis_));
    }
    corners_ = outer_edges_.size();
    for (const LoopId l : inner_) for_each_in_loop(brep_, l, [&](HalfEdgeId) { ++corners_; });
  }

  static constexpr std::size_t many_edges = threshold(24, 2);
  static constexpr std::uint32_t none = 0xFFFFFFFFu;

  Workspace& w_;
  const Kernel& kernel_;
  Patch& patch_;
  Brep& brep_;
  FaceId root_, endless_;
  int axis_ = 0;                    // the main axis of the face
  Sign up_ = Sign::zero;            // of its normal there
  FaceId loops_root_, edges_root_;  // of which what follows was made
  std::vector<LoopId> outer_, inner_;
  std::vector<PointId> points_;
  std::vector<Estimate> areas_;  // per outer loop
  std::vector<Box> loop_boxes_;  // per outer loop
  BoxTree loop_tree_;
  std::vector<HalfEdgeId> outer_edges_;
  std::vector<std::uint32_t> outer_end_;                // per outer loop: end of its edges
  std::vector<std::unique_ptr<OutlineTree>> outlines_;  // per outer loop, if it has many edges
  std::size_t corners_ = 0;        // of all loops, as soon as there are outlines
  std::size_t tried_ = 0;          // how many of them were looked at for inner loops
  std::optional<NextLoops> next_;  // of inner loops and the outer ones after them, if worth while
};

// The parts of the divided faces, face by face.
struct PartsOfFaces {
  std::vector<FaceId> parts;
  std::vector<std::uint32_t> first;  // per face that may be divided, and the end
};

PartsOfFaces parts_of_faces(const Patch& patch, const Table<FaceId, std::uint8_t>& divided) {
  PartsOfFaces of;
  for (const FaceId f : patch.root.ids())
    if (divided[patch.root_of(f)] && patch.is_real(f)) of.parts.push_back(f);
  of.first = bucket_sort(
      of.parts, divided.size(), [&](FaceId f) { return patch.root_of(f).value(); }, std::less<>());
  return of;
}

}  // namespace

// What is written of a face is its own, so faces are settled beside each other.
void settle_face_parts(Workspace& w, const PerOperand<Table<FaceId, std::uint8_t>>& divided) {
  for (const Operand s : both_operands) {
    const PartsOfFaces of = parts_of_faces(w.patch[s], divided[s]);
    for_each_range(w, divided[s].size(), 256, [&](std::size_t first, std::size_t last) {
      PartSettler settler(w, s);
      for (std::size_t f = first; f < last; ++f)
        if (const std::uint32_t from = of.first[f], to = of.first[f + 1]; from != to)
          settler.settle(FaceId(f), std::span(of.parts).subspan(from, to - from));
    });
  }
}

}  // namespace sectile
