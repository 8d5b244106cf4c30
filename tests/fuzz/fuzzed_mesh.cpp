#include "fuzz/fuzzed_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace sectile {
namespace {

constexpr int lattice = 5;  // coordinates 0 … 4

class MeshMaker {
 public:
  explicit MeshMaker(Bytes& bytes) : bytes_(bytes) {}

  PolygonMesh run() {
    for (unsigned parts = 1 + bytes_.below(3); parts > 0; --parts) add_part();
    for (unsigned changes = bytes_.below(4); changes > 0; --changes) change();
    PolygonMesh mesh;
    mesh.positions = std::move(positions_);
    for (const auto& face : faces_) {
      mesh.face_sizes.push_back(static_cast<std::uint32_t>(face.size()));
      mesh.indices.insert(mesh.indices.end(), face.begin(), face.end());
    }
    return mesh;
  }

 private:
  using Face = std::vector<std::uint32_t>;

  void add_part() {
    switch (bytes_.below(5)) {
      case 0:
        return add_cells();
      case 1:
        return add_tetrahedron();
      case 2:
        return add_box();
      case 3:
        return add_double_pyramid();
      default:
        return add_soup();
    }
  }

  Vec3 place() {
    const unsigned x = bytes_.below(lattice), y = bytes_.below(lattice), z = bytes_.below(lattice);
    return {double(x), double(y), double(z)};
  }
  std::uint32_t vertex(const Vec3& p) {
    positions_.push_back(p);
    return static_cast<std::uint32_t>(positions_.size() - 1);
  }

  // Squares around a set of cells of 2×2×2; every corner is a position of its own.
  void add_cells() {
    const unsigned cells = bytes_.take();
    const Vec3 low{double(bytes_.below(3)), double(bytes_.below(3)), double(bytes_.below(3))};
    const auto filled = [&](const std::array<int, 3>& c) {
      for (const int v : c)
        if (v < 0 || v > 1) return false;
      return (cells >> (c[0] + 2 * c[1] + 4 * c[2]) & 1) != 0;
    };
    for (int i = 0; i < 8; ++i) {
      const std::array<int, 3> cell{i & 1, i >> 1 & 1, i >> 2};
      if (!filled(cell)) continue;
      for (std::size_t axis = 0; axis < 3; ++axis)
        for (const int side : {0, 1}) {
          auto beside = cell;
          beside[axis] += 2 * side - 1;
          if (filled(beside)) continue;
          Face square;
          for (const auto& [u, v] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}}) {
            auto corner = cell;
            corner[axis] += side;
            corner[(axis + 1) % 3] += u;
            corner[(axis + 2) % 3] += v;
            square.push_back(vertex({low.x + corner[0], low.y + corner[1], low.z + corner[2]}));
          }
          if (side == 0) std::reverse(square.begin(), square.end());
          faces_.push_back(square);
        }
    }
  }

  void add_tetrahedron() {
    Vec3 p[4];
    for (Vec3& q : p) q = place();
    const auto minus = [](const Vec3& a, const Vec3& b) {
      return Vec3{a.x - b.x, a.y - b.y, a.z - b.z};
    };
    const Vec3 u = minus(p[1], p[0]), v = minus(p[2], p[0]), w = minus(p[3], p[0]);
    const double det = u.x * (v.y * w.z - v.z * w.y) - u.y * (v.x * w.z - v.z * w.x) +
                       u.z * (v.x * w.y - v.y * w.x);
    if (det < 0) std::swap(p[0], p[1]);
    std::uint32_t n[4];
    for (int i = 0; i < 4; ++i) n[i] = vertex(p[i]);
    add_faces({{n[0], n[2], n[1]}, {n[0], n[1], n[3]}, {n[1], n[2], n[3]}, {n[2], n[0], n[3]}});
  }

  void add_box() {
    const Vec3 a = place(), b = place();
    const double x[2] = {std::min(a.x, b.x), std::max(a.x, b.x)},
                 y[2] = {std::min(a.y, b.y), std::max(a.y, b.y)},
                 z[2] = {std::min(a.z, b.z), std::max(a.z, b.z)};
    std::uint32_t n[8];
    for (int i = 0; i < 8; ++i) n[i] = vertex({x[i & 1], y[i >> 1 & 1], z[i >> 2]});
    add_faces({{n[0], n[2], n[3], n[1]},
               {n[4], n[5], n[7], n[6]},
               {n[0], n[1], n[5], n[4]},
               {n[1], n[3], n[7], n[5]},
               {n[3], n[2], n[6], n[7]},
               {n[2], n[0], n[4], n[6]}},
              bytes_.below(4) == 3);
  }

  // Two apexes over a polygon around the lattice's middle; its corners need not be coplanar.
  void add_double_pyramid() {
    constexpr std::array<std::pair<int, int>, 8> round = {
        {{4, 2}, {4, 4}, {2, 4}, {0, 4}, {0, 2}, {0, 0}, {2, 0}, {4, 0}}};
    const std::uint32_t top = vertex({2, 2, 4}), bottom = vertex({2, 2, 0});
    const unsigned used = bytes_.take() | 0x29;
    Face ring;
    for (unsigned i = 0; i < 8; ++i)
      if (used >> i & 1)
        ring.push_back(
            vertex({double(round[i].first), double(round[i].second), double(1 + bytes_.below(3))}));
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const std::uint32_t a = ring[i], b = ring[i + 1 < ring.size() ? i + 1 : 0];
      add_faces({{a, b, top}, {b, a, bottom}});
    }
  }

  void add_soup() {
    const unsigned places = 1 + bytes_.below(8);
    const auto first = static_cast<std::uint32_t>(positions_.size());
    for (unsigned i = 0; i < places; ++i) vertex(place());
    for (unsigned count = bytes_.below(8); count > 0; --count) {
      Face face;
      for (unsigned n = bytes_.below(6); n > 0; --n) face.push_back(first + bytes_.below(places));
      faces_.push_back(face);
    }
  }

  void add_faces(const std::vector<Face>& faces, bool inwards = false) {
    for (Face face : faces) {
      if (inwards) std::reverse(face.begin(), face.end());
      faces_.push_back(face);
    }
  }

  void change() {
    if (faces_.empty() || positions_.empty()) return;
    Vec3& position = positions_[bytes_.below(static_cast<unsigned>(positions_.size()))];
    const unsigned number = bytes_.below(static_cast<unsigned>(faces_.size()));
    Face& face = faces_[number];
    switch (bytes_.below(9)) {
      case 0:
        return void(position = place());
      case 1:
        return move_all(position, place());
      case 2:
        return move_all(position, nudged(position));
      case 3:
        return void(std::reverse(face.begin(), face.end()));
      case 4:
        return void(faces_.erase(faces_.begin() + number));
      case 5:
        return fan(number);
      case 6:
        return cut_edge(number);
      case 7:
        return fold_corner(face);
      default:
        return turn_all();
    }
  }

  void move_all(const Vec3 from, const Vec3& to) {
    for (Vec3& p : positions_)
      if (p == from) p = to;
  }
  Vec3 nudged(Vec3 p) {
    constexpr double far = std::numeric_limits<double>::infinity();
    double* const coordinates[] = {&p.x, &p.y, &p.z};
    double& v = *coordinates[bytes_.below(3)];
    v = std::nextafter(v, bytes_.below(2) ? far : -far);
    return p;
  }
  void fan(std::size_t number) {
    const Face face = faces_[number];
    if (face.size() < 4) return;
    faces_[number] = {face[0], face[1], face[2]};
    for (std::size_t i = 2; i + 1 < face.size(); ++i)
      faces_.push_back({face[0], face[i], face[i + 1]});
  }
  // A corner in the middle of the first edge, and a flat triangle for the neighbour.
  void cut_edge(std::size_t number) {
    if (faces_[number].size() < 2) return;
    const std::uint32_t a = faces_[number][0], b = faces_[number][1];
    const Vec3 &p = positions_[a], &q = positions_[b];
    const std::uint32_t middle = vertex({(p.x + q.x) / 2, (p.y + q.y) / 2, (p.z + q.z) / 2});
    faces_[number].insert(faces_[number].begin() + 1, middle);
    faces_.push_back({a, b, middle});
  }
  // A path there and back again.
  void fold_corner(Face& face) {
    if (face.empty()) return;
    const std::uint32_t corner = face[0], to = vertex(place());
    face.insert(face.begin(), {corner, to});
  }
  void turn_all() {
    for (Face& face : faces_) std::reverse(face.begin(), face.end());
  }

  Bytes& bytes_;
  std::vector<Vec3> positions_;
  std::vector<Face> faces_;
};

}  // namespace

PolygonMesh fuzzed_mesh(Bytes& bytes) {
  return MeshMaker(bytes).run();
}

}  // namespace sectile
