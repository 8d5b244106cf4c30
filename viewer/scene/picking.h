// What is under the pointer: rays against surfaces through box trees that are kept.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "picture/picture.h"
#include "scene/scene.h"

namespace sectile::viewer {

/// A surface that can be picked.
struct PickTarget {
  NodeId node = 0;
  std::shared_ptr<const SurfaceMesh> mesh;
  glm::dmat4 model{1};
};

struct Hit {
  NodeId node = 0;
  glm::dvec3 point{0}, normal{0, 0, 1};  ///< in the world; the normal points out of the solid
  double distance = 0;                   ///< along the ray
  std::uint32_t triangle = 0, face = 0;  ///< of the mesh; its entry in SurfaceMesh::faces
};

/// The vertex, edge or face nearest to the pointer.
struct PickedFeature {
  enum class Kind : std::uint8_t { vertex, edge, face };
  Kind kind = Kind::face;
  NodeId node = 0;
  glm::dvec3 point{
      0};  ///< the vertex, the place on the edge nearest to the pointer, or in the face
  glm::dvec3 ends[2]{};  ///< of the edge
  glm::dvec3 normal{0};  ///< of the face
};

class Picker {
 public:
  Picker();
  ~Picker();
  Picker(const Picker&) = delete;
  Picker& operator=(const Picker&) = delete;

  /// The first surface along the ray. Points that `section` cuts away are passed through.
  std::optional<Hit> pick(const Ray& ray, const std::vector<PickTarget>& targets,
                          const SectionPlane& section = {});
  /// The nearest corner of hard edges within `reach` pixels, else the nearest hard edge, else the
  /// face under the pointer. What a surface hides is not taken.
  std::optional<PickedFeature> pick_feature(const Camera& camera, glm::dvec2 pixel, glm::dvec2 size,
                                            double reach, const std::vector<PickTarget>& targets);

 private:
  struct Trees;
  const Trees& trees_of(const std::shared_ptr<const SurfaceMesh>& mesh);
  std::map<const SurfaceMesh*, std::unique_ptr<Trees>> trees_;
};

}  // namespace sectile::viewer
