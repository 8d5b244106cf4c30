// STL: which of its two forms a file has, and the text form.
#include <cctype>

#include "files/facet_normal.h"
#include "files/formats.h"
#include "files/scanner.h"
#include "files/stl_binary.h"
#include "files/writable.h"

namespace sectile {
namespace {

bool is_word(std::string_view token, std::string_view lower_case) {
  return token.size() == lower_case.size() &&
         std::equal(token.begin(), token.end(), lower_case.begin(), [](char a, char b) {
           return std::tolower(static_cast<unsigned char>(a)) == b;
         });
}

bool is_binary(std::string_view content, std::string_view name) {
  if (has_size_of_binary_stl(content)) return true;
  Scanner scan(content, name, Scanner::no_comments);
  return may_be_binary_stl(content) && !is_word(scan.token(), "solid");
}

class TextReader {
 public:
  TextReader(std::string_view content, std::string_view name)
      : scan_(content, name, Scanner::no_comments) {}

  PolygonMesh run() {
    expect("solid");
    while (true) {
      // What follows "solid", "endsolid" on their line is a name.
      if (!scan_.next_line()) scan_.fail("the file ends without \"endsolid\"");
      const std::string_view word = scan_.token_on_any_line("\"facet\" or \"endsolid\"");
      if (is_word(word, "facet"))
        read_facet();
      else if (!is_word(word, "endsolid"))
        scan_.fail("\"facet\" or \"endsolid\" is expected, not " + in_quotes(word));
      else if (!find_next_solid())
        return std::move(mesh_);
    }
  }

 private:
  void expect(const char* word) {
    const std::string wanted = "\"" + std::string(word) + "\"";
    const std::string_view found = scan_.token_on_any_line(wanted.c_str());
    if (!is_word(found, word)) scan_.fail(wanted + " is expected, not " + in_quotes(found));
  }

  bool find_next_solid() {
    while (scan_.next_line()) {
      const std::string_view word = scan_.token();
      if (is_word(word, "solid")) return true;
      if (!word.empty()) scan_.fail("\"solid\" is expected, not " + in_quotes(word));
    }
    return false;
  }

  // The corners' order says where the outside is; the normal, often wrong or nan, is passed over.
  void read_facet() {
    expect("normal");
    for (int i = 0; i < 3; ++i) scan_.token_on_any_line("a normal");
    expect("outer");
    expect("loop");
    for (int i = 0; i < 3; ++i) read_corner();
    expect("endloop");
    expect("endfacet");
    if (!scan_.at_line_end() && !scan_.token().empty())
      scan_.fail("more than \"endfacet\" in its line");
    mesh_.face_sizes.push_back(3);
  }

  void read_corner() {
    expect("vertex");
    Vec3 p;
    for (double* c : {&p.x, &p.y, &p.z})
      *c = scan_.real(scan_.token_on_any_line("a coordinate"), "the coordinate");
    mesh_.indices.push_back(static_cast<std::uint32_t>(mesh_.positions.size()));
    mesh_.positions.push_back(p);
  }

  Scanner scan_;
  PolygonMesh mesh_;
};

}  // namespace

PolygonMesh read_stl(std::string_view content, std::string_view name) {
  return is_binary(content, name) ? read_stl_binary(content, name)
                                  : TextReader(content, name).run();
}

void write_stl_text(Sink& out, const PolygonMesh& mesh, std::string_view name) {
  require_triangles(mesh, name, "STL");
  out << "solid sectile\n";
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const Vec3 &a = mesh.positions[mesh.indices[i]], &b = mesh.positions[mesh.indices[i + 1]],
               &c = mesh.positions[mesh.indices[i + 2]];
    out << "facet normal " << facet_normal(a, b, c) << "\nouter loop\n";
    for (const Vec3* p : {&a, &b, &c}) out << "vertex " << *p << '\n';
    out << "endloop\nendfacet\n";
  }
  out << "endsolid sectile\n";
}

}  // namespace sectile
