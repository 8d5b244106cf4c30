// Cuts a boundary, or a part of one, into blocks of neighbouring faces.
#pragma once

#include <span>
#include <vector>

#include "storage/solid_data.h"

namespace sectile {

#ifdef SECTILE_SMALL_BLOCKS  // for tests: even a cube is in several blocks
inline constexpr std::size_t most_faces_of_a_block = 4, faces_of_a_block = 3, few_faces = 2;
inline constexpr std::size_t corners_of_a_large_face = 6;
#else
/// A boundary of up to so many faces stays in one block; a larger one is cut into blocks of so
/// many; blocks of few small faces are made anew with others that are, lest blocks become many.
inline constexpr std::size_t most_faces_of_a_block = 256, faces_of_a_block = 192, few_faces = 32;
/// Where a boundary is cut, a face of so many corners is alone in its block.
inline constexpr std::size_t corners_of_a_large_face = 512;
#endif

/// A border edge of the block in a slot, and the piece of the block to which it belongs.
struct BorderEdge {
  std::uint32_t slot = 0, border = 0, piece = 0;
};

/// The slots that new blocks take: those that are free, then new ones behind the last.
struct Places {
  std::span<const std::uint32_t> free = {};
  std::uint32_t end = 0;
  std::uint32_t operator()(std::size_t block) const {
    return block < free.size() ? free[block]
                               : end + static_cast<std::uint32_t>(block - free.size());
  }
};

/// The real faces of a structure. Its edges 0 … outside.size() - 1 leave it, from their even
/// half-edges to the border edges named.
struct PartToCut {
  const Brep& brep;
  const Geometry& geometry;
  std::span<const BorderEdge> outside;
  Places places;
  /// Per face: blocks have faces of one shell only, and those of shell 0 come first, then those of
  /// shell 1 … Empty: blocks may have faces of any.
  std::span<const std::uint32_t> shell = {};
  /// Faces that are alone in their blocks, however few corners they have.
  std::span<const FaceId> alone = {};
};

struct CutPart {
  std::vector<Slot> slots;           ///< the i-th for places(i)
  std::vector<BorderEdge> outside;   ///< per edge that leaves the part: where it is now
  std::vector<std::uint32_t> alone;  ///< per face that was to be alone: the number of its slot
};

CutPart cut_into_blocks(const PartToCut& part);

}  // namespace sectile
