#include "files/ply_header.h"

#include <algorithm>
#include <array>

namespace sectile::ply {
namespace {

struct Type {
  std::string_view name, other_name;
  std::size_t size;
};
// In the order of Scalar.
constexpr std::array<Type, 8> types{{{"char", "int8", 1},
                                     {"uchar", "uint8", 1},
                                     {"short", "int16", 2},
                                     {"ushort", "uint16", 2},
                                     {"int", "int32", 4},
                                     {"uint", "uint32", 4},
                                     {"float", "float32", 4},
                                     {"double", "float64", 8}}};

bool is_real(Scalar type) {
  return type == Scalar::f32 || type == Scalar::f64;
}

class HeaderReader {
 public:
  explicit HeaderReader(Scanner& scan) : scan_(scan) {}

  Header run() {
    if (scan_.token() != "ply") scan_.fail("\"ply\" is expected");
    require_line_end();
    while (true) {
      if (!scan_.next_line()) scan_.fail("the file ends within its header");
      const std::string_view word = scan_.token();
      if (word == "end_header") break;
      read_line(word);
    }
    if (!has_format_) scan_.fail("the header has no \"format\"");
    check_elements();
    require_line_end();
    if (!scan_.next_line()) scan_.fail("the file ends within its header");
    return std::move(header_);
  }

 private:
  void read_line(std::string_view word) {
    if (word.empty() || word == "comment" || word == "obj_info") return;
    if (word == "format")
      read_format();
    else if (word == "element")
      read_element();
    else if (word == "property")
      read_property();
    else
      return pass_over(word);
    require_line_end();
  }

  // Old programs write a line like "Created by …" and forget the word "comment". Further below an
  // unknown word is rather a keyword with a slip, and what follows would be misread.
  void pass_over(std::string_view word) {
    if (!header_.elements.empty()) scan_.fail("unknown word " + in_quotes(word) + " in the header");
    while (!scan_.token().empty()) continue;
  }

  void require_line_end() {
    if (const std::string_view more = scan_.token(); !more.empty())
      scan_.fail(in_quotes(more) + " is too much in this line of the header");
  }

  void read_format() {
    if (has_format_) scan_.fail("a second \"format\"");
    has_format_ = true;
    const std::string_view word = scan_.token();
    if (word == "binary_little_endian")
      header_.encoding = Encoding::little;
    else if (word == "binary_big_endian")
      header_.encoding = Encoding::big;
    else if (word != "ascii")
      scan_.fail("unknown format " + in_quotes(word));
    if (const std::string_view version = scan_.token(); version != "1.0")
      scan_.fail("version 1.0 is expected, not " + in_quotes(version));
  }

  // Every item takes at least a byte; no file can claim more memory than it is worth.
  void read_element() {
    Element element;
    element.name = scan_.token();
    const std::int64_t count = scan_.integer(scan_.token(), "the number of elements");
    if (count < 0 || static_cast<std::uint64_t>(count) > scan_.rest().size())
      scan_.fail("the number of elements does not fit the size of the file");
    element.count = static_cast<std::uint64_t>(count);
    header_.elements.push_back(std::move(element));
  }

  Scalar type(std::string_view word) const {
    const auto found = std::find_if(types.begin(), types.end(), [&](const Type& type) {
      return word == type.name || word == type.other_name;
    });
    if (found == types.end()) scan_.fail("unknown type " + in_quotes(word));
    return static_cast<Scalar>(found - types.begin());
  }

  void read_property() {
    if (header_.elements.empty()) scan_.fail("a property before the first element");
    Element& element = header_.elements.back();
    Property property;
    std::string_view word = scan_.token();
    if (word == "list") {
      property.list_size = type(scan_.token());
      if (is_real(*property.list_size)) scan_.fail("the length of a list must be an integer");
      word = scan_.token();
    }
    property.type = type(word);
    property.name = scan_.token();
    if (property.name.empty()) scan_.fail("a property without a name");
    property.role = role_of(property, element);
    if (property.role != Role::none && has(element, property.role))
      scan_.fail("a second property " + in_quotes(property.name));
    if (property.role == Role::corners && is_real(property.type))
      scan_.fail("vertex numbers must be integers");
    element.properties.push_back(std::move(property));
  }

  static Role role_of(const Property& property, const Element& element) {
    if (element.is_face() && property.list_size &&
        (property.name == "vertex_indices" || property.name == "vertex_index"))
      return Role::corners;
    if (!element.is_vertex() || property.list_size) return Role::none;
    if (property.name == "x") return Role::x;
    if (property.name == "y") return Role::y;
    return property.name == "z" ? Role::z : Role::none;
  }

  static bool has(const Element& element, Role role) {
    return std::any_of(element.properties.begin(), element.properties.end(),
                       [&](const Property& property) { return property.role == role; });
  }

  void check_elements() const {
    std::vector<std::string_view> seen;
    for (const Element& element : header_.elements) {
      if (std::find(seen.begin(), seen.end(), element.name) != seen.end())
        scan_.fail("a second element " + in_quotes(element.name));
      seen.push_back(element.name);
      if (element.count > 0) check_element(element, seen);
    }
  }

  void check_element(const Element& element, const std::vector<std::string_view>& seen) const {
    if (element.properties.empty())
      scan_.fail("element " + in_quotes(element.name) + " has no properties");
    if (element.name == "tristrips")
      scan_.fail("triangle strips are not read; write the mesh as faces");
    if (element.is_vertex())
      for (const auto& [role, name] : {std::pair{Role::x, "x"}, {Role::y, "y"}, {Role::z, "z"}})
        if (!has(element, role))
          scan_.fail(std::string("vertices have no property \"") + name + "\"");
    if (!element.is_face()) return;
    if (!has(element, Role::corners)) scan_.fail("faces have no list \"vertex_indices\"");
    if (std::find(seen.begin(), seen.end(), "vertex") == seen.end())
      scan_.fail("faces stand before vertices");
  }

  Scanner& scan_;
  bool has_format_ = false;
  Header header_;
};

}  // namespace

std::size_t size_of(Scalar type) {
  return types[static_cast<std::size_t>(type)].size;
}

Header read_header(Scanner& scan) {
  return HeaderReader(scan).run();
}

}  // namespace sectile::ply
