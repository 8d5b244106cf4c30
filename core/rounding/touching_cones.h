// Where wedges of material touch: cones that they fill, which have no inside in common.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "geometry/kernel.h"
#include "rounding/edge_sectors.h"
#include "rounding/rounded_surface.h"

namespace sectile {

/// A site is a place, or an edge, at which several fans of triangles touch. What a fan bounds at a
/// place is its cone, which need not be convex; from the points on the inner sides of all its
/// planes all of it is seen. The fan's triangles are members of the cone, and so are those that
/// hang on it and lie on these inner sides. Around an edge, cones are the sectors of wedges and of
/// gaps (EdgeSectors). Members of two cones of one site that are apart never meet as they must not,
/// as long as each of their corners is where it was in the beginning, or strictly on the inner
/// sides: so they need not be tested against each other.
///
/// The cones of a place are all of material, or all of the outside. Each is within half of space,
/// none is in another one, and all are apart.
class TouchingCones {
 public:
  struct Member {
    std::uint32_t site, cone;
    friend bool operator==(const Member&, const Member&) = default;
  };
  static constexpr std::uint32_t none = 0xFFFFFFFFu;

  TouchingCones(RoundedSurface& rounded, Kernel& kernel) : rounded_(rounded), kernel_(kernel) {}

  /// A corner of a triangle, or the edge that begins there.
  struct Corner {
    std::uint32_t triangle, k;
  };
  /// Corners of the fans that touch at a place. The surface must be legal.
  void add_place(std::span<const Corner> corners);
  /// Edges of wedges that touch along an edge. Returns their cones; one that has none has no site.
  /// The surface must be legal.
  std::vector<Member> add_edge(std::span<const Corner> wedges);
  /// Looks for what hangs on the fans, after all sites were added.
  void find_members();
  /// A new vertex divides the edge of a wedge, and `added` was cut off from a triangle there.
  void put_on_edge(std::uint32_t vertex, Member wedge) { cone_at_[vertex] = wedge; }
  void divide(std::uint32_t triangle, std::uint32_t added);

  bool empty() const { return sites_.empty(); }
  /// How many cones touch the one of which a vertex is the tip, or on whose edge it is.
  std::size_t cones_beside(std::uint32_t vertex) const;

  /// Does a vertex that goes some way from the tip of its cone, or from its edge, seem to come into
  /// the cone? Doubles are asked.
  bool seems_inside(std::uint32_t vertex, Vec3 way) const;
  /// Across the planes of its cone, towards the inside, of length 1, as doubles say.
  std::vector<Vec3> inward(std::uint32_t vertex) const;

  /// A vertex, around which there are these triangles, is at another place.
  void note_move(std::uint32_t vertex, std::span<const std::uint32_t> star);
  /// Is it strictly inside of the cone of which it was the tip, or on whose edge it was?
  bool has_moved_inside() const { return has_moved_inside_; }
  /// One of the two is to follow.
  void keep_move();
  void undo_move() { moving_.clear(); }

  /// The cones that a triangle lies in, also while a vertex of it moves.
  std::span<const Member> cones_around(std::uint32_t triangle) const;
  /// Is a triangle in another cone of one of the sites of some cones?
  bool are_apart(std::span<const Member> cones, std::uint32_t triangle) const;
  /// One of its sites, the same until it is not in its cone there any more; then, or if it has no
  /// site: none.
  std::uint32_t home(std::uint32_t triangle) const;
  /// Calls visit(triangle) for all that have their home at the site of a cone, or had it at first,
  /// and are not apart from the cone.
  template <class Visit>
  void for_each_at_home(Member cone, const Visit& visit) const;

 private:
  struct Cone {
    std::vector<PlaneId> planes;
    std::vector<std::uint32_t> fan;
    PointId inner;  // if it is not convex: one that may be on the inner sides of all planes
    std::vector<std::uint32_t> at_home;
  };
  struct Site {
    Sign inside = Sign::negative;  // of all planes
    std::size_t wedges = 0;        // if it is an edge: has sectors of so many
    std::vector<Cone> cones;
    bool is_edge() const { return wedges > 0; }
  };
  using Fan = std::vector<std::uint32_t>;  // triangles, each a neighbour of the one before it
  using Bounds = std::array<std::vector<PlaneId>, 2>;  // with all below them, or above
  struct Memberships {
    Member home{none, none};
    std::vector<Member> cones;
  };

  Fan fan_at(Corner corner) const;
  EdgeSectors sectors_around(std::span<const Corner> wedges);
  // Two of one site.
  bool are_apart(Member a, Member b) const;
  Bounds bounds_of(const Fan& fan, std::uint32_t vertex) const;
  Cone cone_of(Fan fan) const;
  PointId point_amid(const Fan& fan, Corner corner);
  bool contain(std::span<const PlaneId> planes, Sign inside, const Fan& fan) const;
  bool is_strictly_inside(PointId point, Member cone) const;
  void find_members(Member cone);
  void add_member(std::uint32_t triangle, Member cone);
  bool is_member(std::uint32_t triangle, Member cone) const;
  bool bends_towards_mate(std::uint32_t vertex, std::uint32_t triangle, Member member) const;

  RoundedSurface& rounded_;
  Kernel& kernel_;
  std::vector<Site> sites_;
  std::vector<Memberships> memberships_;                   // per triangle, if there are sites
  std::unordered_map<std::uint32_t, Member> cone_at_;      // per vertex: where it is the tip
  std::unordered_map<std::uint32_t, Memberships> moving_;  // per triangle that moves
  bool has_moved_inside_ = false;
};

template <class Visit>
void TouchingCones::for_each_at_home(Member cone, const Visit& visit) const {
  const auto visit_all = [&](std::size_t of) {
    for (const std::uint32_t t : sites_[cone.site].cones[of].at_home) visit(t);
  };
  const std::size_t n = sites_[cone.site].wedges;
  visit_all(cone.cone);
  if (n == 0) return;
  // A wedge overlaps the gaps before and after it, and a gap the wedges.
  const std::size_t i = cone.cone < n ? cone.cone : cone.cone - n;
  visit_all(cone.cone < n ? n + i : i);
  visit_all(cone.cone < n ? n + (i + n - 1) % n : (i + 1) % n);
}

}  // namespace sectile
