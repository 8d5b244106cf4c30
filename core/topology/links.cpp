#include "topology/links.h"

#include <sstream>

namespace sectile {
namespace {

class LinkCheck {
 public:
  LinkCheck(const Brep& brep, bool unbounded) : brep_(brep), unbounded_(unbounded) {}

  std::vector<std::string> run() {
    check_half_edges();
    if (found_.empty()) check_loops();
    if (found_.empty()) check_vertices();
    if (found_.empty()) check_formula();
    return std::move(found_);
  }

 private:
  template <class Id>
  void report(Id id, const char* what) {
    std::ostringstream out;
    out << id << ": " << what;
    found_.push_back(out.str());
  }

  void check_half_edges() {
    const std::size_t n = brep_.half_edge_count();
    for (const HalfEdgeId h : brep_.half_edges()) {
      if (brep_.next_of(h).value() >= n || brep_.prev_of(h).value() >= n ||
          brep_.loop_of(h).value() >= brep_.loop_count() ||
          brep_.from(h).value() >= brep_.vertex_count()) {
        report(h, "refers to what does not exist");
        continue;
      }
      if (brep_.prev_of(brep_.next_of(h)) != h) report(h, "is not before what comes after it");
      if (brep_.from(brep_.next_of(h)) != brep_.to(h))
        report(h, "does not end where the next begins");
      if (brep_.loop_of(brep_.next_of(h)) != brep_.loop_of(h))
        report(h, "is followed by another loop");
    }
  }

  void check_loops() {
    std::size_t half_edges = 0;
    for (const FaceId f : brep_.faces()) {
      LoopId l = brep_.outer_loop[f];
      if (!l.valid() && !unbounded_) report(f, "has no loop");
      for (; l.valid(); l = brep_.next_loop[l]) {
        if (brep_.loop_face[l] != f) report(l, "is in the chain of another face");
        if (brep_.loop_half_edge[l].valid()) ++loops_;
        for_each_in_loop(brep_, l, [&](HalfEdgeId h) {
          ++half_edges;
          if (brep_.loop_of(h) != l) report(h, "is in the cycle of another loop");
        });
      }
    }
    if (half_edges != brep_.half_edge_count()) report(FaceId(0), "not all half-edges are in faces");
  }

  void check_vertices() {
    std::size_t half_edges = 0;
    for (const VertexId v : brep_.vertices()) {
      const HalfEdgeId first = brep_.vertex_half_edge[v];
      HalfEdgeId h = first;
      do {
        ++half_edges;
        if (brep_.from(h) != v) return report(v, "has a half-edge of another vertex around it");
        h = brep_.around(h);
      } while (h != first);
    }
    if (half_edges != brep_.half_edge_count()) report(VertexId(0), "a vertex has several cycles");
  }

  // Connected over edges and over the loops of a face.
  std::size_t shells() const {
    std::vector<std::uint8_t> seen(brep_.face_count(), 0);
    std::vector<FaceId> front;
    std::size_t count = 0;
    for (std::size_t f = 0; f < seen.size(); ++f) {
      if (seen[f]) continue;
      ++count;
      seen[f] = 1;
      front.push_back(FaceId(f));
      while (!front.empty()) {
        const FaceId face = front.back();
        front.pop_back();
        for_each_in_face(brep_, face, [&](HalfEdgeId h) {
          const FaceId g = brep_.face_of(Brep::twin(h));
          if (!seen[g.value()]) {
            seen[g.value()] = 1;
            front.push_back(g);
          }
        });
      }
    }
    return count;
  }

  void check_formula() {
    const auto n = [](std::size_t count) { return static_cast<std::int64_t>(count); };
    if (unbounded_) return;  // not closed
    const std::int64_t euler =
        n(brep_.vertex_count()) - n(brep_.edge_count()) + 2 * n(brep_.face_count()) - n(loops_);
    if (euler % 2 != 0) report(FaceId(0), "Euler and Poincaré's sum is odd");
    if (euler > 2 * n(shells())) report(FaceId(0), "Euler and Poincaré's sum is too large");
  }

  const Brep& brep_;
  bool unbounded_;
  std::size_t loops_ = 0;
  std::vector<std::string> found_;
};

}  // namespace

std::vector<std::string> broken_links(const Brep& brep, bool unbounded) {
  return LinkCheck(brep, unbounded).run();
}

}  // namespace sectile
