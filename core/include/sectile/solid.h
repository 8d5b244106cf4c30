// The solid: a value that holds a regular polyhedral point set exactly.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "sectile/mesh.h"

namespace sectile {

class SolidData;  // topology, geometry and search tree; internal
class MovedSolid;
struct RepairReport;

/// Where a face comes from: `solid` is the number given to a mesh when it was imported (see
/// Solid::origin), `face` the face of that mesh; where coplanar neighbours were joined to one face,
/// the first of them (see Solid::joined_faces). Kept through any cascade of operations.
struct FaceSource {
  std::uint32_t solid = 0;
  std::uint32_t face = 0;
  friend bool operator==(const FaceSource&, const FaceSource&) = default;
  friend auto operator<=>(const FaceSource&, const FaceSource&) = default;
};

/// Numbers of the boundary representation; `genus` is summed over all shells.
struct SolidCounts {
  std::size_t vertices = 0, edges = 0, faces = 0, loops = 0, shells = 0;
  std::int64_t genus = 0;
};

/// Which points are material, by the winding number w of the surface around them.
enum class Rule {
  positive,  ///< w >= 1: parts that overlap are united; parts whose outside is inside out are
             ///< turned
  nonzero,   ///< w != 0
  odd        ///< w is odd; needs no orientation
};

/// How a mesh is imported.
struct ImportOptions {
  /// The caller promises that no faces cross or overlap, which is then not looked at. If the
  /// promise is broken, later results are wrong, or InternalError is thrown.
  bool trusted = false;
  /// Coplanar neighbours are joined to one face unless their numbers here differ: one number per
  /// face of the mesh (a material, a colour). Empty: all are alike. With a number of its own each
  /// face stays as it is, and FaceSource::face always names just one.
  std::span<const std::uint32_t> face_groups;
  /// Faces may cross and overlap as they like: the solid is what they bound by this rule, exactly,
  /// as repair() says it (sectile/repair.h). Meshes with holes are refused all the same. What was
  /// done is told in `report`, if there is one. `trusted` and `face_groups` say nothing then.
  std::optional<Rule> resolve = {};
  RepairReport* report = nullptr;
  const std::atomic<bool>* cancel = nullptr;  ///< Cancelled is thrown soon after it is set
  std::function<void(double)> progress;       ///< is told the part done, by one thread at a time
};

/// A regular, closed, bounded set of points with polygonal faces; may be empty.
///
/// A value: cheap to copy and to move, immutable from outside, safe to read from many threads.
class Solid {
 public:
  Solid();  ///< the empty solid
  ~Solid();
  Solid(const Solid&);
  Solid(Solid&&) noexcept;
  Solid& operator=(const Solid&);
  Solid& operator=(Solid&&) noexcept;

  /// Takes a closed, consistently oriented polygon soup that bounds a regular set: shared or
  /// duplicated vertices, non-manifold edges and vertices (resolved into wedges of material),
  /// zero-area faces (removed), non-planar polygons (triangulated), corners of one face within an
  /// edge of its neighbour (the edge is divided). Equal positions are one point. Exactly coplanar
  /// neighbours become one face, so that operations take what the faces take and not what their
  /// triangles do.
  /// Throws InvalidSolid, also for faces that cross or overlap anywhere and for shells in the
  /// material of others.
  static Solid from_mesh(const PolygonMesh& mesh);
  /// May also throw Cancelled.
  static Solid from_mesh(const PolygonMesh& mesh, const ImportOptions& options);

  /// Triangles. Coordinates that are no doubles are rounded to the nearest. An imported solid, also
  /// a moved one, has the triangles of its mesh.
  PolygonMesh to_mesh() const;

  /// Triangles together with the source of each (in the order of the triangles).
  PolygonMesh to_mesh(std::vector<FaceSource>& sources) const;

  /// Of an imported solid: the faces of its mesh that were joined to the one which FaceSource::face
  /// names, in ascending order; just this one if none was.
  std::vector<std::uint32_t> joined_faces(std::uint32_t face) const;

  bool is_empty() const;
  /// Of the exact solid, right to two units in the last place; infinite where doubles end.
  double volume() const;
  double area() const;
  SolidCounts counts() const;

  /// The number that FaceSource::solid has in faces imported by from_mesh (0 for the empty solid
  /// and for results).
  std::uint32_t origin() const;

  /// The same point set.
  friend bool operator==(const Solid&, const Solid&);

  explicit Solid(std::shared_ptr<const SolidData> data);    // internal
  explicit Solid(std::shared_ptr<const MovedSolid> moved);  // internal
  const std::shared_ptr<const SolidData>& data() const;     // internal
  const MovedSolid* moved() const { return moved_.get(); }  // internal

 private:
  std::shared_ptr<const SolidData> data_;  // of a moved solid: the original
  std::shared_ptr<const MovedSolid> moved_;
};

}  // namespace sectile
