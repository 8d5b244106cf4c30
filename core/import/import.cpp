
#include <atomic>
#include <string>

#include "geometry/four_points.h"
#include "import/brep_builder.h"
#include "import/contacts.h"
#include "import/diagnosis.h"
#include "import/flat_edges.h"
#include "import/join_flat_faces.h"
#include "import/polygons.h"
#include "import/shells.h"
#include "import/steps.h"
#include "import/triangles/read_triangles.h"
#include "parallel/parallel.h"
#include "sectile/errors.h"

namespace sectile {

void set_planes_and_sources(const Polygons& polygons, std::uint32_t origin, Brep& brep) {
  for (const FaceId f : brep.faces()) {
    brep.plane[f] = PlaneId(f.value());
    brep.source[f] = {origin, polygons.source[f.value()]};
  }
}

namespace {

// The next corner of the other face tells where it is beside the plane. It may also lie in the line
// of the edge, though.
bool lies_flat(const Brep& brep, const Kernel& kernel, HalfEdgeId h) {
  const HalfEdgeId back = Brep::twin(h);
  if (brep.kind_of(brep.face_of(back)) == FaceKind::rest) return false;
  const PointId beyond = brep.point_of(brep.to(brep.next_of(back)));
  return !clearly_off_plane(kernel.geometry(), beyond, brep.plane_of(h)) &&
         kernel.side(beyond, brep.plane_of(h)) == Sign::zero &&
         kernel.parallel(brep.plane_of(h), brep.plane_of(back));
}

}  // namespace

void pin_flat_edges(Brep& brep, Geometry& geometry, const Kernel& kernel) {
  std::vector<std::uint8_t> flat(brep.edge_count(), 0);
  parallel::loop(parallel::Range<std::size_t>(0, flat.size(), 2048), [&](const auto& range) {
    for (std::size_t e = range.begin(); e < range.end(); ++e) {
      const HalfEdgeId h = Brep::half_edge(EdgeId(e));
      flat[e] = lies_flat(brep, kernel, h);
    }
  });
  for (const EdgeId e : brep.edges()) {
    if (!flat[e.value()]) continue;
    const HalfEdgeId h = Brep::half_edge(e);
    const PlaneId plane = brep.plane_of(h);
    const PointId from = brep.point_of(brep.from(h)), to = brep.point_of(brep.to(h));
    if (!kernel.same_direction(plane, brep.plane_of(Brep::twin(h)))) {
      const std::uint32_t f = brep.source[brep.face_of(h)].face;
      const std::uint32_t g = brep.source[brep.face_of(Brep::twin(h))].face;
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

std::uint32_t new_origin() {
  static std::atomic<std::uint32_t> last{0};
  return ++last;
}

namespace {

void check_groups(const SoupView& soup, const ImportOptions& options) {
  if (options.face_groups.empty() || options.face_groups.size() == soup.face_count()) return;
  throw InvalidSolid(InvalidSolid::Reason::malformed,
                     "there are groups for " + std::to_string(options.face_groups.size()) +
                         " faces, but the mesh has " + std::to_string(soup.face_count()));
}

// The faces as they are given. Returns whether there are any.
bool read_faces(const SoupView& soup, const ImportSteps& steps, Kernel& kernel, SolidData& data) {
  std::vector<std::uint32_t> input_vertex;
  Polygons polygons = read_polygons(soup, data.geometry(), input_vertex);
  steps.done(0.05);
  kernel.refresh();
  remove_flat_faces(polygons, kernel);
  find_face_planes(polygons, data.geometry(), kernel);
  if (polygons.face_count() == 0) return false;
  steps.done(0.1);
  const std::vector<std::uint32_t> mate = match_edges(polygons, kernel, input_vertex);
  data.origin = new_origin();
  build_brep(polygons, mate, data.brep());
  set_planes_and_sources(polygons, data.origin, data.brep());
  return true;
}

// A boundary in one block. What was needed on the way, more than the boundary takes, is gone when
// this returns.
std::shared_ptr<SolidData> read_boundary(const SoupView& soup, const ImportOptions& options,
                                         const ImportSteps& steps) {
  auto data = std::make_shared<SolidData>();
  Kernel kernel(data->geometry());
  if (!read_faces(soup, steps, kernel, *data)) return std::make_shared<SolidData>();
  pin_flat_edges(data->brep(), data->geometry(), kernel);
  steps.done(0.2);
  if (!options.trusted) refuse_contacts(data->brep(), kernel, steps.from_to(0.2, 0.9));
  check_orientation(*data, kernel);
  steps.done(0.95);
  data = with_flat_faces_joined(std::move(data), kernel, options.face_groups);
  data->cut();
  return data;
}

std::shared_ptr<const SolidData> import_view(const SoupView& soup, const ImportOptions& options) {
  check_groups(soup, options);
  const ImportSteps steps(options);
  std::shared_ptr<const SolidData> data = read_triangles(soup, options, steps);
  if (!data) data = read_boundary(soup, options, steps);
  steps.done(1);
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
