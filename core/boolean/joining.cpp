#include "boolean/joining.h"

#include "topology/euler.h"

namespace sectile {
namespace {

//        a_P ---- x ----> b_Q          A cut from P to Q within a face: the chain of null
//        half-edges
//   first |               | out         at P leads from a_P to b_P, that at Q from a_Q to b_Q. The
//     P   v   null face   | Q           two new edges leave a null face between them.
//    out  |               ^ first
//        b_P ----------- a_Q
class Joiner {
 public:
  Joiner(Workspace& w, const Segment& segment, Carrier& carrier)
      : w_(w),
        segment_(segment),
        carrier_(carrier),
        patch_(w.patch[carrier.solid]),
        euler_(patch_.brep) {}

  void run() {
    const CutEnd &p = w_.cut_ends[carrier_.cut_end[0]], &q = w_.cut_ends[carrier_.cut_end[1]];
    if (carrier_.entity.is_face())
      join_across(p, q);
    else if (carrier_.along)
      join_beside(p, q);
    else
      join_beside(q, p);
  }

 private:
  // What follows the chain. A neighbouring cut that is joined first comes between it and what
  // followed before.
  HalfEdgeId out(const CutEnd& end) const {
    return end.last.valid() ? patch_.brep.next_of(end.last) : end.first;
  }

  void join_across(const CutEnd& p, const CutEnd& q) {
    root_ = carrier_.entity.face();
    const PlaneId across = across_plane();
    unite_parts(p.first, out(q));
    const HalfEdgeId forward = euler_.connect(p.first, out(q));
    adopt(forward, across, across);
    const bool q_empty = !q.last.valid();
    const HalfEdgeId inner =
        euler_.mef(out(p), q_empty ? Brep::twin(forward) : q.first, Euler::NewFace::left);
    adopt(inner, across, across);
    make_null(inner);
    carrier_.forward = forward;
    carrier_.backward = Brep::twin(inner);
  }

  // A face that was divided before its inner loops were reached has left them in any of its parts.
  void unite_parts(HalfEdgeId a, HalfEdgeId b) {
    const FaceId part = patch_.brep.face_of(b);
    if (patch_.brep.face_of(a) != part) euler_.transfer_loop(patch_.brep.loop_of(a), part);
  }

  // The existing edge stays with the face on its other side; its even half-edge, which leaves p, is
  // now on the null face.
  void join_beside(const CutEnd& p, const CutEnd& q) {
    const HalfEdgeId even = out(p);
    root_ = patch_.root[patch_.brep.face_of(even).value()];
    const PlaneId side = patch_.side(even);
    const HalfEdgeId made = euler_.mef(p.first, out(q), Euler::NewFace::right);
    adopt(made, side, side);
    make_null(Brep::twin(made));
    (carrier_.along ? carrier_.forward : carrier_.backward) = made;
    (carrier_.along ? carrier_.backward : carrier_.forward) = Brep::twin(even);
  }

  PlaneId across_plane() const {
    const PlaneId plane = patch_.plane(carrier_.entity.face());
    return w_.tests().parallel(plane, segment_.plane[0]) ? segment_.plane[1] : segment_.plane[0];
  }

  void adopt(HalfEdgeId h, PlaneId side, PlaneId twin_side) {
    patch_.side_plane.resize(patch_.brep.half_edge_count());
    patch_.half_edge_in_solid.resize(patch_.brep.half_edge_count());
    patch_.root.resize(patch_.brep.face_count(), root_);
    patch_.side_plane[h.value()] = side;
    patch_.side_plane[Brep::twin(h).value()] = twin_side;
  }

  void make_null(HalfEdgeId h) {
    patch_.brep.kind[patch_.brep.face_of(h).value()] = FaceKind::null;
  }

  Workspace& w_;
  const Segment& segment_;
  Carrier& carrier_;
  Patch& patch_;
  Euler euler_;
  FaceId root_;
};

}  // namespace

void join_null_edges(Workspace& w) {
  for (const Segment& segment : w.segments) {
    w.check_cancelled();
    for (std::uint32_t i = 0; i < segment.carrier_count; ++i) {
      Carrier& carrier = w.carriers[segment.first_carrier + i];
      if (carrier.cut) Joiner(w, segment, carrier).run();
    }
  }
}

}  // namespace sectile
