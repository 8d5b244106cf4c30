// PLY: text, and binary of both byte orders; any scalar types; further elements and properties are
// passed over.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

#include "files/formats.h"
#include "files/ply_header.h"
#include "sectile/errors.h"

namespace sectile {
namespace {

using ply::Element;
using ply::Encoding;
using ply::Header;
using ply::Property;
using ply::Role;
using ply::Scalar;

// The items in text, each in a line of its own.
class TextItems {
 public:
  explicit TextItems(Scanner& scan) : scan_(scan) {}

  [[noreturn]] void fail(const std::string& what) const { scan_.fail(what); }
  std::size_t bytes_left() const { return scan_.rest().size(); }

  void begin_item() { first_ = scan_.token_on_any_line("another item"); }
  void end_item() {
    if (const std::string_view more = value(); !more.empty())
      fail(in_quotes(more) + " is more than the item has properties");
  }
  void end() { scan_.require_end("the last item"); }

  double real(Scalar) { return scan_.real(value(), "the coordinate"); }
  std::int64_t integer(Scalar) { return scan_.integer(value(), "the length or vertex number"); }
  void pass_over(Scalar) {
    if (value().empty()) fail("a value is missing");
  }

 private:
  std::string_view value() {
    return first_.empty() ? scan_.token() : std::exchange(first_, std::string_view());
  }

  Scanner& scan_;
  std::string_view first_;  // the item's first token until it is asked for
};

// The items as the bytes of numbers.
class BinaryItems {
 public:
  BinaryItems(std::string_view content, std::string_view rest, std::string_view name, bool swapped)
      : at_(rest.data()),
        start_(content.data()),
        end_(content.data() + content.size()),
        name_(name),
        swapped_(swapped) {}

  [[noreturn]] void fail(const std::string& what) const {
    throw FileError(name_ + ": byte " + std::to_string(at_ - start_) + ": " + what);
  }
  std::size_t bytes_left() const { return static_cast<std::size_t>(end_ - at_); }

  void begin_item() {}
  void end_item() {}
  void end() const {
    if (at_ != end_) fail(std::to_string(bytes_left()) + " bytes follow after the last item");
  }

  double real(Scalar type) {
    const double value = number<double>(type);
    if (!std::isfinite(value)) fail("the coordinate before is not finite");
    return value;
  }
  std::int64_t integer(Scalar type) { return number<std::int64_t>(type); }
  void pass_over(Scalar type) { number<double>(type); }

 private:
  template <class T>
  T take() {
    if (bytes_left() < sizeof(T)) fail("the file ends within an item");
    char bytes[sizeof(T)];
    std::memcpy(bytes, at_, sizeof(T));
    if (swapped_) std::reverse(bytes, bytes + sizeof(T));
    at_ += sizeof(T);
    return std::bit_cast<T>(bytes);
  }

  // Integers are never asked of real types.
  template <class Number>
  Number number(Scalar type) {
    switch (type) {
      case Scalar::i8:
        return take<std::int8_t>();
      case Scalar::u8:
        return take<std::uint8_t>();
      case Scalar::i16:
        return take<std::int16_t>();
      case Scalar::u16:
        return take<std::uint16_t>();
      case Scalar::i32:
        return take<std::int32_t>();
      case Scalar::u32:
        return take<std::uint32_t>();
      case Scalar::f32:
        return static_cast<Number>(take<float>());
      case Scalar::f64:
        break;
    }
    return static_cast<Number>(take<double>());
  }

  const char *at_, *start_, *end_;
  std::string name_;
  bool swapped_;
};

// From items to a mesh.
template <class Items>
class BodyReader {
 public:
  explicit BodyReader(Items items) : items_(std::move(items)) {}

  PolygonMesh run(const Header& header) {
    for (const Element& element : header.elements) {
      if (element.is_vertex()) mesh_.positions.reserve(element.count);
      if (element.is_face()) mesh_.face_sizes.reserve(element.count);
      for (std::uint64_t i = 0; i < element.count; ++i) {
        items_.begin_item();
        read_item(element);
        items_.end_item();
      }
    }
    items_.end();
    return std::move(mesh_);
  }

 private:
  void read_item(const Element& element) {
    Vec3 p;
    for (const Property& property : element.properties) {
      if (property.role == Role::x)
        p.x = items_.real(property.type);
      else if (property.role == Role::y)
        p.y = items_.real(property.type);
      else if (property.role == Role::z)
        p.z = items_.real(property.type);
      else if (property.role == Role::corners)
        read_face(property);
      else if (property.list_size)
        pass_over_list(property);
      else
        items_.pass_over(property.type);
    }
    if (element.is_vertex()) mesh_.positions.push_back(p);
  }

  std::uint64_t list_size(const Property& property) {
    const std::int64_t size = items_.integer(*property.list_size);
    if (size < 0 || static_cast<std::uint64_t>(size) > items_.bytes_left())
      items_.fail("a list of " + std::to_string(size) + " values does not fit the file");
    return static_cast<std::uint64_t>(size);
  }

  void pass_over_list(const Property& property) {
    for (std::uint64_t left = list_size(property); left > 0; --left)
      items_.pass_over(property.type);
  }

  void read_face(const Property& property) {
    const std::uint64_t size = list_size(property);
    if (size < 3) items_.fail("a face with " + std::to_string(size) + " corners");
    for (std::uint64_t i = 0; i < size; ++i) {
      const std::int64_t v = items_.integer(property.type);
      if (v < 0 || static_cast<std::uint64_t>(v) >= mesh_.positions.size())
        items_.fail("vertex " + std::to_string(v) + " does not exist; there are " +
                    std::to_string(mesh_.positions.size()) + ", counted from 0");
      mesh_.indices.push_back(static_cast<std::uint32_t>(v));
    }
    mesh_.face_sizes.push_back(static_cast<std::uint32_t>(size));
  }

  Items items_;
  PolygonMesh mesh_;
};

bool fits_uchar(const PolygonMesh& mesh) {
  return std::all_of(mesh.face_sizes.begin(), mesh.face_sizes.end(),
                     [](std::uint32_t size) { return size <= 255; });
}

bool fits_int(const PolygonMesh& mesh) {
  return mesh.positions.size() <= std::numeric_limits<std::int32_t>::max();
}

// The types that most programs read, wherever they are large enough.
void write_header(Sink& out, const PolygonMesh& mesh, const char* format) {
  out << "ply\nformat " << format << " 1.0\nelement vertex " << mesh.positions.size()
      << "\nproperty double x\nproperty double y\nproperty double z\nelement face "
      << mesh.face_sizes.size() << "\nproperty list " << (fits_uchar(mesh) ? "uchar" : "uint")
      << (fits_int(mesh) ? " int" : " uint") << " vertex_indices\nend_header\n";
}

}  // namespace

PolygonMesh read_ply(std::string_view content, std::string_view name) {
  Scanner scan(content, name, Scanner::no_comments);
  const Header header = ply::read_header(scan);
  if (header.encoding == Encoding::text) return BodyReader(TextItems(scan)).run(header);
  const bool swapped =
      (header.encoding == Encoding::big) != (std::endian::native == std::endian::big);
  return BodyReader(BinaryItems(content, scan.rest(), name, swapped)).run(header);
}

void write_ply_text(Sink& out, const PolygonMesh& mesh) {
  write_header(out, mesh, "ascii");
  for (const Vec3& p : mesh.positions) out << p << '\n';
  write_faces(out, mesh);
}

void write_ply_binary(Sink& out, const PolygonMesh& mesh) {
  static_assert(std::endian::native == std::endian::little);
  write_header(out, mesh, "binary_little_endian");
  for (const Vec3& p : mesh.positions) out.bytes(p.x).bytes(p.y).bytes(p.z);
  const bool small = fits_uchar(mesh);
  std::size_t at = 0;
  for (const std::uint32_t size : mesh.face_sizes) {
    small ? out.bytes(static_cast<std::uint8_t>(size)) : out.bytes(size);
    for (std::uint32_t i = 0; i < size; ++i) out.bytes(mesh.indices[at++]);
  }
}

}  // namespace sectile
