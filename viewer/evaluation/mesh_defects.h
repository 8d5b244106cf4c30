// What is wrong with a mesh that bounds no solid: line by line, each with its place.
#pragma once

#include <atomic>
#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "picture/picture.h"
#include "sectile/sectile.h"

namespace sectile::viewer {

struct MeshDefect {
  enum class Kind : std::uint8_t {
    contact,      ///< faces that cross or lie on each other
    hole,         ///< a border: edges without a face on their other side
    orientation,  ///< faces that contradict their neighbours, parts that are inside out
    degenerate,   ///< faces without area, copies of faces
    other         ///< what the refusal says, where it says nothing more exact
  };
  Kind kind = Kind::other;
  std::string text;                  ///< a sentence without its full stop
  std::optional<glm::dvec3> place;   ///< none: everywhere
  std::vector<std::uint32_t> faces;  ///< of the mesh
  std::vector<glm::vec3> edges;      ///< two ends for each
  Bounds bounds;                     ///< of all that
};

/// "Crossings and overlaps", …
const char* heading_of(MeshDefect::Kind kind);

struct MeshDefects {
  std::vector<MeshDefect> list;  ///< by kind, in the order of the enumeration
  /// The faces that no line names, and those that a contact names. Null where indices and
  /// coordinates make no mesh that could be drawn.
  std::shared_ptr<const SurfaceMesh> sound, touching;
  std::vector<glm::vec3> borders, contradictions;  ///< edges, two ends for each
  Bounds bounds;
};

/// Of a mesh that Solid::from_mesh refuses. Throws Cancelled.
MeshDefects find_defects(const PolygonMesh& mesh, const InvalidSolid& refusal,
                         const std::atomic<bool>* cancel);

}  // namespace sectile::viewer
