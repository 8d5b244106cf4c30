#include "sectile/solid.h"

#include "geometry/face_predicates.h"
#include "geometry/triangulation.h"
#include "import/measure.h"
#include "import/shells.h"
#include "import/soup.h"
#include "storage/moved_solid.h"
#include "storage/solid_data.h"

namespace sectile {

Solid::Solid() = default;
Solid::~Solid() = default;
Solid::Solid(const Solid&) = default;
Solid::Solid(Solid&&) noexcept = default;
Solid& Solid::operator=(const Solid&) = default;
Solid& Solid::operator=(Solid&&) noexcept = default;
Solid::Solid(std::shared_ptr<const SolidData> data) : data_(std::move(data)) {}
Solid::Solid(std::shared_ptr<const MovedSolid> moved)
    : data_(moved->original()), moved_(std::move(moved)) {}

const std::shared_ptr<const SolidData>& Solid::data() const {
  return moved_ ? moved_->image() : data_;
}

Solid Solid::from_mesh(const PolygonMesh& mesh) {
  return from_mesh(mesh, {});
}

Solid Solid::from_mesh(const PolygonMesh& mesh, const ImportOptions& options) {
  return Solid(import_mesh(mesh, options));
}

bool Solid::is_empty() const {
  return !data_ || data_->empty();
}

std::uint32_t Solid::origin() const {
  return data_ ? data_->origin : 0;
}

double Solid::volume() const {
  return is_empty() ? 0 : volume_of(*data());
}

double Solid::area() const {
  return is_empty() ? 0 : area_of(*data());
}

SolidCounts Solid::counts() const {
  SolidCounts counts;
  if (is_empty()) return counts;
  const Brep& brep = data_->brep();
  counts.vertices = brep.vertex_count();
  counts.edges = brep.edge_count();
  counts.faces = brep.face_count();
  counts.loops = brep.loop_count();
  counts.shells = find_shells(brep).count;
  // Euler and Poincaré: V - E + F - (L - F) = 2 (S - G).
  const auto count = [](std::size_t n) { return static_cast<std::int64_t>(n); };
  const std::int64_t euler =
      count(counts.vertices) - count(counts.edges) + 2 * count(counts.faces) - count(counts.loops);
  counts.genus = count(counts.shells) - euler / 2;
  return counts;
}

PolygonMesh Solid::to_mesh() const {
  std::vector<FaceSource> sources;
  return to_mesh(sources);
}

PolygonMesh Solid::to_mesh(std::vector<FaceSource>& sources) const {
  PolygonMesh mesh;
  sources.clear();
  if (is_empty()) return mesh;
  const Brep& brep = data()->brep();
  const Geometry& geometry = data()->geometry();
  std::vector<std::uint32_t> number(geometry.positions.size(), 0xFFFFFFFFu);
  const auto vertex = [&](PointId p) {
    std::uint32_t& n = number[p.value()];
    if (n == 0xFFFFFFFFu) {
      n = static_cast<std::uint32_t>(mesh.positions.size());
      mesh.positions.push_back(geometry.position(p));
    }
    return n;
  };
  const Kernel kernel(geometry);
  std::vector<PointId> corners;
  std::vector<std::uint32_t> loop_ends;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (std::size_t f = 0; f < brep.face_count(); ++f) {
    corners.clear();
    loop_ends.clear();
    triangles.clear();
    for (LoopId l = brep.outer_loop[f]; l.valid(); l = brep.next_loop[l.value()]) {
      for_each_in_loop(brep, l,
                       [&](HalfEdgeId h) { corners.push_back(brep.point_of(brep.from(h))); });
      loop_ends.push_back(static_cast<std::uint32_t>(corners.size()));
    }
    const PlaneId plane = brep.plane[f];
    const int axis = kernel.main_axis(plane);
    const FacePredicates exact(kernel, axis, kernel.normal(plane, axis) == Sign::negative, corners);
    triangulate(exact, std::span<const std::uint32_t>(loop_ends), triangles);
    for (const auto& t : triangles) {
      for (const std::uint32_t c : t) mesh.indices.push_back(vertex(corners[c]));
      mesh.face_sizes.push_back(3);
      sources.push_back(brep.source[f]);
    }
  }
  return mesh;
}

}  // namespace sectile
