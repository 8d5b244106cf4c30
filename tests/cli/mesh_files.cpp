#include "mesh_files.h"

#include <cmath>
#include <cstdint>
#include <map>
#include <sstream>

namespace sectile::test {
namespace {

using Point = std::array<double, 3>;

std::ostringstream text_stream() {
  std::ostringstream out;
  out.precision(17);
  return out;
}

void put(std::ostream& out, const Point& p) {
  out << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
}

template <class T>
void put_bytes(std::ostream& out, T value) {
  out.write(reinterpret_cast<const char*>(&value), sizeof value);
}

template <class Visit>
void for_each_triangle(const FileMesh& mesh, const Visit& visit) {
  for (const auto& face : mesh.faces)
    for (std::size_t i = 2; i < face.size(); ++i) visit(std::array{face[0], face[i - 1], face[i]});
}

std::string obj(const FileMesh& mesh) {
  std::ostringstream out = text_stream();
  for (const Point& p : mesh.positions) put(out << "v ", p);
  for (const auto& face : mesh.faces) {
    out << 'f';
    for (const int v : face) out << ' ' << v + 1;
    out << '\n';
  }
  return out.str();
}

void put_faces(std::ostream& out, const FileMesh& mesh) {
  for (const auto& face : mesh.faces) {
    out << face.size();
    for (const int v : face) out << ' ' << v;
    out << '\n';
  }
}

std::string off(const FileMesh& mesh) {
  std::ostringstream out = text_stream();
  out << "OFF\n" << mesh.positions.size() << ' ' << mesh.faces.size() << " 0\n";
  for (const Point& p : mesh.positions) put(out, p);
  put_faces(out, mesh);
  return out.str();
}

std::string ply_header(const FileMesh& mesh, const std::string& encoding) {
  return "ply\nformat " + encoding + " 1.0\nelement vertex " +
         std::to_string(mesh.positions.size()) +
         "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
         std::to_string(mesh.faces.size()) +
         "\nproperty list uchar int vertex_indices\nend_header\n";
}

std::string ply(const FileMesh& mesh) {
  std::ostringstream out = text_stream();
  out << ply_header(mesh, "ascii");
  for (const Point& p : mesh.positions) put(out, p);
  put_faces(out, mesh);
  return out.str();
}

std::string ply_binary(const FileMesh& mesh) {
  std::ostringstream out;
  out << ply_header(mesh, "binary_little_endian");
  for (const Point& p : mesh.positions)
    for (const double c : p) put_bytes(out, c);
  for (const auto& face : mesh.faces) {
    put_bytes(out, static_cast<std::uint8_t>(face.size()));
    for (const int v : face) put_bytes(out, static_cast<std::int32_t>(v));
  }
  return out.str();
}

std::string stl(const FileMesh& mesh) {
  std::ostringstream out = text_stream();
  out << "solid test\n";
  for_each_triangle(mesh, [&](const std::array<int, 3>& corners) {
    out << "facet normal 0 0 0\nouter loop\n";
    for (const int v : corners) put(out << "vertex ", mesh.positions[static_cast<std::size_t>(v)]);
    out << "endloop\nendfacet\n";
  });
  out << "endsolid test\n";
  return out.str();
}

std::string stl_binary(const FileMesh& mesh) {
  std::ostringstream out;
  std::uint32_t count = 0;
  for_each_triangle(mesh, [&](const std::array<int, 3>&) { ++count; });
  out << std::string(80, ' ');
  put_bytes(out, count);
  for_each_triangle(mesh, [&](const std::array<int, 3>& corners) {
    for (int i = 0; i < 3; ++i) put_bytes(out, 0.0f);
    for (const int v : corners)
      for (const double c : mesh.positions[static_cast<std::size_t>(v)])
        put_bytes(out, static_cast<float>(c));
    put_bytes(out, std::uint16_t{0});
  });
  return out.str();
}

}  // namespace

FileMesh cube(double x, double y, double z) {
  FileMesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.positions.push_back({x + (i & 1 ? 2 : 0), y + (i & 2 ? 2 : 0), z + (i & 4 ? 2 : 0)});
  mesh.faces = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  return mesh;
}

FileMesh together(const FileMesh& a, const FileMesh& b) {
  FileMesh both = a;
  const int shift = static_cast<int>(a.positions.size());
  both.positions.insert(both.positions.end(), b.positions.begin(), b.positions.end());
  for (auto face : b.faces) {
    for (int& v : face) v += shift;
    both.faces.push_back(face);
  }
  return both;
}

FileMesh self_crossing_prism() {
  FileMesh mesh;
  for (const double z : {0.0, 1.0})
    for (const auto& [x, y] : {std::pair{0.0, 0.0}, {2.0, 0.0}, {0.5, 2.0}, {2.0, 2.5}})
      mesh.positions.push_back({x, y, z});
  mesh.faces = {{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  return mesh;
}

FileMesh bulged_cube(int n, double bulge) {
  FileMesh mesh;
  std::map<std::array<int, 3>, int> numbers;
  const auto vertex = [&](const std::array<int, 3>& at) {
    const auto [found, is_new] = numbers.insert({at, static_cast<int>(numbers.size())});
    if (is_new) {
      Point p;
      double length = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        p[k] = 2.0 * at[k] / n - 1;
        length += p[k] * p[k];
      }
      for (double& c : p) c *= 1 + bulge / std::sqrt(length);
      mesh.positions.push_back(p);
    }
    return found->second;
  };
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const int side : {0, n})
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
          const auto at = [&](int u, int v) {
            std::array<int, 3> cell{};
            cell[axis] = side;
            cell[(axis + 1) % 3] = u;
            cell[(axis + 2) % 3] = v;
            return vertex(cell);
          };
          const int a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
          if (side == 0) {
            mesh.faces.push_back({a, d, c});
            mesh.faces.push_back({a, c, b});
          } else {
            mesh.faces.push_back({a, b, c});
            mesh.faces.push_back({a, c, d});
          }
        }
  return mesh;
}

std::string name_of(Format format) {
  switch (format) {
    case Format::obj:
      return "obj";
    case Format::off:
      return "off";
    case Format::ply:
      return "ply";
    case Format::ply_binary:
      return "ply_binary";
    case Format::stl:
      return "stl";
    case Format::stl_binary:
      break;
  }
  return "stl_binary";
}

std::string extension_of(Format format) {
  const std::string name = name_of(format);
  return "." + name.substr(0, name.find('_'));
}

std::string content(const FileMesh& mesh, Format format) {
  switch (format) {
    case Format::obj:
      return obj(mesh);
    case Format::off:
      return off(mesh);
    case Format::ply:
      return ply(mesh);
    case Format::ply_binary:
      return ply_binary(mesh);
    case Format::stl:
      return stl(mesh);
    case Format::stl_binary:
      break;
  }
  return stl_binary(mesh);
}

}  // namespace sectile::test
