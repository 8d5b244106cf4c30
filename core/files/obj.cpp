// Wavefront OBJ: vertices and faces; names, materials, texture coordinates and normals are passed
// over.
//
// tinyobjloader reads the faces and only them. It does not round coordinates correctly, makes 0 of
// nan, reads any text as some number, joins no lines and does not say where it is. So a stream
// deals out one face statement at a time: everything else was read here before, the statement was
// looked through, and when the loader calls back with its corners the line is still known.
#include <tiny_obj_loader.h>

#include <algorithm>
#include <array>
#include <istream>
#include <span>
#include <streambuf>

#include "files/formats.h"
#include "files/scanner.h"

namespace sectile {
namespace {

// What the loader keeps in an int for certain.
constexpr std::size_t most_digits = 9;

constexpr std::array<std::string_view, 17> harmless{
    "vn",    "vt",       "usemtl",   "g",          "s",        "o",
    "vp",    "mg",       "mtllib",   "usemap",     "maplib",   "lod",
    "bevel", "c_interp", "d_interp", "shadow_obj", "trace_obj"};
constexpr std::array<std::string_view, 5> other_elements{"l", "p", "curv", "curv2", "surf"};

bool is_among(std::string_view word, std::span<const std::string_view> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

class ObjReader final : private std::streambuf {
 public:
  ObjReader(std::string_view content, std::string_view name)
      : scan_(content, name, '#', /*joins_lines=*/true) {}

  PolygonMesh run() {
    std::istream faces(this);
    faces.exceptions(std::ios::badbit);  // passes on what underflow() throws
    tinyobj::callback_t callback;
    callback.index_cb = [](void* reader, tinyobj::index_t* corners, int count) {
      static_cast<ObjReader*>(reader)->add_face({corners, static_cast<std::size_t>(count)});
    };
    std::string error;
    const bool done = tinyobj::LoadObjWithCallback(faces, callback, this, nullptr, nullptr, &error);
    if (!done || !error.empty()) scan_.fail_at(statement_line_, "not understood: " + error);
    if (mesh_.face_sizes.size() != faces_dealt_) scan_.fail("not all faces were understood");
    return std::move(mesh_);
  }

 private:
  // Goes on to the next face statement and reads the vertices before it.
  int_type underflow() override {
    while (more_) {
      statement_line_ = scan_.line();
      const std::string_view keyword = scan_.token();
      const bool face = keyword == "f";
      if (face)
        deal_out_face();
      else if (keyword == "v")
        read_vertex();
      else if (!keyword.empty())
        pass_over(keyword);
      more_ = scan_.next_line();
      if (face) return traits_type::to_int_type(*gptr());
    }
    return traits_type::eof();
  }

  void read_vertex() {
    Vec3 p;
    for (double* c : {&p.x, &p.y, &p.z}) *c = scan_.real(scan_.token(), "the coordinate");
    mesh_.positions.push_back(p);
    if (!scan_.at_line_end()) check_weight_and_colour();
  }

  // A weight, a colour, or both. Weights are for rational curves; a vertex has none but 1.
  void check_weight_and_colour() {
    std::array<double, 4> values{};
    std::size_t count = 0;
    for (std::string_view t = scan_.token(); !t.empty(); t = scan_.token()) {
      if (count == values.size()) scan_.fail("a vertex with more than seven numbers");
      values[count++] = scan_.real(t, "the weight or colour");
    }
    if (count == 2) scan_.fail("a vertex with five numbers");
    if (count % 3 == 1 && values[0] != 1)
      scan_.fail("the weight of the vertex is not 1; solids have no rational points");
  }

  void deal_out_face() {
    statement_ = "f";
    corners_dealt_ = 0;
    for (std::string_view t = scan_.token(); !t.empty(); t = scan_.token()) {
      check_corner(t);
      (statement_ += ' ') += t;
      ++corners_dealt_;
    }
    if (corners_dealt_ < 3) scan_.fail_at(statement_line_, "a face needs at least three corners");
    statement_ += '\n';
    ++faces_dealt_;
    setg(statement_.data(), statement_.data(), statement_.data() + statement_.size());
  }

  // vertex/texture/normal, of which the last two may be absent.
  void check_corner(std::string_view corner) const {
    std::size_t at = 0;
    for (int part = 0;; ++part) {
      if (at < corner.size() && corner[at] == '-') ++at;
      const bool negative = at > 0 && corner[at - 1] == '-';
      const std::size_t first = at;
      while (at < corner.size() && corner[at] >= '0' && corner[at] <= '9') ++at;
      if (at - first > most_digits)
        scan_.fail(in_quotes(corner) + " holds a number that is too large");
      const bool end = at == corner.size();
      const bool may_be_absent = part > 0 && !negative;
      if ((at == first && !may_be_absent) || (!end && (corner[at] != '/' || part == 2)))
        scan_.fail(in_quotes(corner) + " is not a corner, which is like 7, 7/2, 7//3 or 7/2/3");
      if (end) return;
      ++at;
    }
  }

  void add_face(std::span<const tinyobj::index_t> corners) {
    if (corners.size() != corners_dealt_)
      scan_.fail_at(statement_line_, "the corners of the face are not understood");
    for (const tinyobj::index_t& corner : corners)
      mesh_.indices.push_back(vertex(corner.vertex_index));
    mesh_.face_sizes.push_back(static_cast<std::uint32_t>(corners.size()));
  }

  std::uint32_t vertex(std::int64_t number) const {
    const auto count = static_cast<std::int64_t>(mesh_.positions.size());
    if (number == 0 || number > count || number < -count)
      scan_.fail_at(statement_line_, "vertex " + std::to_string(number) +
                                         " does not exist; there are " + std::to_string(count) +
                                         " so far");
    return static_cast<std::uint32_t>(number > 0 ? number - 1 : count + number);
  }

  // Statements without geometry may be passed over; others would be lost.
  void pass_over(std::string_view keyword) {
    if (is_among(keyword, other_elements))
      scan_.fail(in_quotes(keyword) + " elements do not bound solids; remove them");
    if (!is_among(keyword, harmless)) scan_.fail("unknown statement " + in_quotes(keyword));
    while (!scan_.token().empty()) continue;
  }

  Scanner scan_;
  bool more_ = true;
  std::uint64_t statement_line_ = 1;
  std::string statement_;  // the face statement that the loader reads at present
  std::size_t corners_dealt_ = 0, faces_dealt_ = 0;
  PolygonMesh mesh_;
};

}  // namespace

PolygonMesh read_obj(std::string_view content, std::string_view name) {
  return ObjReader(content, name).run();
}

void write_obj(Sink& out, const PolygonMesh& mesh) {
  // A file without a byte would not tell an empty solid from a lost one.
  if (mesh.positions.empty()) out << "# the empty solid\n";
  for (const Vec3& p : mesh.positions) out << "v " << p << '\n';
  std::size_t at = 0;
  for (const std::uint32_t size : mesh.face_sizes) {
    out << 'f';
    for (std::uint32_t i = 0; i < size; ++i) out << ' ' << std::uint64_t{mesh.indices[at++]} + 1;
    out << '\n';
  }
}

}  // namespace sectile
