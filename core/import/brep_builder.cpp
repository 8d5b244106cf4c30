#include "import/brep_builder.h"

#include "parallel/parallel.h"
#include "topology/vertex_cycles.h"

namespace sectile {
namespace {

class BrepBuilder {
 public:
  BrepBuilder(const Polygons& polygons, const std::vector<std::uint32_t>& mate, Brep& brep)
      : polygons_(polygons), mate_(mate), brep_(brep), half_edge_(polygons.corners.size()) {}

  void run() {
    number_half_edges();
    add_faces();
    make_vertices(brep_, start_);
  }

 private:
  void number_half_edges() {
    std::uint32_t next = 0;
    for (std::uint32_t i = 0; i < half_edge_.size(); ++i) {
      if (half_edge_[i].valid()) continue;
      half_edge_[i] = HalfEdgeId(next);
      half_edge_[mate_[i]] = HalfEdgeId(next + 1);
      next += 2;
    }
    brep_.resize_half_edges(next);
    start_.resize(next);
  }

  void add_faces() {
    const std::size_t faces = polygons_.face_count(), loops = polygons_.loop_end.size();
    brep_.outer_loop.resize(faces);
    brep_.plane.resize(faces);
    brep_.source.resize(faces);
    brep_.loop_half_edge.resize(loops);
    brep_.loop_face.resize(loops);
    brep_.next_loop.resize(loops);
    parallel::loop(parallel::Range<std::size_t>(0, faces, 1024), [&](const auto& range) {
      for (std::size_t f = range.begin(); f < range.end(); ++f) add_face(FaceId(f));
    });
  }

  void add_face(FaceId f) {
    const std::uint32_t first = polygons_.first_loop(f.value()),
                        last = polygons_.face_end[f.value()];
    brep_.outer_loop[f] = LoopId(first);
    for (const LoopId l : IdRange<LoopId>(LoopId(first), LoopId(last))) {
      brep_.loop_face[l] = f;
      if (l.value() + 1 < last) brep_.next_loop[l] = LoopId(l.value() + 1);
      const std::uint32_t begin = polygons_.loop_begin(l.value()),
                          end = polygons_.loop_end[l.value()];
      brep_.loop_half_edge[l] = half_edge_[begin];
      for (std::uint32_t i = begin; i < end; ++i) {
        const HalfEdgeId h = half_edge_[i], after = half_edge_[i + 1 < end ? i + 1 : begin];
        brep_.next[h] = after;
        brep_.prev[after] = h;
        brep_.loop[h] = LoopId(l);
        start_[h.value()] = polygons_.corners[i];
      }
    }
  }

  const Polygons& polygons_;
  const std::vector<std::uint32_t>& mate_;
  Brep& brep_;
  std::vector<HalfEdgeId> half_edge_;  // per corner
  std::vector<PointId> start_;         // per half-edge
};

}  // namespace

void build_brep(const Polygons& polygons, const std::vector<std::uint32_t>& mate, Brep& brep) {
  BrepBuilder(polygons, mate, brep).run();
}

}  // namespace sectile
