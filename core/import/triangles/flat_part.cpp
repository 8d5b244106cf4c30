#include "import/triangles/flat_part.h"

#include <algorithm>

#include "import/triangles/read_chunks.h"
#include "search/id_map.h"
#include "topology/open_ends.h"
#include "topology/vertex_cycles.h"

namespace sectile {
namespace {

class PartBuilder {
 public:
  PartBuilder(const TriangleMesh& mesh, std::uint32_t origin, FlatPart& part)
      : mesh_(mesh),
        origin_(origin),
        part_(part),
        brep_(part.brep),
        half_edge_(3 * part.triangles.size()),
        points_(2 * part.triangles.size()) {}

  void run() {
    number_half_edges();
    for (std::size_t i = 0; i < part_.triangles.size(); ++i) add_face(i);
    std::vector<HalfEdgeId> open;
    for (std::size_t e = 0; e < part_.open.size(); ++e) {
      open.push_back(Brep::half_edge(EdgeId(e), 1));
      start_[open.back().value()] = point(mesh_.to(part_.open[e]));
    }
    close_open_ends(brep_, open);
    make_vertices(brep_, start_);
  }

 private:
  // Those that leave the part first.
  void number_half_edges() {
    std::uint32_t next = 0;
    for_each_corner([&](std::uint32_t corner, HalfEdgeId& h) {
      if (part_.holds[mesh_.mate[corner] / 3]) return;
      part_.open.push_back(corner);
      h = HalfEdgeId(next);
      next += 2;
    });
    for_each_corner([&](std::uint32_t corner, HalfEdgeId& h) {
      if (h.valid()) return;
      h = HalfEdgeId(next);
      half_edge_[local(mesh_.mate[corner])] = HalfEdgeId(next + 1);
      next += 2;
    });
    brep_.resize_half_edges(next);
    start_.resize(next);
  }

  template <class Visit>
  void for_each_corner(const Visit& visit) {
    for (std::size_t i = 0; i < part_.triangles.size(); ++i)
      for (std::uint32_t k = 0; k < 3; ++k)
        visit(3 * part_.triangles[i] + k, half_edge_[3 * i + k]);
  }

  std::size_t local(std::uint32_t corner) const {
    const auto& all = part_.triangles;
    const auto at = std::lower_bound(all.begin(), all.end(), corner / 3);
    return 3 * static_cast<std::size_t>(at - all.begin()) + corner % 3;
  }

  PointId point(PointId p) {
    std::uint32_t& known = points_[p.value()];
    if (known == IdMap::none) known = part_.geometry.add_point(mesh_.position(p)).value();
    return PointId(known);
  }

  void add_face(std::size_t i) {
    PointId corners[3];
    for (std::size_t k = 0; k < 3; ++k) {
      const HalfEdgeId h = half_edge_[3 * i + k], after = half_edge_[3 * i + (k + 1) % 3];
      corners[k] = point(mesh_.from(3 * part_.triangles[i] + static_cast<std::uint32_t>(k)));
      start_[h.value()] = corners[k];
      brep_.next[h] = after;
      brep_.prev[after] = h;
      brep_.loop[h] = LoopId(i);
    }
    const PlaneId plane =
        part_.geometry.add_plane(PlaneDefinition::through(corners[0], corners[1], corners[2]));
    brep_.kind.add(FaceKind::real);
    brep_.add_loop(brep_.add_face(plane, {origin_, mesh_.source[part_.triangles[i]]}, LoopId(i)),
                   half_edge_[3 * i]);
  }

  const TriangleMesh& mesh_;
  std::uint32_t origin_;
  FlatPart& part_;
  Brep& brep_;
  std::vector<HalfEdgeId> half_edge_;  // per corner of the part
  std::vector<PointId> start_;         // per half-edge
  IdMap points_;
};

}  // namespace

FlatPart find_flat_part(const TriangleMesh& mesh) {
  FlatPart part;
  part.holds.assign(mesh.triangle_count(), 0);
  const auto add = [&](const std::vector<std::uint32_t>& triangles, std::uint32_t first) {
    for (const std::uint32_t t : triangles) {
      if (part.holds[first + t] == 0) part.triangles.push_back(first + t);
      part.holds[first + t] = 1;
    }
  };
  add(mesh.borders.flat, 0);
  for (std::uint32_t c = 0; c < mesh.chunk_count(); ++c)
    add(mesh.chunks[c].flat, mesh.chunk_begin(c));
  std::sort(part.triangles.begin(), part.triangles.end());
  return part;
}

void build_flat_part(TriangleMesh& mesh, std::uint32_t origin, FlatPart& part) {
  std::vector<std::uint32_t> chunks;
  for (const std::uint32_t t : part.triangles)
    if (chunks.empty() || t >= mesh.chunk_end(chunks.back())) chunks.push_back(mesh.chunk_of(t));
  find_mates(mesh, chunks);
  PartBuilder(mesh, origin, part).run();
}

}  // namespace sectile
