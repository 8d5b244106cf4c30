// The header of PLY files: what elements they hold, and how.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "files/scanner.h"

namespace sectile::ply {

enum class Encoding : std::uint8_t { text, little, big };
enum class Scalar : std::uint8_t { i8, u8, i16, u16, i32, u32, f32, f64 };
std::size_t size_of(Scalar type);

/// What a property means here.
enum class Role : std::uint8_t { none, x, y, z, corners };

struct Property {
  std::string name;
  Scalar type = Scalar::f32;
  std::optional<Scalar> list_size;
  Role role = Role::none;
};

struct Element {
  std::string name;
  std::uint64_t count = 0;
  std::vector<Property> properties;

  bool is_vertex() const { return name == "vertex"; }
  bool is_face() const { return name == "face"; }
};

struct Header {
  Encoding encoding = Encoding::text;
  std::vector<Element> elements;
};

/// Leaves the scanner at the first byte after the header. Throws FileError if the header makes no
/// sense, or if meshes with these elements could not be read whole.
Header read_header(Scanner& scan);

}  // namespace sectile::ply
