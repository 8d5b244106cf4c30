// Any mesh in: from polygons that cross, overlap or leave holes to the solid that their winding
// numbers say.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "sectile/errors.h"
#include "sectile/mesh.h"
#include "sectile/solid.h"

namespace sectile {

struct RepairOptions {
  Rule rule = Rule::positive;
  /// Close holes with triangles between their corners. Otherwise a mesh with holes is refused.
  bool close_holes = false;
  /// Vertices on the borders of holes that are at most this far from each other become one, in the
  /// unit of the mesh; 0: only where they coincide.
  double stitch = 0;
  const std::atomic<bool>* cancel = nullptr;  ///< set from outside to stop with Cancelled
  std::function<void(double)> progress;       ///< called now and then with 0 … 1
};

/// One kind of thing that was done, how often, and where for the first time.
struct RepairChange {
  enum class Kind {
    united_vertices,    ///< vertices at the place of another one
    removed_flat,       ///< faces without area
    removed_copies,     ///< faces that another one repeats, where that leaves the surface open
    split_polygons,     ///< polygons that are not plane or cross themselves, into triangles
    divided_edges,      ///< edges with corners of other faces on them
    stitched_vertices,  ///< vertices moved onto others on the borders of holes
    turned_faces,       ///< faces turned around so that neighbours agree
    turned_parts,       ///< whole surfaces that were inside out
    closed_holes,       ///< holes closed
    divided_faces,      ///< faces divided where others meet or cross them
    overlaps,           ///< places where several faces lie on each other
    removed_faces  ///< faces that bound no material; of flat parts that are one face, all or none
  };
  Kind kind;
  std::size_t count = 0;
  Vec3 where;                       ///< a corner of the first one
  std::uint32_t face = no_element;  ///< the first one, if it is a face of the mesh
};
/// "3 faces without area removed, the first at (0, 0, 1)".
std::string in_words(const RepairChange& change);
/// One word for programs: "united_vertices".
std::string name_of(RepairChange::Kind kind);

/// A hole of the surface: a closed path of edges without a face on their other side.
struct Hole {
  std::size_t edges = 0;
  double length = 0;                ///< of the whole path
  Vec3 where;                       ///< its first corner
  std::uint32_t face = no_element;  ///< a face beside it
};

struct RepairReport {
  std::vector<RepairChange> changes;  ///< empty: the mesh was taken as it is
  std::vector<Hole> holes;            ///< closed, or the reason for a refusal
};

/// The solid that the faces of a mesh bound, by the rule: exactly, from the arrangement of all
/// faces with each other. Borders that coincide are one; where neighbours contradict each other,
/// faces are turned around so that they agree, if the surface allows it. Nothing is changed that
/// the report does not list. FaceSource::face of triangles that close hole k is the number of the
/// mesh's faces plus k. Throws InvalidSolid for sizes and indices that do not fit, coordinates that
/// are not finite, holes that are not to be closed, and, unless the rule is `odd`, surfaces that
/// cannot be oriented. The report, if any, is filled as far as the work went.
Solid repair(const PolygonMesh& mesh, const RepairOptions& options = {},
             RepairReport* report = nullptr);

}  // namespace sectile
