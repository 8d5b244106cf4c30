// Where faces lie in holes and bends of others, as rings in rings do, all their boxes overlap. So
// those that leave much of their boxes empty are searched as triangles that cover them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "geometry/kernel.h"
#include "search/hull.h"
#include "search/oriented_tree.h"

namespace sectile {

/// Does a face leave at least half of its box empty, as it is seen along an axis? Asked as far as
/// doubles tell. Loop k has the corners loop_ends[k - 1] to loop_ends[k] - 1.
bool is_hollow(std::span<const Vec3> corners, std::span<const std::uint32_t> loop_ends);

/// Faces, each as a whole or in several pieces.
class FacePieces {
 public:
  std::size_t count() const { return face_.size(); }
  std::uint32_t face(std::size_t piece) const { return face_[piece]; }
  /// A polygon, around which the piece of the face is.
  std::span<const Vec3> corners(std::size_t piece) const {
    const std::size_t from = piece == 0 ? 0 : end_[piece - 1];
    return std::span(corners_).subspan(from, end_[piece] - from);
  }

  /// The corners of a plane polygon, known up to half an ulp in each coordinate.
  void add(std::uint32_t face, std::span<const Vec3> corners);
  /// Triangles that cover a face exactly. Throws InternalError if its loops bound no region, and
  /// nothing is added.
  void add_triangles(std::uint32_t face, const Kernel& kernel, PlaneId plane,
                     std::span<const PointId> corners, std::span<const std::uint32_t> loop_ends);
  void append(const FacePieces& others);

 private:
  std::vector<std::uint32_t> face_, end_;  // per piece
  std::vector<Vec3> corners_;
};

/// Pairs of faces that may meet, by their pieces.
class PieceSearch {
 public:
  static constexpr std::uint32_t no_label = BoxTree::no_group;

  /// Two of one label (per face) are no pair. No labels: all that are near each other are.
  PieceSearch(const FacePieces& pieces, std::span<const std::uint32_t> label);

  std::size_t pieces() const { return face_.size(); }
  /// What can be visited side by side: so many parts, if there are as many nodes.
  std::vector<BoxTree::SelfPart> parts(std::size_t least) const { return tree_.self_parts(least); }
  /// Calls visit(face, other face) for all pairs of which pieces in a part meet, and for few
  /// others; some are visited several times. Returns how often two nodes were looked at: where
  /// that is more than `most`, not all was visited.
  template <class Visit>
  std::size_t for_each_pair(const BoxTree::SelfPart& part, std::size_t most,
                            const Visit& visit) const {
    std::size_t looks = 0;
    tree_.self_overlaps(
        part,
        [&](std::uint32_t i, std::uint32_t j) {
          const std::uint32_t f = face_[i], g = face_[j];
          if (f != g && !apart(hulls_[i], hulls_[j])) visit(f, g);
        },
        Apart(tree_, oriented_ ? &*oriented_ : nullptr, most, looks));
    return looks;
  }

 private:
  // Of what comes when too much was looked at, everything is.
  class Apart : public OrientedApart {
   public:
    Apart(const BoxTree& tree, const OrientedTree* oriented, std::size_t most, std::size_t& looks)
        : OrientedApart(tree, oriented, tree, oriented), most_(most), looks_(looks) {}
    bool nodes(BoxTree::Node p, BoxTree::Node q) const {
      return ++looks_ > most_ || OrientedApart::nodes(p, q);
    }

   private:
    std::size_t most_;
    std::size_t& looks_;
  };

  std::vector<std::uint32_t> face_;  // per piece
  std::vector<Hull> hulls_;
  BoxTree tree_;
  std::optional<OrientedTree> oriented_;
};

}  // namespace sectile
