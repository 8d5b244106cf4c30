// Solids that touch themselves, as manifolds.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "rounding/local_changes.h"
#include "rounding/rounded_surface.h"
#include "rounding/rounding_grid.h"
#include "rounding/touching_cones.h"

namespace sectile {

/// Gives each wedge of material at a place vertices of its own and moves them apart: afterwards
/// each edge, told by the places of its ends, has two triangles, and the triangles at each place
/// are one fan. Nothing meets that did not meet before.
class Separation {
 public:
  /// The surface must be legal.
  Separation(RoundedSurface& rounded, Kernel& kernel, const RoundingGrid& grid,
             const Rounding& options)
      : rounded_(rounded),
        kernel_(kernel),
        grid_(grid),
        options_(options),
        cones_(rounded, kernel) {}

  struct Result {
    std::size_t moved = 0;               ///< vertices
    std::size_t most_at_a_place = 1;     ///< or along an edge, before
    std::vector<std::uint32_t> cramped;  ///< vertices that touch others still: there is no room
  };
  Result run();

 private:
  struct Edge {
    std::uint32_t low, high, triangle, k;
    friend auto operator<=>(const Edge&, const Edge&) = default;
  };

  using Place = std::array<double, 3>;
  struct Located {
    Place place;
    std::uint32_t vertex;
    TouchingCones::Corner corner;  // of a triangle there
  };

  /// Wedges that have the places of both ends of an edge in common.
  struct CommonEdge {
    std::vector<Edge> wedges;
    std::vector<TouchingCones::Member> cones;  // of the wedges
  };

  void find_fans();
  void find_places();
  void give_fans_vertices();
  std::vector<CommonEdge> edges_in_common() const;
  void find_cones(std::vector<CommonEdge>& edges);
  void divide_edges(const std::vector<CommonEdge>& edges);
  std::uint32_t triangle_with(const Edge& edge) const;
  std::uint32_t divide(std::uint32_t s, std::size_t j);
  void divide_half(std::uint32_t t, std::size_t k, std::uint32_t middle);
  std::uint32_t add_vertex(PointId point, const Vec3& origin, bool is_exact);
  std::vector<std::uint32_t> vertices_to_move() const;
  std::vector<std::uint32_t> move_all(LocalChanges& changes, std::vector<std::uint32_t> waiting);
  std::vector<std::uint32_t> move_within_cones(LocalChanges& changes,
                                               std::vector<std::uint32_t> waiting);
  std::vector<std::uint32_t> move_out_of_cones(LocalChanges& changes,
                                               const std::vector<std::uint32_t>& waiting);
  template <class Visit>
  void for_each_touching(const Visit& visit) const;
  void check_cancel() const;
  double greatest_step(const std::vector<std::uint32_t>& vertices) const;
  bool move_apart(LocalChanges& changes, std::uint32_t vertex, double reach);
  bool move_to_one_of(LocalChanges& changes, std::uint32_t vertex, const std::vector<Vec3>& places);
  bool may_leave_cone(const LocalChanges& changes, std::uint32_t vertex) const;
  double room_around(const LocalChanges& changes, std::uint32_t vertex) const;
  double step_around(const LocalChanges& changes, std::uint32_t vertex) const;
  double leaving(double from, double way) const;
  std::vector<Vec3> ways_from(const LocalChanges& changes, std::uint32_t vertex) const;
  std::vector<Vec3> places_near(const LocalChanges& changes, std::uint32_t vertex,
                                double step) const;
  std::vector<Vec3> places_within(const LocalChanges& changes, std::uint32_t vertex,
                                  double far) const;
  bool is_middle(std::uint32_t vertex) const;
  bool is_alone(std::uint32_t vertex) const;
  bool is_taken(const Vec3& place) const;
  Vec3 to_edge(std::uint32_t vertex) const;
  Place place(std::uint32_t vertex) const {
    const Vec3& p = rounded_.position(vertex);
    return {p.x + 0.0, p.y + 0.0, p.z + 0.0};
  }

  RoundedSurface& rounded_;
  Kernel& kernel_;
  const RoundingGrid& grid_;
  const Rounding& options_;
  TouchingCones cones_;
  std::vector<std::uint32_t> fan_;      // per corner of a triangle: the least one around the vertex
  std::vector<Located> located_;        // all vertices but for middles, ascending
  std::vector<std::uint32_t> middles_;  // of divided edges, ascending
  std::vector<Vec3> to_edge_;           // from each of them, where it is at first
  std::map<std::uint32_t, std::vector<std::uint32_t>> cut_off_;  // per triangle: from it
  std::map<std::uint32_t, std::uint32_t> whole_;  // of what was cut off: the triangle
  std::map<Place, std::uint32_t> many_;           // how many vertices there are
  std::size_t moved_ = 0;
  std::uint64_t most_tested_ = 0;  // pairs of triangles, before cones are left at last only
};

}  // namespace sectile
