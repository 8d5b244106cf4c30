// Wavefront OBJ: `v` and `f`, with all that tinyobjloader passes over in silence as an error: it
// rounds coordinates wrongly, cuts faces of more than 255 corners, turns nan into 0 and only warns
// of numbers out of range. What would remain for it is the splitting of "v/t/n".

#include <unordered_set>

#include "files/formats.h"
#include "files/scanner.h"

namespace sectile {
namespace {

class ObjReader {
 public:
  ObjReader(std::string_view content, std::string_view name) : scan_(content, name) {}

  PolygonMesh run() {
    do {
      const std::string_view keyword = scan_.token();
      if (keyword == "v")
        read_vertex();
      else if (keyword == "f")
        read_face();
      else if (!keyword.empty())
        check_keyword(std::string(keyword));
    } while (scan_.next_line());
    return std::move(mesh_);
  }

 private:
  void read_vertex() {
    Vec3 p;
    for (double* c : {&p.x, &p.y, &p.z}) *c = scan_.real(scan_.token(), "the coordinate");
    mesh_.positions.push_back(p);
  }

  void read_face() {
    std::uint32_t size = 0;
    for (std::string_view t = scan_.token(); !t.empty(); t = scan_.token()) {
      mesh_.indices.push_back(vertex(t));
      ++size;
    }
    if (size < 3) scan_.fail("a face needs at least three corners");
    mesh_.face_sizes.push_back(size);
  }

  std::uint32_t vertex(std::string_view corner) {
    const std::string_view number = corner.substr(0, corner.find('/'));
    const std::int64_t index = scan_.integer(number, "the vertex number");
    check_rest(corner);
    const auto count = static_cast<std::int64_t>(mesh_.positions.size());
    if (index == 0 || index > count || index < -count)
      scan_.fail("vertex " + std::string(number) + " does not exist; there are " +
                 std::to_string(count) + " so far");
    return static_cast<std::uint32_t>(index > 0 ? index - 1 : count + index);
  }

  void check_rest(std::string_view corner) const {
    std::size_t at = corner.find('/');
    for (int part = 0; at != std::string_view::npos; ++part) {
      const std::size_t next = corner.find('/', at + 1);
      const std::string_view number = corner.substr(
          at + 1, next == std::string_view::npos ? std::string_view::npos : next - at - 1);
      if (part > 1) scan_.fail("the corner \"" + std::string(corner) + "\" has too many parts");
      if (!number.empty()) scan_.integer(number, "the texture or normal number");
      at = next;
    }
  }

  // Statements without geometry may be passed over; others would be lost.
  void check_keyword(const std::string& keyword) const {
    static const std::unordered_set<std::string> harmless{
        "vt",    "vn",       "vp",       "g",          "o",        "s",
        "mg",    "usemtl",   "mtllib",   "usemap",     "maplib",   "lod",
        "bevel", "c_interp", "d_interp", "shadow_obj", "trace_obj"};
    if (harmless.count(keyword)) return;
    if (keyword == "l" || keyword == "p" || keyword == "curv" || keyword == "curv2" ||
        keyword == "surf")
      scan_.fail("\"" + keyword + "\" elements do not bound solids; remove them");
    scan_.fail("unknown statement \"" + keyword + "\"");
  }

  Scanner scan_;
  PolygonMesh mesh_;
};

}  // namespace

PolygonMesh read_obj(std::string_view content, std::string_view name) {
  return ObjReader(content, name).run();
}

void write_obj(std::ostream& out, const PolygonMesh& mesh) {
  for (const Vec3& p : mesh.positions)
    out << "v " << shortest(p.x) << ' ' << shortest(p.y) << ' ' << shortest(p.z) << '\n';
  std::size_t at = 0;
  for (const std::uint32_t size : mesh.face_sizes) {
    out << 'f';
    for (std::uint32_t i = 0; i < size; ++i) out << ' ' << mesh.indices[at++] + 1;
    out << '\n';
  }
}

}  // namespace sectile
