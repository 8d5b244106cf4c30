#include <stdexcept>
#include <string>

#include "scene/primitive_kind.h"

namespace sectile::viewer {

extern const PrimitiveKind block_kind, wedge_kind, prism_kind, pyramid_kind, cylinder_kind,
    cone_kind, sphere_kind, torus_kind, extrusion_kind, revolution_kind;

namespace {

constexpr const PrimitiveKind* table[] = {
    &block_kind, &wedge_kind,  &prism_kind, &pyramid_kind,   &cylinder_kind,
    &cone_kind,  &sphere_kind, &torus_kind, &extrusion_kind, &revolution_kind,
};

}  // namespace

std::span<const PrimitiveKind* const> primitive_kinds() {
  return table;
}

const PrimitiveKind& primitive_kind(std::string_view name) {
  for (const PrimitiveKind* kind : table)
    if (kind->name == name) return *kind;
  throw std::out_of_range("There is no primitive \"" + std::string(name) + "\".");
}

Primitive first_primitive(const PrimitiveKind& kind) {
  Primitive made;
  made.kind = &kind;
  if (kind.begin) kind.begin(made);
  return made;
}

Solid solid_of(const Primitive& primitive) {
  return primitive.kind->solid(primitive);
}

}  // namespace sectile::viewer
