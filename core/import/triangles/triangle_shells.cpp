#include "import/triangles/triangle_shells.h"

#include <algorithm>

#include "geometry/four_points.h"
#include "import/flat_edges.h"
#include "import/join_flat_faces.h"
#include "import/soup.h"
#include "import/triangles/chunk_vertices.h"
#include "import/triangles/enclosed_volume.h"
#include "import/triangles/mates.h"
#include "import/triangles/triangle_blocks.h"
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

template <class Body>
void for_each(std::size_t count, const Body& body) {
  parallel::loop(tbb::blocked_range<std::size_t>(0, count, step), [&](const auto& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) body(i);
  });
}

using Keys = std::vector<std::uint64_t>;  // see curve_order.h

class ShellReader {
 public:
  ShellReader(const SoupView& soup, const ImportSteps& steps) : soup_(soup), steps_(steps) {
    mesh_.geometry = std::make_shared<Geometry>();
  }

  std::optional<TriangleShells> run() {
    const Keys keys = read_corners();
    if (!put_in_order(keys)) return {};
    corners_ = {};
    number_vertices_in_chunks(mesh_);
    steps_.done(0.05);
    const auto shells = find_mates(mesh_);
    if (!shells) return {};
    if (shells->count == 1)
      made_.shells.push_back(std::move(mesh_));
    else
      take_apart(*shells, keys);
    if (!std::all_of(made_.shells.begin(), made_.shells.end(), encloses_volume)) return {};
    return std::move(made_);
  }

 private:
  // The corners in the order of the input; gives the order of the triangles along the curve.
  Keys read_corners() {
    Geometry& geometry = *mesh_.geometry;
    const std::vector<PointId> points =
        unite_positions(soup_.positions, geometry, made_.input_vertex);
    corners_.resize(soup_.indices.size());
    for_each(corners_.size(), [&](std::size_t i) { corners_[i] = points[soup_.indices[i]]; });
    Bounds all;
    for (const Vec3& p : geometry.positions) all.add(p);
    return keys_along_curve(corners_.size() / 3, all.box(), [&](std::size_t t) {
      const Vec3 &a = geometry.position(corners_[3 * t]),
                 &b = geometry.position(corners_[3 * t + 1]),
                 &c = geometry.position(corners_[3 * t + 2]);
      return Vec3{(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3, (a.z + b.z + c.z) / 3};
    });
  }

  static void cut_into_chunks(const Keys& keys, TriangleMesh& mesh) {
    mesh.chunk_begins = {0};
    add_groups_along_curve(keys, few_faces, faces_of_a_block, 0, mesh.chunk_begins);
    mesh.index_chunks();
  }

  // False if a triangle may have no area.
  bool put_in_order(const Keys& keys) {
    mesh_.source = numbers_of(keys);
    cut_into_chunks(keys, mesh_);
    mesh_.corners.resize(corners_.size());
    return holds_for_all(mesh_.triangle_count(), [&](std::size_t t) {
      for (std::size_t k = 0; k < 3; ++k)
        mesh_.corners[3 * t + k] = corners_[3 * std::size_t(mesh_.source[t]) + k];
      const auto first = static_cast<std::uint32_t>(3 * t);
      return clearly_bent(mesh_.position(first), mesh_.position(first + 1),
                          mesh_.position(first + 2));
    });
  }

  // The triangles of a shell keep their order and their mates.
  void take_apart(const ShellOfTriangle& shells, const Keys& keys) {
    made_.shells.resize(shells.count);
    std::vector<Keys> keys_of(shells.count);
    std::vector<std::uint32_t> number(mesh_.triangle_count());
    for (std::uint32_t t = 0; t < mesh_.triangle_count(); ++t) {
      TriangleMesh& shell = made_.shells[shells.of[t]];
      number[t] = shell.triangle_count();
      shell.source.push_back(mesh_.source[t]);
      keys_of[shells.of[t]].push_back(keys[t]);
    }
    for (std::uint32_t t = 0; t < mesh_.triangle_count(); ++t) {
      TriangleMesh& shell = made_.shells[shells.of[t]];
      for (std::uint32_t corner = 3 * t; corner < 3 * t + 3; ++corner) {
        const std::uint32_t mate = mesh_.mate[corner];
        shell.corners.push_back(mesh_.corners[corner]);
        shell.mate.push_back(3 * number[mate / 3] + mate % 3);
      }
    }
    for (std::size_t s = 0; s < made_.shells.size(); ++s) {
      made_.shells[s].geometry = mesh_.geometry;
      cut_into_chunks(keys_of[s], made_.shells[s]);
      number_vertices_in_chunks(made_.shells[s]);
    }
  }

  const SoupView& soup_;
  const ImportSteps& steps_;
  std::vector<PointId> corners_;
  TriangleMesh mesh_;
  TriangleShells made_;
};

}  // namespace

std::optional<TriangleShells> read_triangle_shells(const SoupView& soup, const ImportSteps& steps) {
  if (soup.face_count() < least_triangles || !all_are(soup.face_loops, 1) ||
      !all_are(soup.loop_sizes, 3))
    return {};
  check_soup(soup);
  return ShellReader(soup, steps).run();
}

std::optional<FlatPart> flat_part_of(const TriangleMesh& shell, std::uint32_t origin) {
  FlatPart part = find_flat_part(shell);
  if (4 * part.triangles.size() > shell.triangle_count()) return {};
  build_flat_part(shell, origin, part);
  pin_flat_edges(part.brep, part.geometry, Kernel(part.geometry));
  return part;
}

TriangleSurface surface_of(std::span<const TriangleMesh> shells, std::span<const FlatPart> parts) {
  std::size_t count = 0;
  for (const TriangleMesh& shell : shells) count += shell.triangle_count();
  TriangleSurface surface;
  surface.along_curve = true;
  surface.corners.resize(count);
  surface.plane.resize(count);
  surface.face.resize(count);
  surface.mate.resize(count);
  std::uint32_t begin = 0;
  for (std::size_t s = 0; s < shells.size(); ++s) {
    const TriangleMesh& shell = shells[s];
    surface.flat.insert(surface.flat.end(), parts[s].holds.begin(), parts[s].holds.end());
    for_each(shell.triangle_count(), [&](std::size_t t) {
      const std::size_t f = begin + t;
      for (std::size_t k = 0; k < 3; ++k) {
        surface.corners[f][k] = shell.corners[3 * t + k];
        surface.mate[f][k] = begin + shell.mate[3 * t + k] / 3;
      }
      surface.plane[f] = PlaneId(f);
      surface.face[f] = static_cast<std::uint32_t>(f);
    });
    begin += shell.triangle_count();
  }
  return surface;
}

void add_planes(const TriangleSurface& surface, Geometry& geometry) {
  geometry.planes.resize(surface.size());
  for_each(surface.size(), [&](std::size_t t) {
    const auto& [a, b, c] = surface.corners[t];
    geometry.planes[PlaneId(t)] = PlaneDefinition::through(a, b, c);
  });
}

std::shared_ptr<SolidData> boundary_of(const TriangleMesh& shell, FlatPart&& part,
                                       std::uint32_t origin,
                                       std::optional<std::span<const std::uint32_t>> groups) {
  TriangleBlocks blocks = make_triangle_blocks(shell, part, origin);
  JoinedFaces joined;
  if (groups) joined = join_flat_faces(part.brep, part.geometry, Kernel(part.geometry), *groups);
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
