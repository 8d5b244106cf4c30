// OFF, with the variants COFF and NOFF (colours and normals are passed over).
#include "files/formats.h"
#include "files/scanner.h"

namespace sectile {
namespace {

class OffReader {
 public:
  OffReader(std::string_view content, std::string_view name)
      : scan_(content, name), size_(content.size()) {}

  PolygonMesh run() {
    const std::string_view keyword = scan_.any_token("\"OFF\"");
    if (keyword != "OFF" && keyword != "COFF" && keyword != "NOFF" && keyword != "CNOFF")
      scan_.fail("\"OFF\" is expected, not \"" + std::string(keyword) + "\"");
    const std::int64_t vertices = count("the number of vertices"),
                       faces = count("the number of faces");
    count("the number of edges");
    for (std::int64_t i = 0; i < vertices; ++i) read_vertex();
    for (std::int64_t i = 0; i < faces; ++i) read_face();
    return std::move(mesh_);
  }

 private:
  std::int64_t count(const char* what) {
    const std::int64_t n = scan_.integer(scan_.any_token(what), what);
    if (n < 0 || static_cast<std::uint64_t>(n) > size_)
      scan_.fail(std::string(what) + " does not fit the size of the file");
    return n;
  }

  void read_vertex() {
    Vec3 p;
    p.x = scan_.real(scan_.any_token("a vertex"), "the coordinate");
    for (double* c : {&p.y, &p.z}) *c = scan_.real(scan_.token(), "the coordinate");
    mesh_.positions.push_back(p);
    scan_.next_line();
  }

  void read_face() {
    const std::int64_t corners = scan_.integer(scan_.any_token("a face"), "the number of corners");
    if (corners < 3 || static_cast<std::uint64_t>(corners) > size_)
      scan_.fail("a face with " + std::to_string(corners) + " corners");
    for (std::int64_t i = 0; i < corners; ++i) {
      const std::int64_t v = scan_.integer(scan_.token(), "the vertex number");
      if (v < 0 || static_cast<std::uint64_t>(v) >= mesh_.positions.size())
        scan_.fail("vertex " + std::to_string(v) + " does not exist; there are " +
                   std::to_string(mesh_.positions.size()));
      mesh_.indices.push_back(static_cast<std::uint32_t>(v));
    }
    mesh_.face_sizes.push_back(static_cast<std::uint32_t>(corners));
    scan_.next_line();
  }

  Scanner scan_;
  std::size_t size_;
  PolygonMesh mesh_;
};

}  // namespace

PolygonMesh read_off(std::string_view content, std::string_view name) {
  return OffReader(content, name).run();
}

void write_off(std::ostream& out, const PolygonMesh& mesh) {
  out << "OFF\n" << mesh.positions.size() << ' ' << mesh.face_sizes.size() << " 0\n";
  for (const Vec3& p : mesh.positions)
    out << shortest(p.x) << ' ' << shortest(p.y) << ' ' << shortest(p.z) << '\n';
  std::size_t at = 0;
  for (const std::uint32_t size : mesh.face_sizes) {
    out << size;
    for (std::uint32_t i = 0; i < size; ++i) out << ' ' << mesh.indices[at++];
    out << '\n';
  }
}

}  // namespace sectile
