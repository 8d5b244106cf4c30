#include "boolean/face_parts.h"

#include <algorithm>
#include <cmath>

#include "boolean/ray_count.h"
#include "boolean/reduction/standing.h"
#include "sectile/errors.h"
#include "topology/euler.h"

namespace sectile {
namespace {

double on_axis(const Vec3& p, int axis) {
  return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
}

// Twice the signed area of the projection, with a bound for all rounding.
Estimate estimated_area(const Geometry& g, const std::vector<PointId>& loop, int i, int j) {
  const Vec3& origin = g.position(loop[0]);
  double area = 0, extent_i = 0, extent_j = 0, size_i = 0, size_j = 0;
  double last_i = 0, last_j = 0;
  for (const PointId p : loop) {
    const double x = on_axis(g.position(p), i), y = on_axis(g.position(p), j);
    const double di = x - on_axis(origin, i), dj = y - on_axis(origin, j);
    area += last_i * dj - last_j * di;
    extent_i = std::max(extent_i, std::abs(di));
    extent_j = std::max(extent_j, std::abs(dj));
    size_i = std::max(size_i, std::abs(x));
    size_j = std::max(size_j, std::abs(y));
    last_i = di;
    last_j = dj;
  }
  constexpr double unit = 0x1p-53;
  const auto count = static_cast<double>(loop.size());
  const double error = 16 * count * unit *
                           (count * extent_i * extent_j + size_i * extent_j + size_j * extent_i +
                            unit * size_i * size_j) +
                       count * 0x1p-1060;
  return {area, error};
}

}  // namespace

bool is_counter_clockwise(const Kernel& kernel, PlaneId plane, const std::vector<PointId>& loop) {
  const int k = kernel.main_axis(plane), i = (k + 1) % 3, j = (k + 2) % 3;
  const Sign up = kernel.normal(plane, k);
  const Estimate area = estimated_area(kernel.geometry(), loop, i, j);
  if (area.decided()) return area.sign() == up;
  // At an extreme place all corners of a counter-clockwise loop are convex, and of a clockwise one
  // some is not.
  const auto before = [&](PointId p, PointId q) {
    const Sign sign = kernel.compare(p, q, i);
    return sign != Sign::zero ? sign == Sign::positive : kernel.compare(p, q, j) == Sign::positive;
  };
  const PointId extreme = *std::min_element(loop.begin(), loop.end(), before);
  for (std::size_t c = 0; c < loop.size(); ++c) {
    if (!kernel.same_point(loop[c], extreme)) continue;
    const PointId last = loop[c > 0 ? c - 1 : loop.size() - 1];
    const PointId next = loop[c + 1 < loop.size() ? c + 1 : 0];
    if (kernel.turn(last, loop[c], next, k) != up) return false;
  }
  return true;
}

namespace {

class Family {
 public:
  Family(Workspace& w, int s) : w_(w), kernel_(w.tests()), patch_(w.patch[s]), brep_(patch_.brep) {}

  void settle(FaceId root, std::vector<FaceId>& faces) {
    root_ = root;
    find_loops(faces);
    // The face of a half-space has a part without an outer loop, which reaches to infinity.
    if (outer_.size() + (patch_.unbounded ? 1 : 0) != faces.size())
      throw InternalError("the parts of a cut face do not fit together");
    std::vector<LoopId> part_of_inner;
    const bool single = outer_.size() == 1 && !patch_.unbounded;
    for (const LoopId l : inner_) part_of_inner.push_back(single ? outer_[0] : around(l));
    for (const FaceId f : faces) brep_.outer_loop[f.value()] = LoopId();
    for (const LoopId l : outer_) brep_.next_loop[l.value()] = LoopId();
    for (const LoopId l : inner_) brep_.next_loop[l.value()] = LoopId();
    place_outer(faces);
    for (std::size_t i = 0; i < inner_.size(); ++i) {
      const LoopId part = part_of_inner[i];
      Euler(brep_).move_loop(inner_[i], part.valid() ? brep_.loop_face[part.value()] : endless_,
                             false);
    }
  }

 private:
  void find_loops(const std::vector<FaceId>& faces) {
    outer_.clear();
    inner_.clear();
    for (const FaceId f : faces)
      for (LoopId l = brep_.outer_loop[f.value()]; l.valid(); l = brep_.next_loop[l.value()])
        if (brep_.loop_half_edge[l.value()].valid()) (turns_left(l) ? outer_ : inner_).push_back(l);
  }

  bool turns_left(LoopId l) {
    points_.clear();
    for_each_in_loop(brep_, l, [&](HalfEdgeId h) {
      const PointId p = brep_.point_of(brep_.from(h));
      if (points_.empty() || points_.back() != p) points_.push_back(p);
    });
    if (points_.size() > 1 && points_.back() == points_.front()) points_.pop_back();
    return points_.size() > 2 && is_counter_clockwise(kernel_, patch_.plane(root_), points_);
  }

  // Loops stay with their face where possible.
  void place_outer(const std::vector<FaceId>& faces) {
    std::vector<LoopId> homeless;
    for (const LoopId l : outer_) {
      const FaceId f = brep_.loop_face[l.value()];
      if (brep_.outer_loop[f.value()].valid())
        homeless.push_back(l);
      else
        Euler(brep_).move_loop(l, f, true);
    }
    for (const FaceId f : faces) {
      if (brep_.outer_loop[f.value()].valid()) continue;
      if (homeless.empty()) {
        endless_ = f;
        continue;
      }
      Euler(brep_).move_loop(homeless.back(), f, true);
      homeless.pop_back();
    }
  }

  // The outer loop that surrounds an inner one: the one around one of its points, or, if all of its
  // points lie on outer loops, the one into whose inside one of its edges leads.
  LoopId around(LoopId inner) {
    build_tree();
    LoopId found;
    for_each_in_loop(brep_, inner, [&](HalfEdgeId h) {
      if (!found.valid()) found = around_point(h);
    });
    if (!found.valid() && !patch_.unbounded)
      throw InternalError("an inner loop lies in no part of its face");
    return found;
  }

  LoopId around_point(HalfEdgeId h) {
    const PointId p = brep_.point_of(brep_.from(h));
    const Probe probe(kernel_, p);
    const Vec3& at = w_.geometry.position(p);
    std::vector<std::pair<LoopId, RayCount>> counts;
    const RayCount start(kernel_, patch_, patch_.plane(root_), probe);
    const int i = start.i(), j = start.j();
    const auto meets = [&](const Box& b) {
      return b.low[j] <= on_axis(at, j) && on_axis(at, j) <= b.high[j] &&
             b.high[i] >= on_axis(at, i);
    };
    tree_.query(meets, [&](std::uint32_t item) {
      const HalfEdgeId e = tree_half_edges_[item];
      const LoopId l = brep_.loop_of(e);
      auto entry =
          std::find_if(counts.begin(), counts.end(), [&](const auto& c) { return c.first == l; });
      if (entry == counts.end()) entry = counts.insert(counts.end(), {l, start});
      entry->second.add(e);
    });
    bool touches = false;
    for (const auto& [l, count] : counts) {
      if (!count.touched().is_nothing())
        touches = true;
      else if (count.odd())
        return l;
    }
    return touches ? around_direction(h, counts) : LoopId();
  }

  LoopId around_direction(HalfEdgeId h, const std::vector<std::pair<LoopId, RayCount>>& counts) {
    if (!patch_.side(h).valid()) return {};
    const Direction d = direction_of(kernel_, patch_, h);
    for (const auto& [l, count] : counts) {
      if (count.touched().is_nothing()) continue;
      std::vector<BoundaryItem> items, of_loop;
      add_items(patch_, brep_.loop_face[l.value()], count.touched(), items);
      for (const BoundaryItem& item : items)
        if (brep_.loop_of(item.h) == l) of_loop.push_back(item);
      if (of_loop.empty()) continue;
      const Standing at = standing(kernel_, patch_, brep_.loop_face[l.value()], of_loop, d);
      if (at.where == Standing::Where::inside) return l;
    }
    return {};
  }

  void build_tree() {
    if (tree_root_ == root_) return;
    tree_root_ = root_;
    tree_half_edges_.clear();
    std::vector<Box> boxes;
    for (const LoopId l : outer_)
      for_each_in_loop(brep_, l, [&](HalfEdgeId h) {
        if (!patch_.side(h).valid()) return;  // a null edge
        Bounds bounds;
        bounds.add(w_.geometry.position(brep_.point_of(brep_.from(h))));
        bounds.add(w_.geometry.position(brep_.point_of(brep_.to(h))));
        boxes.push_back(bounds.box());
        tree_half_edges_.push_back(h);
      });
    tree_ = BoxTree(boxes);
  }

  Workspace& w_;
  const Kernel& kernel_;
  Patch& patch_;
  Brep& brep_;
  FaceId root_, tree_root_, endless_;
  std::vector<LoopId> outer_, inner_;
  std::vector<PointId> points_;
  BoxTree tree_;
  std::vector<HalfEdgeId> tree_half_edges_;
};

}  // namespace

void settle_face_parts(Workspace& w) {
  for (int s = 0; s < 2; ++s) {
    const Patch& patch = w.patch[s];
    // The faces of each cut face, in the order of their roots.
    std::vector<std::uint8_t> cut(patch.root.size(), 0);
    for (const Carrier& c : w.carriers) {
      if (!c.cut || c.solid != s) continue;
      for (const HalfEdgeId h : {c.forward, c.backward})
        cut[patch.root[patch.brep.face_of(h).value()].value()] = 1;
    }
    for (const auto& [solid, root] : w.bridged)
      if (solid == s) cut[root.value()] = 1;
    std::vector<FaceId> parts;
    for (std::size_t f = 0; f < patch.root.size(); ++f)
      if (cut[patch.root[f].value()] && patch.is_real(FaceId(f))) parts.push_back(FaceId(f));
    std::stable_sort(parts.begin(), parts.end(), [&](FaceId f, FaceId g) {
      return patch.root[f.value()] < patch.root[g.value()];
    });
    Family family(w, s);
    std::vector<FaceId> faces;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      faces.push_back(parts[i]);
      const FaceId root = patch.root[parts[i].value()];
      if (i + 1 < parts.size() && patch.root[parts[i + 1].value()] == root) continue;
      family.settle(root, faces);
      faces.clear();
    }
  }
}

}  // namespace sectile
