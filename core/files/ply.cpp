// PLY: text, and binary of both byte orders; any scalar types; further elements and properties are
// passed over.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <optional>

#include "files/formats.h"
#include "files/scanner.h"

namespace sectile {
namespace {

enum class Scalar : std::uint8_t { i8, u8, i16, u16, i32, u32, f32, f64 };

std::optional<Scalar> scalar_named(std::string_view name) {
  constexpr std::array<std::pair<std::string_view, Scalar>, 16> names{{{"char", Scalar::i8},
                                                                       {"int8", Scalar::i8},
                                                                       {"uchar", Scalar::u8},
                                                                       {"uint8", Scalar::u8},
                                                                       {"short", Scalar::i16},
                                                                       {"int16", Scalar::i16},
                                                                       {"ushort", Scalar::u16},
                                                                       {"uint16", Scalar::u16},
                                                                       {"int", Scalar::i32},
                                                                       {"int32", Scalar::i32},
                                                                       {"uint", Scalar::u32},
                                                                       {"uint32", Scalar::u32},
                                                                       {"float", Scalar::f32},
                                                                       {"float32", Scalar::f32},
                                                                       {"double", Scalar::f64},
                                                                       {"float64", Scalar::f64}}};
  for (const auto& [known, scalar] : names)
    if (known == name) return scalar;
  return {};
}

struct Property {
  std::string name;
  Scalar type = Scalar::f32;
  std::optional<Scalar> list_size;
};
struct Element {
  std::string name;
  std::int64_t count = 0;
  std::vector<Property> properties;
};
enum class Encoding : std::uint8_t { text, little, big };

class PlyReader {
 public:
  PlyReader(std::string_view content, std::string_view name)
      : content_(content), name_(name), scan_(content, name) {}

  PolygonMesh run() {
    read_header();
    for (const Element& element : elements_)
      for (std::int64_t i = 0; i < element.count; ++i) read_item(element);
    return std::move(mesh_);
  }

 private:
  void read_header() {
    if (scan_.token('\0') != "ply") scan_.fail("\"ply\" is expected");
    bool known = false;
    while (scan_.next_line()) {
      const std::string_view word = scan_.token('\0');
      if (word == "format") {
        known = true;
        read_format(scan_.token('\0'));
      } else if (word == "element") {
        Element& e = elements_.emplace_back();
        e.name = scan_.token('\0');
        e.count = scan_.integer(scan_.token('\0'), "the number of elements");
        if (e.count < 0 || static_cast<std::uint64_t>(e.count) > content_.size())
          scan_.fail("the number of elements does not fit the size of the file");
      } else if (word == "property") {
        read_property();
      } else if (word == "end_header") {
        if (!known) scan_.fail("the header has no \"format\"");
        const std::size_t header = content_.find("end_header");
        at_ = content_.find('\n', header);
        if (at_ == std::string_view::npos) scan_.fail("the file ends after its header");
        ++at_;
        scan_.next_line();
        check_elements();
        return;
      } else if (!word.empty() && word != "comment" && word != "obj_info") {
        scan_.fail("unknown word \"" + std::string(word) + "\" in the header");
      }
    }
    scan_.fail("the file ends within its header");
  }

  void read_format(std::string_view word) {
    if (word == "ascii")
      encoding_ = Encoding::text;
    else if (word == "binary_little_endian")
      encoding_ = Encoding::little;
    else if (word == "binary_big_endian")
      encoding_ = Encoding::big;
    else
      scan_.fail("unknown format \"" + std::string(word) + "\"");
  }

  Scalar type(std::string_view word) const {
    const auto scalar = scalar_named(word);
    if (!scalar) scan_.fail("unknown type \"" + std::string(word) + "\"");
    return *scalar;
  }

  void read_property() {
    if (elements_.empty()) scan_.fail("a property before the first element");
    Property p;
    std::string_view word = scan_.token('\0');
    if (word == "list") {
      p.list_size = type(scan_.token('\0'));
      word = scan_.token('\0');
    }
    p.type = type(word);
    p.name = scan_.token('\0');
    if (p.name.empty()) scan_.fail("a property without a name");
    elements_.back().properties.push_back(p);
  }

  void check_elements() const {
    bool vertices = false;
    for (const Element& e : elements_) {
      if (e.properties.empty() && e.count > 0)
        scan_.fail("element \"" + e.name + "\" has no properties");
      if (e.name == "vertex") {
        vertices = true;
        for (const char* c : {"x", "y", "z"})
          if (std::none_of(e.properties.begin(), e.properties.end(),
                           [&](const Property& p) { return p.name == c && !p.list_size; }))
            scan_.fail(std::string("vertices have no property \"") + c + "\"");
      }
      if (e.name == "face" && !vertices) scan_.fail("faces stand before vertices");
    }
  }

  [[noreturn]] void fail(const std::string& what) const {
    if (encoding_ == Encoding::text) scan_.fail(what);
    throw FileError(name_ + ": byte " + std::to_string(at_) + ": " + what);
  }

  template <class T>
  double binary() {
    if (content_.size() - at_ < sizeof(T)) fail("the file ends too early");
    char bytes[sizeof(T)];
    std::memcpy(bytes, content_.data() + at_, sizeof(T));
    if ((encoding_ == Encoding::big) != (std::endian::native == std::endian::big))
      std::reverse(bytes, bytes + sizeof(T));
    at_ += sizeof(T);
    T value;
    std::memcpy(&value, bytes, sizeof(T));
    return static_cast<double>(value);
  }

  double value(Scalar type) {
    if (encoding_ == Encoding::text) return scan_.real(scan_.any_token("a value"), "the value");
    switch (type) {
      case Scalar::i8:
        return binary<std::int8_t>();
      case Scalar::u8:
        return binary<std::uint8_t>();
      case Scalar::i16:
        return binary<std::int16_t>();
      case Scalar::u16:
        return binary<std::uint16_t>();
      case Scalar::i32:
        return binary<std::int32_t>();
      case Scalar::u32:
        return binary<std::uint32_t>();
      case Scalar::f32:
        return binary<float>();
      case Scalar::f64:
        break;
    }
    return binary<double>();
  }

  std::uint64_t whole(Scalar type, const char* what) {
    const double v = value(type);
    if (!(v >= 0 && v < 4294967296.0) || v != std::floor(v))
      fail(std::string(what) + " is not a whole number in range");
    return static_cast<std::uint64_t>(v);
  }

  void read_item(const Element& e) {
    const bool vertex = e.name == "vertex", face = e.name == "face";
    Vec3 p;
    for (const Property& property : e.properties) {
      if (property.list_size) {
        const bool corners =
            face && (property.name == "vertex_indices" || property.name == "vertex_index");
        read_list(property, corners);
        continue;
      }
      const double v = value(property.type);
      if (!vertex) continue;
      double* c = property.name == "x"   ? &p.x
                  : property.name == "y" ? &p.y
                  : property.name == "z" ? &p.z
                                         : nullptr;
      if (!c) continue;
      if (!std::isfinite(v)) fail("a coordinate is not finite");
      *c = v;
    }
    if (vertex) mesh_.positions.push_back(p);
  }

  void read_list(const Property& property, bool corners) {
    const std::uint64_t size = whole(*property.list_size, "the length of a list");
    if (size > content_.size()) fail("a list longer than the file");
    for (std::uint64_t i = 0; i < size; ++i) {
      if (!corners) {
        value(property.type);
        continue;
      }
      const std::uint64_t v = whole(property.type, "the vertex number");
      if (v >= mesh_.positions.size())
        fail("vertex " + std::to_string(v) + " does not exist; there are " +
             std::to_string(mesh_.positions.size()));
      mesh_.indices.push_back(static_cast<std::uint32_t>(v));
    }
    if (!corners) return;
    if (size < 3) fail("a face with " + std::to_string(size) + " corners");
    mesh_.face_sizes.push_back(static_cast<std::uint32_t>(size));
  }

  std::string_view content_;
  std::string name_;
  Scanner scan_;
  Encoding encoding_ = Encoding::text;
  std::size_t at_ = 0;
  std::vector<Element> elements_;
  PolygonMesh mesh_;
};

void write_header(std::ostream& out, const PolygonMesh& mesh, const char* format) {
  out << "ply\nformat " << format << " 1.0\nelement vertex " << mesh.positions.size()
      << "\nproperty double x\nproperty double y\nproperty double z\nelement face "
      << mesh.face_sizes.size() << "\nproperty list uint uint vertex_indices\nend_header\n";
}

}  // namespace

PolygonMesh read_ply(std::string_view content, std::string_view name) {
  return PlyReader(content, name).run();
}

void write_ply_text(std::ostream& out, const PolygonMesh& mesh) {
  write_header(out, mesh, "ascii");
  for (const Vec3& p : mesh.positions)
    out << shortest(p.x) << ' ' << shortest(p.y) << ' ' << shortest(p.z) << '\n';
  std::size_t at = 0;
  for (const std::uint32_t size : mesh.face_sizes) {
    out << size;
    for (std::uint32_t i = 0; i < size; ++i) out << ' ' << mesh.indices[at++];
    out << '\n';
  }
}

void write_ply_binary(std::ostream& out, const PolygonMesh& mesh) {
  static_assert(std::endian::native == std::endian::little);
  write_header(out, mesh, "binary_little_endian");
  const auto put = [&](const auto& value) {
    out.write(reinterpret_cast<const char*>(&value), sizeof value);
  };
  for (const Vec3& p : mesh.positions) {
    put(p.x);
    put(p.y);
    put(p.z);
  }
  std::size_t at = 0;
  for (const std::uint32_t size : mesh.face_sizes) {
    put(size);
    for (std::uint32_t i = 0; i < size; ++i) put(mesh.indices[at++]);
  }
}

}  // namespace sectile
