#include "topology/open_ends.h"

namespace sectile {
namespace {

void add_rest(Brep& brep, HalfEdgeId first) {
  const FaceId face = brep.add_face(PlaneId(), FaceSource{}, LoopId(brep.loop_count()));
  const LoopId loop = brep.add_loop(face, first);
  brep.kind.add(FaceKind::rest);
  for (HalfEdgeId h = first; !brep.loop[h].valid(); h = brep.next_of(h)) brep.loop[h] = loop;
}

}  // namespace

void close_open_ends(Brep& brep, std::span<const HalfEdgeId> open) {
  for (const HalfEdgeId h : open) {
    HalfEdgeId after = Brep::twin(h);
    do after = Brep::twin(brep.prev_of(after));
    while (brep.loop[after].valid());
    brep.next[h] = after;
    brep.prev[after] = h;
  }
  for (const HalfEdgeId h : open)
    if (!brep.loop[h].valid()) add_rest(brep, h);
}

}  // namespace sectile
