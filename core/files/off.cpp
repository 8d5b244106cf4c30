// OFF in text, with the variants COFF, NOFF and CNOFF; colours and normals are passed over.
#include <algorithm>

#include "files/formats.h"
#include "files/scanner.h"

namespace sectile {
namespace {

class OffReader {
 public:
  OffReader(std::string_view content, std::string_view name) : scan_(content, name) {}

  PolygonMesh run() {
    read_keyword();
    const std::size_t vertices = count("the number of vertices"),
                      faces = count("the number of faces");
    count("the number of edges");
    mesh_.positions.reserve(vertices);
    mesh_.face_sizes.reserve(faces);
    for (std::size_t i = 0; i < vertices; ++i) read_vertex();
    for (std::size_t i = 0; i < faces; ++i) read_face();
    scan_.require_end("the last face");
    return std::move(mesh_);
  }

 private:
  void read_keyword() {
    const std::string_view keyword = scan_.token_on_any_line("\"OFF\"");
    if (keyword != "OFF" && keyword != "COFF" && keyword != "NOFF" && keyword != "CNOFF")
      scan_.fail("\"OFF\" is expected, not " + in_quotes(keyword));
    has_more_ = keyword != "OFF";
  }

  // Every item takes at least two bytes; no file can claim more memory than it is worth.
  std::size_t count(const char* what) {
    const std::int64_t n = scan_.integer(scan_.token_on_any_line(what), what);
    if (n < 0 || static_cast<std::uint64_t>(n) > scan_.rest().size())
      scan_.fail(std::string(what) + " does not fit the size of the file");
    return static_cast<std::size_t>(n);
  }

  void read_vertex() {
    Vec3 p;
    for (double* c : {&p.x, &p.y, &p.z})
      *c = scan_.real(scan_.token_on_any_line("a coordinate"), "the coordinate");
    mesh_.positions.push_back(p);
    for (std::string_view t = scan_.token(); !t.empty(); t = scan_.token()) {
      if (!has_more_)
        scan_.fail(
            "a vertex with more than three coordinates; with colours or normals the first "
            "line is COFF or NOFF");
      scan_.real(t, "the colour or normal");
    }
  }

  void read_face() {
    const std::int64_t corners =
        scan_.integer(scan_.token_on_any_line("a face"), "the number of corners");
    if (corners < 3 || static_cast<std::uint64_t>(corners) > scan_.rest().size())
      scan_.fail("a face with " + std::to_string(corners) + " corners");
    for (std::int64_t i = 0; i < corners; ++i) {
      const std::int64_t v =
          scan_.integer(scan_.token_on_any_line("a vertex number"), "the vertex number");
      if (v < 0 || static_cast<std::uint64_t>(v) >= mesh_.positions.size())
        scan_.fail("vertex " + std::to_string(v) + " does not exist; there are " +
                   std::to_string(mesh_.positions.size()) + ", counted from 0");
      mesh_.indices.push_back(static_cast<std::uint32_t>(v));
    }
    mesh_.face_sizes.push_back(static_cast<std::uint32_t>(corners));
    read_colour();
  }

  void read_colour() {
    int numbers = 0;
    for (std::string_view t = scan_.token(); !t.empty(); t = scan_.token()) {
      scan_.real(t, "the face's colour");
      if (++numbers > 4) scan_.fail("more than four numbers after a face");
    }
  }

  Scanner scan_;
  bool has_more_ = false;  // vertices with colours or normals
  PolygonMesh mesh_;
};

}  // namespace

PolygonMesh read_off(std::string_view content, std::string_view name) {
  return OffReader(content, name).run();
}

void write_off(Sink& out, const PolygonMesh& mesh) {
  out << "OFF\n" << mesh.positions.size() << ' ' << mesh.face_sizes.size() << " 0\n";
  for (const Vec3& p : mesh.positions) out << p << '\n';
  write_faces(out, mesh);
}

void write_faces(Sink& out, const PolygonMesh& mesh) {
  std::size_t at = 0;
  for (const std::uint32_t size : mesh.face_sizes) {
    out << size;
    for (std::uint32_t i = 0; i < size; ++i) out << ' ' << mesh.indices[at++];
    out << '\n';
  }
}

}  // namespace sectile
