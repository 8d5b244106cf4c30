// Solids by what they are made from. Equal subtrees of a scene, now or in an earlier evaluation,
// are one value.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <unordered_map>

#include "picture/picture.h"
#include "scene/scene.h"

namespace sectile::viewer {

/// A solid with what was made from it.
struct Value {
  std::uint64_t id = 0;  ///< never used twice
  Solid solid;
  std::string error;
  std::size_t faces = 0;                       ///< about how many, for the memory that it takes
  std::shared_ptr<const SurfaceMesh> surface;  ///< made when first needed
  std::shared_ptr<const PolygonMesh> source;   ///< kept, as its address is a part of the key
  std::uint64_t last_used = 0;
};

using ValuePointer = std::shared_ptr<Value>;

/// The bytes that say what a solid is made from; equal keys mean equal solids.
class ValueKey {
 public:
  explicit ValueKey(char kind) : bytes_(1, kind) {}
  template <class Plain>
  ValueKey& add(const Plain& plain) {
    static_assert(std::has_unique_object_representations_v<Plain> ||
                  std::is_floating_point_v<Plain>);
    bytes_.append(reinterpret_cast<const char*>(&plain), sizeof plain);
    return *this;
  }
  ValueKey& add(const Vec3& v) { return add(v.x).add(v.y).add(v.z); }
  ValueKey& add(const Transform& transform);
  ValueKey& add(const Primitive& primitive);
  const std::string& bytes() const { return bytes_; }

 private:
  ValueKey& add(const std::vector<Vec2>& points);
  std::string bytes_;
};

class ValueTable {
 public:
  /// Starts an evaluation: values found or made from now on count as used.
  void begin() { ++now_; }
  ValuePointer find(const ValueKey& key);  ///< null if there is none
  ValuePointer add(const ValueKey& key, Value value);
  /// Made in the current evaluation?
  bool is_new(const Value& value) const { return value.id >= first_new_; }
  void mark_all_old() { first_new_ = next_id_; }
  /// Forgets the values that have not been used for longest, until the unused ones have fewer
  /// faces than this.
  void forget_unused(std::size_t faces);
  std::size_t size() const { return values_.size(); }

 private:
  std::unordered_map<std::string, ValuePointer> values_;
  std::uint64_t now_ = 0, next_id_ = 1, first_new_ = 1;
};

}  // namespace sectile::viewer
