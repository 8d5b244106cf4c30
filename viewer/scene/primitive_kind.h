// What there is to know of each kind of primitive. A kind is a file in scene/primitives and a line
// in its table; files, menus, fields and the evaluation go by what stands here.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <variant>

#include "scene/scene.h"
#include "sectile/sectile.h"

namespace sectile::viewer {

/// A number of a primitive that can be changed.
struct PrimitiveField {
  const char* title;  ///< "Top radius"
  const char* name;   ///< of the widget: "top_radius"
  /// Edge lengths, a length, or a count.
  std::variant<Vec3 Primitive::*, double Primitive::*, std::uint32_t Primitive::*> value;
  double low = 1e-6, high = 1e6;  ///< of a length or a count
};

enum class ProfileUse : std::uint8_t { none, extruded, turned };

struct PrimitiveKind {
  std::string_view name;  ///< in files, in commands ("add.block") and in sentences
  std::span<const PrimitiveField> fields;
  /// The solid, centred at the origin unless a profile says where it is. Throws
  /// std::invalid_argument, which says what is wrong with a parameter.
  Solid (*solid)(const Primitive&);
  ProfileUse profile = ProfileUse::none;
  void (*begin)(Primitive&) = nullptr;  ///< what a new one has instead of the usual numbers
};

/// In the order of menus.
std::span<const PrimitiveKind* const> primitive_kinds();
/// Throws std::out_of_range for a name that no kind has.
const PrimitiveKind& primitive_kind(std::string_view name);
/// A new one, as it is added to a scene.
Primitive first_primitive(const PrimitiveKind& kind);
/// The solid of a primitive of any kind; throws as its kind does.
Solid solid_of(const Primitive& primitive);

}  // namespace sectile::viewer
