#include "sectile/solid.h"

#include <cmath>

#include "geometry/face_predicates.h"
#include "geometry/triangulation.h"
#include "import/shells.h"
#include "import/soup.h"
#include "storage/solid_data.h"

namespace sectile {

Solid::Solid() = default;
Solid::~Solid() = default;
Solid::Solid(const Solid&) = default;
Solid::Solid(Solid&&) noexcept = default;
Solid& Solid::operator=(const Solid&) = default;
Solid& Solid::operator=(Solid&&) noexcept = default;
Solid::Solid(std::shared_ptr<const SolidData> data) : data_(std::move(data)) {}

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

namespace {

// Sums with the rounding errors carried along.
class Sum {
 public:
  void add(double term) {
    const double next = total_ + term;
    rest_ += std::abs(total_) >= std::abs(term) ? (total_ - next) + term : (term - next) + total_;
    total_ = next;
  }
  double value() const { return total_ + rest_; }

 private:
  double total_ = 0, rest_ = 0;
};

Vec3 minus(const Vec3& a, const Vec3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
double dot(const Vec3& a, const Vec3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

// Calls visit(a, b, c) for the triangles of a fan of each loop, around the loop's first corner.
template <class Visit>
void for_each_fan(const SolidData& data, FaceId f, const Visit& visit) {
  const Brep& brep = data.brep();
  const auto position = [&](HalfEdgeId h) -> const Vec3& {
    return data.geometry().position(brep.point_of(brep.from(h)));
  };
  for (LoopId l = brep.outer_loop[f.value()]; l.valid(); l = brep.next_loop[l.value()]) {
    const HalfEdgeId first = brep.loop_half_edge[l.value()];
    for (HalfEdgeId h = brep.next_of(first); brep.next_of(h) != first; h = brep.next_of(h))
      visit(position(first), position(h), position(brep.next_of(h)));
  }
}

}  // namespace

double Solid::volume() const {
  if (is_empty()) return 0;
  Sum sum;
  const Vec3 origin = data_->geometry().position(data_->brep().point[0]);
  for (std::size_t f = 0; f < data_->brep().face_count(); ++f)
    for_each_fan(*data_, FaceId(f), [&](const Vec3& a, const Vec3& b, const Vec3& c) {
      sum.add(dot(minus(a, origin), cross(minus(b, origin), minus(c, origin))));
    });
  return sum.value() / 6;
}

double Solid::area() const {
  if (is_empty()) return 0;
  Sum sum;
  for (std::size_t f = 0; f < data_->brep().face_count(); ++f) {
    Sum x, y, z;
    for_each_fan(*data_, FaceId(f), [&](const Vec3& a, const Vec3& b, const Vec3& c) {
      const Vec3 n = cross(minus(b, a), minus(c, a));
      x.add(n.x);
      y.add(n.y);
      z.add(n.z);
    });
    sum.add(std::hypot(x.value(), y.value(), z.value()));
  }
  return sum.value() / 2;
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
  const Brep& brep = data_->brep();
  const Geometry& geometry = data_->geometry();
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
