#include "import/triangles/read_triangles.h"

#include <algorithm>

#include "geometry/four_points.h"
#include "import/contacts.h"
#include "import/flat_edges.h"
#include "import/join_flat_faces.h"
#include "import/soup.h"
#include "import/triangles/enclosed_volume.h"
#include "import/triangles/flat_part.h"
#include "import/triangles/mates.h"
#include "import/triangles/triangle_blocks.h"
#include "import/triangles/triangle_mesh.h"
#include "import/unite_positions.h"
#include "parallel/parallel.h"
#include "search/curve_groups.h"
#include "search/curve_order.h"
#include "storage/splice.h"

namespace sectile {
namespace {

#ifdef SECTILE_SMALL_BLOCKS  // for tests: meshes of few triangles go this way, too
constexpr std::size_t least_triangles = 24;
#else
constexpr std::size_t least_triangles = 4096;
#endif

constexpr std::size_t step = 4096;

bool all_are(std::span<const std::uint32_t> sizes, std::uint32_t size) {
  return std::all_of(sizes.begin(), sizes.end(), [&](std::uint32_t n) { return n == size; });
}

template <class Holds>
bool holds_for_all(std::size_t count, const Holds& holds) {
  return parallel::reduce(
      tbb::blocked_range<std::size_t>(0, count, step), true,
      [&](const auto& range, bool so_far) {
        for (std::size_t i = range.begin(); i < range.end() && so_far; ++i) so_far = holds(i);
        return so_far;
      },
      std::logical_and<>());
}

// The corners in the order of the input.
std::vector<PointId> read_corners(const SoupView& soup, Geometry& geometry) {
  std::vector<std::uint32_t> input_vertex;
  const std::vector<PointId> points = unite_positions(soup.positions, geometry, input_vertex);
  std::vector<PointId> corners(soup.indices.size());
  parallel::loop(tbb::blocked_range<std::size_t>(0, corners.size(), step), [&](const auto& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) corners[i] = points[soup.indices[i]];
  });
  return corners;
}

// False if a triangle may have no area.
bool read_mesh(const SoupView& soup, TriangleMesh& mesh) {
  const Geometry& geometry = mesh.geometry;
  const std::vector<PointId> corners = read_corners(soup, mesh.geometry);
  Bounds all;
  for (const Vec3& p : geometry.positions) all.add(p);
  const auto keys = keys_along_curve(corners.size() / 3, all.box(), [&](std::size_t t) {
    const Vec3 &a = geometry.position(corners[3 * t]), &b = geometry.position(corners[3 * t + 1]),
               &c = geometry.position(corners[3 * t + 2]);
    return Vec3{(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3, (a.z + b.z + c.z) / 3};
  });
  mesh.source = numbers_of(keys);
  mesh.chunk_begins = {0};
  add_groups_along_curve(keys, few_faces, faces_of_a_block, 0, mesh.chunk_begins);
  mesh.index_chunks();
  mesh.corners.resize(corners.size());
  return holds_for_all(mesh.triangle_count(), [&](std::size_t t) {
    for (std::size_t k = 0; k < 3; ++k)
      mesh.corners[3 * t + k] = corners[3 * std::size_t(mesh.source[t]) + k];
    const auto first = static_cast<std::uint32_t>(3 * t);
    return clearly_bent(mesh.position(first), mesh.position(first + 1), mesh.position(first + 2));
  });
}

// The test against itself needs all planes and all triangles in one structure.
void refuse_crossings(TriangleMesh& mesh, const FlatPart& part, const ImportOptions& options) {
  const std::size_t count = mesh.triangle_count();
  TriangleSurface surface;
  surface.flat = part.holds;
  surface.along_curve = true;
  surface.corners.resize(count);
  surface.plane.resize(count);
  surface.face.resize(count);
  surface.mate.resize(count);
  mesh.geometry.planes.resize(count);
  parallel::loop(tbb::blocked_range<std::size_t>(0, count, step), [&](const auto& range) {
    for (std::size_t f = range.begin(); f < range.end(); ++f) {
      for (std::size_t k = 0; k < 3; ++k) {
        surface.corners[f][k] = mesh.corners[3 * f + k];
        surface.mate[f][k] = mesh.mate[3 * f + k] / 3;
      }
      const auto& [a, b, c] = surface.corners[f];
      mesh.geometry.planes[PlaneId(f)] = PlaneDefinition::through(a, b, c);
      surface.plane[f] = PlaneId(f);
      surface.face[f] = static_cast<std::uint32_t>(f);
    }
  });
  refuse_contacts(surface, mesh.source, Kernel(mesh.geometry), options);
  mesh.geometry.planes.clear();
}

}  // namespace

std::shared_ptr<SolidData> read_triangles(const SoupView& soup, const ImportOptions& options,
                                          const ImportSteps& steps) {
  if (soup.face_count() < least_triangles || !all_are(soup.face_loops, 1) ||
      !all_are(soup.loop_sizes, 3))
    return nullptr;
  check_soup(soup);
  TriangleMesh mesh;
  if (!read_mesh(soup, mesh)) return nullptr;
  steps.done(0.05);
  if (!find_mates(mesh) || !encloses_volume(mesh)) return nullptr;
  steps.done(0.15);
  FlatPart part = find_flat_part(mesh);
  if (4 * part.triangles.size() > mesh.triangle_count()) return nullptr;
  const std::uint32_t origin = new_origin();
  build_flat_part(mesh, origin, part);
  const Kernel kernel(part.geometry);
  pin_flat_edges(part.brep, part.geometry, kernel);
  steps.done(0.2);
  if (!options.trusted) refuse_crossings(mesh, part, steps.from_to(0.2, 0.9));
  TriangleBlocks blocks = make_triangle_blocks(mesh, part, origin);
  steps.done(0.95);
  JoinedFaces joined = join_flat_faces(part.brep, part.geometry, kernel, options.face_groups);
  const bool joins = joined.as_read != nullptr;
  std::shared_ptr<SolidData> data =
      splice(SharedSlots(std::move(blocks.slots)),
             {std::move(joins ? joined.brep : part.brep), joins ? joined.geometry : part.geometry,
              std::move(blocks.outside)},
             false);
  data->origin = origin;
  data->as_read = std::move(joined.as_read);
  return data;
}

}  // namespace sectile
