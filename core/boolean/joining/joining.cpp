#include "boolean/joining/joining.h"

#include "boolean/joining/face_parts.h"
#include "boolean/joining/far_parts.h"
#include "boolean/patch_euler.h"
#include "boolean/side_by_side.h"

namespace sectile {
namespace {

//        a_P ---- x ----> b_Q          A cut from P to Q within a face: the chain of null
//   first |               | out        half-edges at P leads from a_P to b_P, that at Q from a_Q to
//     P   v   null face   | Q          b_Q. The two new edges leave a null face between them.
//    out  |               ^ first
//        b_P ----------- a_Q
class Joiner {
 public:
  Joiner(Workspace& w, const Carrier& carrier)
      : carrier_(carrier), patch_(w.patch[carrier.operand]), euler_(patch_) {}

  CutSides join(const CutEnd& p, const CutEnd& q) {
    if (carrier_.entity.is_face()) return join_across(p, q);
    if (carrier_.along) return join_beside(p, q);
    const CutSides sides = join_beside(q, p);
    return {sides.backward, sides.forward};
  }

 private:
  // What follows the chain. A neighbouring cut that is joined first comes between it and what
  // followed before.
  HalfEdgeId out(const CutEnd& end) const {
    return end.last.valid() ? patch_.brep.next_of(end.last) : end.first;
  }

  CutSides join_across(const CutEnd& p, const CutEnd& q) {
    const PlaneId across = carrier_.direction.across;
    unite_parts(p.first, out(q));
    const HalfEdgeId forward = euler_.connect(p.first, out(q), across);
    const bool q_empty = !q.last.valid();
    const HalfEdgeId inner =
        euler_.mef(out(p), q_empty ? Brep::twin(forward) : q.first, Euler::NewFace::left, across);
    make_null(inner);
    return {forward, Brep::twin(inner)};
  }

  // A face that was divided before its inner loops were reached has left them in any of its parts.
  void unite_parts(HalfEdgeId a, HalfEdgeId b) {
    const FaceId part = patch_.brep.face_of(b);
    if (patch_.brep.face_of(a) != part) euler_.transfer_loop(patch_.brep.loop_of(a), part);
  }

  // The existing edge stays with the face on its other side; its even half-edge, which leaves p, is
  // now on the null face.
  CutSides join_beside(const CutEnd& p, const CutEnd& q) {
    const HalfEdgeId even = out(p);
    const HalfEdgeId made = euler_.mef(p.first, out(q), Euler::NewFace::right, patch_.side(even));
    make_null(Brep::twin(made));
    return {made, Brep::twin(even)};
  }

  void make_null(HalfEdgeId h) { patch_.brep.kind[patch_.brep.face_of(h)] = FaceKind::null; }

  const Carrier& carrier_;
  Patch& patch_;
  PatchEuler euler_;
};

}  // namespace

JoinedCuts join_null_edges(Workspace& w, const Neighborhoods& neighborhoods, const Cuts& cuts) {
  JoinedCuts joined;
  joined.sides.resize(neighborhoods.carriers.size());
  for_both_operands(neighborhoods.carriers.size(), [&](Operand s) {
    const Patch& patch = w.patch[s];
    Table<FaceId, std::uint8_t>& divided = joined.divided[s];
    divided.resize(patch.root.size());
    for (const FaceId root : cuts.bridged[s]) divided[root] = 1;
    for (const CarrierId id : neighborhoods.carriers.ids()) {
      w.check_cancelled();
      const Carrier& carrier = neighborhoods.carriers[id];
      if (!carrier.cut || carrier.operand != s) continue;
      const auto [p, q] = cuts.of_carrier[id];
      const CutSides sides = Joiner(w, carrier).join(cuts.ends[p], cuts.ends[q]);
      for (const HalfEdgeId h : {sides.forward, sides.backward}) divided[patch.root_of(h)] = 1;
      joined.sides[id] = sides;
    }
  });
  settle_face_parts(w, joined.divided);
  settle_far_loops(w, joined.divided);
  return joined;
}

}  // namespace sectile
