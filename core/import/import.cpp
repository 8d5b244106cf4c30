#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <atomic>
#include <string>

#include "import/contacts.h"
#include "import/diagnosis.h"
#include "import/polygons.h"
#include "import/shells.h"
#include "sectile/errors.h"

namespace sectile {
namespace {

class BrepBuilder {
 public:
  BrepBuilder(const Polygons& polygons, const std::vector<std::uint32_t>& mate, Brep& brep)
      : polygons_(polygons), mate_(mate), brep_(brep), half_edge_(polygons.corners.size()) {}

  void run(std::uint32_t origin) {
    number_half_edges();
    add_faces(origin);
    add_vertices();
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
    brep_.origin.resize(next);
    brep_.next.resize(next);
    brep_.prev.resize(next);
    brep_.loop.resize(next);
    start_.resize(next);
  }

  void add_faces(std::uint32_t origin) {
    const std::size_t faces = polygons_.face_count(), loops = polygons_.loop_end.size();
    brep_.outer_loop.resize(faces);
    brep_.plane.resize(faces);
    brep_.source.resize(faces);
    brep_.loop_half_edge.resize(loops);
    brep_.loop_face.resize(loops);
    brep_.next_loop.resize(loops);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, faces, 1024), [&](const auto& range) {
      for (std::size_t f = range.begin(); f < range.end(); ++f) add_face(FaceId(f), origin);
    });
  }

  void add_face(FaceId f, std::uint32_t origin) {
    const std::uint32_t first = polygons_.first_loop(f.value());
    brep_.outer_loop[f.value()] = LoopId(first);
    brep_.plane[f.value()] = PlaneId(f.value());
    brep_.source[f.value()] = {origin, polygons_.source[f.value()]};
    for (std::uint32_t l = first; l < polygons_.face_end[f.value()]; ++l) {
      brep_.loop_face[l] = f;
      if (l + 1 < polygons_.face_end[f.value()]) brep_.next_loop[l] = LoopId(l + 1);
      const std::uint32_t begin = polygons_.loop_begin(l), end = polygons_.loop_end[l];
      brep_.loop_half_edge[l] = half_edge_[begin];
      for (std::uint32_t i = begin; i < end; ++i) {
        const HalfEdgeId h = half_edge_[i], after = half_edge_[i + 1 < end ? i + 1 : begin];
        brep_.next[h.value()] = after;
        brep_.prev[after.value()] = h;
        brep_.loop[h.value()] = LoopId(l);
        start_[h.value()] = polygons_.corners[i];
      }
    }
  }

  // One vertex for each cycle of edges.
  void add_vertices() {
    for (std::size_t i = 0; i < brep_.half_edge_count(); ++i) {
      if (brep_.origin[i].valid()) continue;
      const HalfEdgeId first{i};
      const VertexId v(brep_.vertex_count());
      brep_.point.push_back(start_[i]);
      brep_.vertex_half_edge.push_back(first);
      HalfEdgeId h = first;
      do {
        brep_.origin[h.value()] = v;
        h = brep_.around(h);
      } while (h != first);
    }
  }

  const Polygons& polygons_;
  const std::vector<std::uint32_t>& mate_;
  Brep& brep_;
  std::vector<HalfEdgeId> half_edge_;  // per corner
  std::vector<PointId> start_;         // per half-edge
};

// Edges between coplanar faces need a plane that pins them down.
void pin_flat_edges(Brep& brep, Geometry& geometry, const Kernel& kernel) {
  std::vector<std::uint8_t> flat(brep.edge_count(), 0);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, flat.size(), 2048), [&](const auto& range) {
    for (std::size_t e = range.begin(); e < range.end(); ++e) {
      const HalfEdgeId h = Brep::half_edge(EdgeId(e));
      flat[e] = kernel.parallel(brep.plane_of(h), brep.plane_of(Brep::twin(h)));
    }
  });
  for (std::size_t e = 0; e < flat.size(); ++e) {
    if (!flat[e]) continue;
    const HalfEdgeId h = Brep::half_edge(EdgeId(e));
    const PlaneId plane = brep.plane_of(h);
    const PointId from = brep.point_of(brep.from(h)), to = brep.point_of(brep.to(h));
    if (!kernel.same_direction(plane, brep.plane_of(Brep::twin(h)))) {
      const std::uint32_t f = brep.source[brep.face_of(h).value()].face;
      const std::uint32_t g = brep.source[brep.face_of(Brep::twin(h)).value()].face;
      throw InvalidSolid(InvalidSolid::Reason::self_intersecting,
                         "faces " + std::to_string(f) + " and " + std::to_string(g) +
                             " are folded onto each other along the edge from " +
                             in_words(geometry.position(from)) + " to " +
                             in_words(geometry.position(to)) +
                             "; remove them where they lie on each other",
                         f);
    }
    if (brep.edge_plane.empty()) brep.edge_plane.resize(brep.edge_count());
    brep.edge_plane[e] =
        geometry.add_plane(PlaneDefinition::along_axis(from, to, kernel.main_axis(plane)));
  }
}

}  // namespace

std::uint32_t new_origin() {
  static std::atomic<std::uint32_t> last{0};
  return ++last;
}

namespace {

std::shared_ptr<const SolidData> import_view(const SoupView& soup, const ImportOptions& options) {
  auto data = std::make_shared<SolidData>();
  std::vector<std::uint32_t> input_vertex;
  Polygons polygons = read_polygons(soup, data->geometry(), input_vertex);
  Kernel kernel(data->geometry());
  remove_flat_faces(polygons, kernel);
  find_face_planes(polygons, data->geometry(), kernel);
  if (polygons.face_count() == 0) return std::make_shared<SolidData>();
  const std::vector<std::uint32_t> mate = match_edges(polygons, kernel, input_vertex);
  data->origin = new_origin();
  BrepBuilder(polygons, mate, data->brep()).run(data->origin);
  pin_flat_edges(data->brep(), data->geometry(), kernel);
  if (!options.trusted) refuse_contacts(data->brep(), kernel, options);
  check_orientation(*data, kernel);
  data->cut();
  return data;
}

}  // namespace

std::shared_ptr<const SolidData> import_soup(const Soup& soup, const ImportOptions& options) {
  if (soup.face_loops.empty() && !soup.loop_sizes.empty())
    throw InvalidSolid(InvalidSolid::Reason::malformed, "there are loops that belong to no face");
  return import_view({soup.positions, soup.face_loops, soup.loop_sizes, soup.indices}, options);
}

std::shared_ptr<const SolidData> import_mesh(const PolygonMesh& mesh,
                                             const ImportOptions& options) {
  return import_view({mesh.positions, {}, mesh.face_sizes, mesh.indices}, options);
}

}  // namespace sectile
