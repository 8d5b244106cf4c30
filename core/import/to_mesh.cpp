// Solids as triangles. Faces that were joined on import, and not changed since, are given back as
// they were read.
#include <algorithm>
#include <unordered_map>

#include "geometry/moved_geometry.h"
#include "import/face_triangles.h"
#include "numbers/none.h"
#include "parallel/parallel.h"
#include "sectile/solid.h"
#include "storage/block_triangles.h"
#include "storage/faces_as_read.h"
#include "storage/moved_solid.h"

namespace sectile {
namespace {

struct SamePlace {
  std::size_t operator()(const Vec3& p) const {
    std::size_t hash = 0;
    for (const double x : {p.x, p.y, p.z})
      hash = (hash ^ std::hash<double>()(x)) * 0x9E3779B97F4A7C15u;
    return hash ^ hash >> 32;
  }
};

class MeshMaker {
 public:
  MeshMaker(const Solid& solid, const std::shared_ptr<const FacesAsRead>& read,
            std::vector<FaceSource>& sources)
      : brep_(solid.data()->brep()),
        geometry_(solid.data()->geometry()),
        origin_(solid.origin()),
        read_(read.get()),
        sources_(sources),
        number_(geometry_.positions.size(), none) {
    if (read_) place_what_was_read(solid.moved());
  }

  PolygonMesh run() {
    add_faces();
    if (read_) add_what_was_read();
    return std::move(mesh_);
  }

 private:
  void place_what_was_read(const MovedSolid* moved) {
    if (!moved) {
      places_ = read_->geometry.positions.items();
      return;
    }
    GeometryMover mover(moved->frame());
    mover.prepare(read_->geometry);
    places_ = std::move(mover(read_->geometry).positions.items());
    mirrored_ = moved->frame().determinant().sign() == Sign::negative;
  }

  std::uint32_t vertex(PointId p) {
    std::uint32_t& n = number_[p.value()];
    if (n == none) n = add_position(geometry_.position(p));
    return n;
  }
  std::uint32_t add_position(const Vec3& p) {
    mesh_.positions.push_back(p);
    return static_cast<std::uint32_t>(mesh_.positions.size() - 1);
  }
  void add_triangle(const std::array<std::uint32_t, 3>& corners, FaceSource source) {
    mesh_.indices.insert(mesh_.indices.end(), corners.begin(), corners.end());
    mesh_.face_sizes.push_back(3);
    sources_.push_back(source);
  }

  struct Triangle {
    FaceId face;
    std::array<PointId, 3> corners;
  };

  // Cut on all cores; vertices are numbered in the order of the faces.
  void add_faces() {
    constexpr std::size_t step = 1024;
    std::vector<std::vector<Triangle>> parts((brep_.face_count() + step - 1) / step);
    parallel::loop(0, parts.size(), [&](std::size_t p) {
      FaceTriangles(brep_, geometry_, faces_to_cut(p * step, (p + 1) * step))
          .for_each([&](FaceId f, PointId a, PointId b, PointId c) {
            parts[p].push_back({f, {a, b, c}});
          });
    });
    std::size_t count = 0;
    for (const auto& part : parts) count += part.size();
    mesh_.indices.reserve(3 * count);
    mesh_.face_sizes.reserve(count);
    sources_.reserve(count);
    for (const auto& part : parts)
      for (const auto& [f, corners] : part)
        add_triangle({vertex(corners[0]), vertex(corners[1]), vertex(corners[2])}, brep_.source[f]);
  }

  std::vector<FaceId> faces_to_cut(std::size_t first, std::size_t end) const {
    std::vector<FaceId> faces;
    for (std::size_t i = first; i < std::min(end, brep_.face_count()); ++i) {
      const FaceId f(i);
      if (!read_ || read_->of(brep_.source[f].face).empty()) faces.push_back(f);
    }
    return faces;
  }

  // Their vertices are those of the other faces where there are such.
  void add_what_was_read() {
    std::unordered_map<Vec3, std::uint32_t, SamePlace> at;
    for (std::uint32_t v = 0; v < mesh_.positions.size(); ++v) at.emplace(mesh_.positions[v], v);
    std::vector<std::uint32_t> number(places_.size());
    for (std::size_t p = 0; p < places_.size(); ++p) {
      const auto [known, is_new] = at.emplace(places_[p], none);
      if (is_new) known->second = add_position(places_[p]);
      number[p] = known->second;
    }
    for (const FacesAsRead::Triangle& t : read_->triangles) {
      const auto [a, b, c] = t.corners;
      const std::uint32_t second = number[b.value()], third = number[c.value()];
      add_triangle({number[a.value()], mirrored_ ? third : second, mirrored_ ? second : third},
                   {origin_, t.source});
    }
  }

  const Brep& brep_;
  const Geometry& geometry_;
  std::uint32_t origin_;
  const FacesAsRead* read_;
  UnsetVector<Vec3> places_;  // of what was read
  bool mirrored_ = false;
  std::vector<FaceSource>& sources_;
  std::vector<std::uint32_t> number_;  // per point: its vertex
  PolygonMesh mesh_;
};

}  // namespace

namespace {

PolygonMesh mesh_of(const SolidData& data, BlockTriangles triangles,
                    std::vector<FaceSource>& sources) {
  PolygonMesh mesh;
  mesh.positions.resize(triangles.vertex_count);
  mesh.face_sizes.assign(triangles.source.size(), 3);
  parallel::loop(0, data.slots().size(), [&](std::size_t i) {
    const auto s = static_cast<std::uint32_t>(i);
    if (data.slot(s).empty()) return;
    triangles.each_own_vertex(s, *data.slot(s).block,
                              [&](std::uint32_t v, const Vec3& p, bool) { mesh.positions[v] = p; });
  });
  mesh.indices = std::move(triangles.indices);
  sources = std::move(triangles.source);
  return mesh;
}

}  // namespace

PolygonMesh Solid::to_mesh() const {
  std::vector<FaceSource> sources;
  return to_mesh(sources);
}

PolygonMesh Solid::to_mesh(std::vector<FaceSource>& sources) const {
  sources.clear();
  if (is_empty()) return {};
  if (const SolidData& moved = *data(); !moved.is_whole() && !data_->as_read)
    if (auto triangles = block_triangles(moved))
      return mesh_of(moved, std::move(*triangles), sources);
  return MeshMaker(*this, data_->as_read, sources).run();
}

}  // namespace sectile
