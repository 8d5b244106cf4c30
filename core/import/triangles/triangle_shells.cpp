#include "import/triangles/triangle_shells.h"

#include <algorithm>

#include "import/flat_edges.h"
#include "import/join_flat_faces.h"
#include "import/soup.h"
#include "import/triangles/enclosed_volume.h"
#include "import/triangles/read_chunks.h"
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

template <class Body>
void for_each(std::size_t count, const Body& body) {
  parallel::loop(parallel::Range<std::size_t>(0, count, step), [&](const auto& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) body(i);
  });
}

using Keys = std::vector<std::uint64_t>;  // see curve_order.h

class ShellReader {
 public:
  ShellReader(const SoupView& soup, const ImportSteps& steps) : soup_(soup), steps_(steps) {}

  std::optional<TriangleShells> run() {
    unite_positions();
    const Keys keys = order_along_curve();
    put_in_order(keys, mesh_);
    steps_.done(0.05);
    const std::optional<ShellOfTriangle> shells = read_surface(readers_, mesh_);
    if (!shells) return {};
    if (shells->count == 1)
      made_.shells.push_back(std::move(mesh_));
    else
      take_apart(*shells, keys);
    if (!std::all_of(made_.shells.begin(), made_.shells.end(), encloses_volume)) return {};
    return std::move(made_);
  }

 private:
  // Where all positions are different, they are the points as they stand.
  void unite_positions() {
    positions_ = soup_.positions;
    corners_ = soup_.indices;
    const std::vector<std::uint32_t> first = first_equals(soup_.positions);
    if (first.empty()) return;
    std::vector<std::uint32_t> point(first.size());
    for (std::uint32_t i = 0; i < first.size(); ++i) {
      if (first[i] == i) {
        point[i] = static_cast<std::uint32_t>(made_.united_positions.size());
        made_.united_positions.push_back(soup_.positions[i]);
        made_.input_vertex.push_back(i);
      } else {
        point[i] = point[first[i]];
      }
    }
    made_.united_corners.resize(soup_.indices.size());
    for_each(soup_.indices.size(),
             [&](std::size_t i) { made_.united_corners[i] = point[soup_.indices[i]]; });
    positions_ = made_.united_positions;
    corners_ = made_.united_corners;
  }

  Keys order_along_curve() const {
    Bounds all;
    for (const Vec3& p : positions_) all.add(p);
    return keys_along_curve(corners_.size() / 3, all.box(), [&](std::size_t t) {
      const Vec3 &a = positions_[corners_[3 * t]], &b = positions_[corners_[3 * t + 1]],
                 &c = positions_[corners_[3 * t + 2]];
      return Vec3{(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3, (a.z + b.z + c.z) / 3};
    });
  }

  void put_in_order(const Keys& keys, TriangleMesh& mesh) const {
    mesh.positions = positions_;
    mesh.input_corners = corners_;
    mesh.source.resize(keys.size());
    for_each(keys.size(),
             [&](std::size_t t) { mesh.source[t] = static_cast<std::uint32_t>(keys[t]); });
    mesh.chunk_begins = {0};
    add_groups_along_curve(keys, few_faces, faces_of_a_block, 0, mesh.chunk_begins);
  }

  // The triangles of a shell keep their order.
  void take_apart(const ShellOfTriangle& shells, const Keys& keys) {
    made_.shells.resize(shells.count);
    std::vector<Keys> keys_of(shells.count);
    std::vector<std::vector<std::uint32_t>> place_of(shells.count);
    for (std::uint32_t t = 0; t < keys.size(); ++t) {
      keys_of[shells.of[t]].push_back(keys[t]);
      place_of[shells.of[t]].push_back(t);
    }
    parallel::loop(0, shells.count, [&](std::size_t s) {
      put_in_order(keys_of[s], made_.shells[s]);
      read_shell(readers_, known_chunks(made_.shells[s], place_of[s]), made_.shells[s]);
    });
  }

  // Where no other shell is near, chunks of all triangles are chunks of one shell. `places` has the
  // number of each of its triangles among all.
  std::vector<TriangleChunk*> known_chunks(const TriangleMesh& shell,
                                           const std::vector<std::uint32_t>& places) {
    std::vector<TriangleChunk*> known;
    for (std::uint32_t c = 0; c < shell.chunk_count(); ++c) {
      const std::uint32_t first = places[shell.chunk_begin(c)],
                          last = places[shell.chunk_end(c) - 1], chunk = mesh_.chunk_of(first);
      const bool is_same = mesh_.chunk_begin(chunk) == first &&
                           mesh_.chunk_end(chunk) == last + 1 &&
                           last - first == shell.chunk_end(c) - 1 - shell.chunk_begin(c);
      known.push_back(is_same ? &mesh_.chunks[chunk] : nullptr);
    }
    return known;
  }

  const SoupView& soup_;
  const ImportSteps& steps_;
  std::span<const Vec3> positions_;         // of the points
  std::span<const std::uint32_t> corners_;  // points, in the order of the input
  ChunkReaders readers_;
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

std::optional<FlatPart> flat_part_of(TriangleMesh& shell, std::uint32_t origin) {
  FlatPart part = find_flat_part(shell);
  if (4 * part.triangles.size() > shell.triangle_count()) return {};
  build_flat_part(shell, origin, part);
  pin_flat_edges(part.brep, part.geometry, Kernel(part.geometry));
  return part;
}

TriangleSurface surface_of(std::span<TriangleMesh> shells, std::span<const FlatPart> parts) {
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
    TriangleMesh& shell = shells[s];
    find_mates(shell);
    surface.flat.insert(surface.flat.end(), parts[s].holds.begin(), parts[s].holds.end());
    for_each(shell.triangle_count(), [&](std::size_t t) {
      const std::size_t f = begin + t;
      for (std::size_t k = 0; k < 3; ++k) {
        surface.corners[f][k] = PointId(shell.corners[3 * t + k]);
        surface.mate[f][k] = begin + shell.mate[3 * t + k] / 3;
      }
      surface.plane[f] = PlaneId(f);
      surface.face[f] = static_cast<std::uint32_t>(f);
    });
    begin += shell.triangle_count();
  }
  return surface;
}

Geometry geometry_of(const TriangleMesh& mesh, const TriangleSurface& surface) {
  Geometry geometry;
  geometry.positions.resize(mesh.positions.size());
  geometry.construct.assign(mesh.positions.size(), Geometry::explicit_point);
  for_each(mesh.positions.size(),
           [&](std::size_t p) { geometry.positions[PointId(p)] = mesh.position(PointId(p)); });
  geometry.planes.resize(surface.size());
  for_each(surface.size(), [&](std::size_t t) {
    const auto& [a, b, c] = surface.corners[t];
    geometry.planes[PlaneId(t)] = PlaneDefinition::through(a, b, c);
  });
  return geometry;
}

std::shared_ptr<SolidData> boundary_of(TriangleMesh&& shell, FlatPart&& part, std::uint32_t origin,
                                       std::optional<std::span<const std::uint32_t>> groups) {
  TriangleBlocks blocks = make_triangle_blocks(std::move(shell), part, origin);
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
