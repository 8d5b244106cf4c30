#include "boolean/cleanup/cleanup.h"

#include <cstdint>
#include <optional>

#include "geometry/kernel.h"
#include "geometry/loop_area.h"
#include "topology/euler.h"

namespace sectile {
namespace {

class Cleaner {
 public:
  Cleaner(Brep& brep, const Geometry& geometry, const std::vector<EdgeId>& seams,
          std::span<FaceId> followed)
      : brep_(brep), geometry_(geometry), seams_(seams), euler_(brep_, followed) {}

  void run() {
    Table<VertexId, std::uint8_t> ends(brep_.vertex_count());
    for (const EdgeId e : seams_)
      for (unsigned side = 0; side < 2; ++side) ends[brep_.from(Brep::half_edge(e, side))] = 1;
    for (const EdgeId e : seams_)
      if (within_one_face(e)) remove(Brep::half_edge(e));
    for (const VertexId v : gone_) ends[v] = 0;
    for (const VertexId v : ends.ids())
      if (ends[v] != 0) straighten(v);
    euler_.bury();
  }

 private:
  bool is_flat(EdgeId e) const { return brep_.extra_plane(e).valid(); }

  bool within_one_face(EdgeId e) const {
    const HalfEdgeId h = Brep::half_edge(e);
    const FaceId f = brep_.face_of(h), g = brep_.face_of(Brep::twin(h));
    return is_flat(e) && brep_.source[f] == brep_.source[g];
  }

  void remove(HalfEdgeId h) {
    if (brep_.face_of(h) != brep_.face_of(Brep::twin(h))) {
      euler_.kef(h);
      return;
    }
    if (brep_.loop_of(h) != brep_.loop_of(Brep::twin(h))) return;
    forget_dangling(h);
    const LoopId old = brep_.loop_of(h);
    const FaceId face = brep_.face_of(h);
    const bool was_outer = brep_.outer_loop[face] == old;
    const LoopId made = euler_.kemr(h);
    // One of the two parts of an outer loop is an inner loop now.
    if (made.valid() && was_outer && turns_left(face, made)) {
      brep_.outer_loop[face] = brep_.next_loop[old];
      // old is taken out and put behind made, which becomes the first.
      reorder(face, made, old);
    }
  }

  void reorder(FaceId face, LoopId first, LoopId second) {
    std::vector<LoopId> others;
    for (LoopId l = brep_.outer_loop[face]; l.valid(); l = brep_.next_loop[l])
      if (l != first && l != second) others.push_back(l);
    brep_.outer_loop[face] = LoopId();
    for (const LoopId l : others) euler_.move_loop(l, face, true);
    euler_.move_loop(second, face, true);
    euler_.move_loop(first, face, true);
  }

  void forget_dangling(HalfEdgeId h) {
    for (const HalfEdgeId g : {h, Brep::twin(h)})
      if (brep_.next_of(g) == Brep::twin(g)) gone_.push_back(brep_.to(g));
  }

  bool turns_left(FaceId face, LoopId loop) {
    std::vector<PointId> points;
    for_each_in_loop(brep_, loop,
                     [&](HalfEdgeId h) { points.push_back(brep_.point_of(brep_.from(h))); });
    return points.size() > 2 && is_counter_clockwise(kernel(), brep_.plane[face], points);
  }

  void straighten(VertexId v) {
    const HalfEdgeId h = brep_.vertex_half_edge[v], g = brep_.around(h);
    if (g == h || brep_.around(g) != h) return;
    if (brep_.to(h) == brep_.to(g)) return;
    const EdgeId e = Brep::edge_of(h);
    if (is_flat(e) &&
        kernel().side(brep_.point_of(brep_.to(g)), brep_.extra_plane(e)) != Sign::zero)
      return;
    euler_.kev(h);
  }

  const Kernel& kernel() {
    if (!kernel_) kernel_.emplace(geometry_);
    return *kernel_;
  }

  Brep& brep_;
  const Geometry& geometry_;
  const std::vector<EdgeId>& seams_;
  Euler euler_;
  std::optional<Kernel> kernel_;
  std::vector<VertexId> gone_;
};

}  // namespace

void clean_up(Brep& brep, const Geometry& geometry, const std::vector<EdgeId>& seams,
              std::span<FaceId> followed) {
  Cleaner(brep, geometry, seams, followed).run();
}

}  // namespace sectile
