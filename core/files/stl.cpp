// STL, text and binary. A binary file may begin with "solid" too, so its size decides.
#include <bit>
#include <cmath>
#include <cstring>

#include "files/formats.h"
#include "files/scanner.h"

namespace sectile {
namespace {

constexpr std::size_t header_size = 84, facet_size = 50;

template <class T>
T little_endian(const char* at) {
  T value;
  std::memcpy(&value, at, sizeof value);
  static_assert(std::endian::native == std::endian::little);
  return value;
}

bool is_binary(std::string_view content) {
  if (content.size() < header_size) return false;
  const auto count = little_endian<std::uint32_t>(content.data() + 80);
  if (content.size() == header_size + facet_size * std::uint64_t(count)) return true;
  return content.substr(0, 5) != "solid";
}

void add_corner(PolygonMesh& mesh, const Vec3& p) {
  mesh.indices.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
  mesh.positions.push_back(p);
}

PolygonMesh read_binary(std::string_view content, const std::string& name) {
  const auto fail = [&](std::size_t at, const std::string& what) {
    throw FileError(name + ": byte " + std::to_string(at) + ": " + what);
  };
  const auto count = little_endian<std::uint32_t>(content.data() + 80);
  const std::uint64_t wanted = header_size + facet_size * std::uint64_t(count);
  if (content.size() != wanted)
    fail(content.size(), std::to_string(count) + " triangles need " + std::to_string(wanted) +
                             " bytes, but the file has " + std::to_string(content.size()));
  PolygonMesh mesh;
  mesh.face_sizes.assign(count, 3);
  for (std::uint32_t i = 0; i < count; ++i)
    for (int corner = 0; corner < 3; ++corner) {
      const std::size_t at =
          header_size + facet_size * std::size_t(i) + 12 + 12 * std::size_t(corner);
      const float x = little_endian<float>(content.data() + at),
                  y = little_endian<float>(content.data() + at + 4),
                  z = little_endian<float>(content.data() + at + 8);
      if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z))
        fail(at, "triangle " + std::to_string(i) + " has a coordinate that is not finite");
      add_corner(mesh, {x, y, z});
    }
  return mesh;
}

class TextReader {
 public:
  TextReader(std::string_view content, std::string_view name) : scan_(content, name) {}

  PolygonMesh run() {
    expect("solid");
    for (;;) {
      if (!scan_.next_line()) scan_.fail("the file ends without \"endsolid\"");
      const std::string_view word = scan_.token('\0');
      if (word.empty()) continue;
      if (word == "facet") {
        read_facet();
      } else if (word == "endsolid") {
        if (!more_solids()) return std::move(mesh_);
      } else {
        scan_.fail("\"facet\" or \"endsolid\" is expected, not \"" + std::string(word) + "\"");
      }
    }
  }

 private:
  void expect(std::string_view word) {
    const std::string_view t = scan_.any_token("more");
    if (t != word)
      scan_.fail("\"" + std::string(word) + "\" is expected, not \"" + std::string(t) + "\"");
  }

  // After endsolid and its name.
  bool more_solids() {
    while (scan_.next_line()) {
      const std::string_view word = scan_.token('\0');
      if (word == "solid") return true;
      if (!word.empty()) scan_.fail("\"solid\" is expected, not \"" + std::string(word) + "\"");
    }
    return false;
  }

  void read_facet() {
    expect("normal");
    for (int i = 0; i < 3; ++i) scan_.any_token("a normal");
    expect("outer");
    expect("loop");
    for (int i = 0; i < 3; ++i) {
      expect("vertex");
      Vec3 p;
      for (double* c : {&p.x, &p.y, &p.z})
        *c = scan_.real(scan_.any_token("a coordinate"), "the coordinate");
      add_corner(mesh_, p);
    }
    expect("endloop");
    expect("endfacet");
    mesh_.face_sizes.push_back(3);
  }

  Scanner scan_;
  PolygonMesh mesh_;
};

Vec3 normal(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double ux = b.x - a.x, uy = b.y - a.y, uz = b.z - a.z;
  const double vx = c.x - a.x, vy = c.y - a.y, vz = c.z - a.z;
  const Vec3 n{uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx};
  const double length = std::hypot(n.x, n.y, n.z);
  return length > 0 ? Vec3{n.x / length, n.y / length, n.z / length} : Vec3{};
}

}  // namespace

PolygonMesh read_stl(std::string_view content, std::string_view name) {
  if (content.empty()) throw FileError(std::string(name) + ":1: the file is empty");
  return is_binary(content) ? read_binary(content, std::string(name))
                            : TextReader(content, name).run();
}

void write_stl_text(std::ostream& out, const PolygonMesh& mesh) {
  out << "solid sectile\n";
  const auto put = [&](const char* word, const Vec3& p) {
    out << word << ' ' << shortest(p.x) << ' ' << shortest(p.y) << ' ' << shortest(p.z) << '\n';
  };
  for_each_triangle(mesh, [&](const Vec3& a, const Vec3& b, const Vec3& c) {
    put("facet normal", normal(a, b, c));
    out << "outer loop\n";
    for (const Vec3* p : {&a, &b, &c}) put("vertex", *p);
    out << "endloop\nendfacet\n";
  });
  out << "endsolid sectile\n";
}

void write_stl_binary(std::ostream& out, const PolygonMesh& mesh) {
  std::uint32_t count = 0;
  for_each_triangle(mesh, [&](const Vec3&, const Vec3&, const Vec3&) { ++count; });
  char header[80] = "binary STL by sectile";
  out.write(header, sizeof header);
  out.write(reinterpret_cast<const char*>(&count), 4);
  const auto put = [&](const Vec3& p) {
    const float floats[3] = {static_cast<float>(p.x), static_cast<float>(p.y),
                             static_cast<float>(p.z)};
    out.write(reinterpret_cast<const char*>(floats), 12);
  };
  for_each_triangle(mesh, [&](const Vec3& a, const Vec3& b, const Vec3& c) {
    put(normal(a, b, c));
    for (const Vec3* p : {&a, &b, &c}) put(*p);
    out.write("\0\0", 2);
  });
}

}  // namespace sectile
