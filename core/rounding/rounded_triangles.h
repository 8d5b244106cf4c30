// A solid's triangles with rounded corners, block by block, of which parts are looked at and
// changed.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "parallel/parallel.h"
#include "rounding/rounded_surface.h"
#include "search/box_index.h"
#include "storage/block_triangles.h"
#include "storage/element_counts.h"

namespace sectile {

/// Some of the triangles as a surface of their own.
struct MeshPart {
  RoundedSurface rounded;
  std::vector<RoundedSurface::Corners> corners;  ///< as they were at first
  std::vector<std::uint32_t> triangle, vertex;   ///< their numbers in the mesh
  bool is_manifold = true;                       ///< no edge has more than two triangles
};

class RoundedTriangles {
 public:
  using Corners = RoundedSurface::Corners;
  using Triangles = std::vector<std::uint32_t>;
  struct Moved {
    std::uint32_t vertex;
    Vec3 from;       ///< its place, rounded to doubles
    bool was_exact;  ///< `from` is the place
  };

  /// Refers to the solid's data.
  RoundedTriangles(const SolidData& data, BlockTriangles triangles, const RoundingGrid& grid);

  std::size_t size() const { return triangles_.source.size(); }
  Corners corners(std::uint32_t t) const {
    const std::size_t i = 3 * std::size_t(t);
    return {triangles_.indices[i], triangles_.indices[i + 1], triangles_.indices[i + 2]};
  }
  const FaceSource& source(std::uint32_t t) const { return triangles_.source[t]; }
  /// Where a vertex is now, or the one to which it was joined.
  const Vec3& position(std::uint32_t vertex) const {
    if (!gone_to_.empty())
      while (gone_to_[vertex] != none) vertex = gone_to_[vertex];
    return positions_[vertex];
  }
  const std::vector<Vec3>& positions() const { return positions_; }
  const std::vector<std::uint32_t>& indices() const { return triangles_.indices; }
  bool one_shell() const { return shell_count(data_) == 1; }
  /// Vertices that are not at their places.
  const std::vector<Moved>& moved() const { return moved_; }
  /// No coordinate is farther than this from that of its place.
  double farthest_move() const;
  /// Those of faces with more than three corners.
  const Triangles& cut() const { return triangles_.cut; }
  std::size_t slot_count() const { return bounds_.size(); }
  /// Of a slot: the first one, and the end.
  std::pair<std::uint32_t, std::uint32_t> triangles(std::size_t slot) const {
    return {triangles_.first_triangle[slot], triangles_.first_triangle[slot + 1]};
  }
  const Box& bounds(std::size_t slot) const { return bounds_[slot]; }
  Box box(std::uint32_t t) const;

  /// Those with a corner of which `wanted` is true, which only is of corners in some boxes.
  template <class Wanted>
  Triangles with_any(const BoxIndex& boxes, const Wanted& wanted) const {
    return select([&](std::size_t s) { return boxes.any_overlaps(bounds_[s]); },
                  [&](std::uint32_t t) {
                    const Corners c = corners(t);
                    return wanted(c[0]) || wanted(c[1]) || wanted(c[2]);
                  });
  }
  /// Those with a corner that is not at its place, or changed since.
  Triangles unsettled() const;
  bool is_unsettled(std::uint32_t t) const;
  /// All whose boxes meet one of theirs.
  Triangles around(const Triangles& triangles) const;
  /// All that are no more than `rings` vertices away from theirs.
  Triangles neighbours(const Triangles& triangles, int rings) const;

  /// Where nothing was changed yet: see crowded_edges.h.
  bool has_crowded_edges(const Triangles& among) const;

  /// Triangles in ascending order. Only what concerns those in `suspects` is to be tested. Vertices
  /// with neighbours that are not in the part are fixed.
  MeshPart part(Triangles triangles, const Triangles& suspects) const;
  /// Takes over what was changed in a part; returns the triangles that are there and not as they
  /// were. `gone_to`: per vertex of the part, the one to which it was joined, or itself.
  Triangles take_back(const MeshPart& part, const std::vector<std::uint32_t>& gone_to);

  /// Before anything is changed: all others meet each other in common corners only, and did so all
  /// the way on which rounding moved them; so do all and those that were looked at.
  void note_unclear(const Triangles& unclear, const Triangles& not_looked_at);
  /// Has each shell a triangle that nothing has moved past, neither by rounding nor by changes?
  /// Then what lies on both its sides is what it was, as on all of a shell that no other crosses:
  /// no shell was turned inside out, or came to lie in another one.
  bool shells_stay() const;

  /// The mesh, of which nothing is left then.
  void move_into(RoundedMesh& result);

 private:
  static constexpr std::uint32_t none = 0xFFFFFFFFu;

  void round(const RoundingGrid& grid);
  void round(std::uint32_t slot, const Block& block, const RoundingGrid& grid,
             std::vector<Moved>& moved);
  void note_what_moved(const std::vector<std::vector<Moved>>& moved);
  Box swept_box(std::uint32_t t) const;
  std::vector<std::uint8_t> joined_vertices() const;
  void note_moved(std::uint32_t vertex, const Vec3& from, bool was_exact);
  void drop_what_is_gone();
  bool is_gone(std::uint32_t t) const { return !is_gone_.empty() && is_gone_[t] != 0; }
  bool is_changed(std::uint32_t t) const { return !is_changed_.empty() && is_changed_[t] != 0; }
  Vec3 place_of(std::uint32_t vertex) const {
    return moved_at_[vertex] == none ? positions_[vertex] : moved_[moved_at_[vertex]].from;
  }
  static Box with_places(Bounds bounds);
  std::vector<std::uint8_t> marks(const Triangles& triangles) const;
  std::vector<std::uint32_t> number_vertices(MeshPart& part) const;
  void add_vertices(MeshPart& part) const;
  template <class SlotWanted, class Wanted>
  Triangles select(const SlotWanted& slot_wanted, const Wanted& wanted) const;
  std::size_t slot_of(std::uint32_t t) const;

  const SolidData& data_;
  BlockTriangles triangles_;
  std::vector<Vec3> positions_;  // per vertex
  std::vector<Moved> moved_;
  std::vector<std::uint32_t> moved_at_;   // per vertex: index of the above, or none
  std::vector<std::uint8_t> is_changed_;  // per triangle; empty: none is
  std::vector<std::uint8_t> is_gone_;     // per triangle; empty: none is
  std::vector<std::uint32_t> gone_to_;    // per vertex: to which it was joined, or none; if any was
  std::vector<std::uint8_t> is_unclear_;  // per triangle; empty: none is
  std::vector<Box> swept_;                // of what triangles may have passed through
  std::vector<Box> bounds_;               // per slot
  std::vector<std::uint8_t> has_unsettled_;  // per slot: may it have some?
};

// Those that are wanted, in slots that are.
template <class SlotWanted, class Wanted>
RoundedTriangles::Triangles RoundedTriangles::select(const SlotWanted& slot_wanted,
                                                     const Wanted& wanted) const {
  std::vector<Triangles> found(bounds_.size());
  parallel::loop(0, bounds_.size(), [&](std::size_t s) {
    if (!slot_wanted(s)) return;
    const std::uint32_t end = triangles_.first_triangle[s + 1];
    for (std::uint32_t t = triangles_.first_triangle[s]; t < end; ++t)
      if (!is_gone(t) && wanted(t)) found[s].push_back(t);
  });
  Triangles all;
  for (const Triangles& some : found) all.insert(all.end(), some.begin(), some.end());
  return all;
}

}  // namespace sectile
