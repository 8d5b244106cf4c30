// Tentative changes of a rounded surface: a vertex moves, goes to another one, or an edge becomes
// the other diagonal. What they make better or worse is counted exactly.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <unordered_map>
#include <vector>

#include "rounding/near_triangles.h"
#include "rounding/rounded_surface.h"
#include "rounding/touching_cones.h"
#include "selftest/triangle_pair.h"

namespace sectile {

class LocalChanges {
 public:
  LocalChanges(RoundedSurface& rounded, Kernel& kernel) : LocalChanges(rounded, kernel, nullptr) {}
  /// Of each change is asked whether it is free. All are moves, and each edge has two triangles.
  LocalChanges(RoundedSurface& rounded, Kernel& kernel, TouchingCones& cones)
      : LocalChanges(rounded, kernel, &cones) {}

  /// The living triangles around a vertex.
  std::vector<std::uint32_t> star(std::uint32_t vertex) const;
  /// How many things are wrong with these triangles: pairs with any other that meet as they must
  /// not, and, twice, triangles without area. Counts no farther than `most`.
  std::size_t faults(std::span<const std::uint32_t> triangles, std::size_t most = no_limit) const;
  /// Those with which a triangle meets as it must not.
  std::vector<std::uint32_t> opponents(std::uint32_t triangle) const;

  /// How many pairs of triangles were tested so far: what all of it costs.
  std::uint64_t tested_pairs() const { return tested_pairs_; }

  /// One change at a time, to be kept or undone. False if there is no such change, or it concerns
  /// fixed vertices.
  bool move(std::uint32_t vertex, const Vec3& to);
  bool merge(std::uint32_t vertex, std::uint32_t into);
  /// Edge k of a triangle.
  bool flip(std::uint32_t triangle, std::size_t k);
  /// Is less wrong with the triangles that the change concerns than before?
  bool is_better() const { return faults(concerned_, before_) < before_; }
  /// Is nothing wrong with them?
  bool is_free();
  void keep();
  void undo();
  /// Vertices will move by so much, or little more.
  void leave_room(double room) { near_.leave_room(room); }

  struct Join {
    std::uint32_t vertex, into;
  };
  /// Merges vertices into others, which stay, and keeps that, whatever it leaves wrong. None of it
  /// may concern fixed vertices.
  void join(std::span<const Join> joins);

 private:
  static constexpr std::size_t no_limit = 0xFFFFFFFFu;
  static constexpr std::uint32_t no_vertex = 0xFFFFFFFFu;
  struct Side {
    std::uint32_t triangle;
    std::size_t edge;
  };
  struct Saved {
    std::uint32_t triangle;
    RoundedSurface::Corners corners;
    std::array<PointId, 3> points;
    PlaneId plane;
    std::array<std::uint32_t, 3> mate;
    std::uint8_t alive, ignored;
  };

  LocalChanges(RoundedSurface& rounded, Kernel& kernel, TouchingCones* cones);

  bool any_fixed(std::span<const std::uint32_t> triangles) const;
  void begin(std::vector<std::uint32_t> triangles, std::uint32_t around = no_vertex);
  void count_before(std::uint32_t around);
  void save_concerned();
  void save(std::uint32_t triangle);
  void note_flat();
  void settle();
  void renew(std::uint32_t triangle);
  void kill(std::uint32_t triangle);
  void cancel_opposites();
  void find_mates(std::uint32_t triangle);
  void pair_edge(std::uint32_t from, std::uint32_t to);
  void pair_edges();
  void pair_sides(std::uint32_t from, std::uint32_t to, std::vector<Side> forward,
                  std::vector<Side> backward);
  void sort_wedges(std::uint32_t from, std::uint32_t to, std::vector<Side>& forward,
                   std::vector<Side>& backward) const;
  bool is_flat(std::uint32_t triangle) const;
  bool meet(std::uint32_t s, std::uint32_t t) const;
  bool is_met_again() const;

  RoundedSurface& rounded_;
  Kernel& kernel_;
  TrianglePairs pairs_;
  TouchingCones* cones_;  // only where is asked what is free
  NearTriangles near_;
  std::vector<std::uint32_t> first_, around_;  // triangles around each vertex, at first
  std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> more_;  // and those that came
  std::vector<std::uint32_t> concerned_;
  std::vector<Saved> saved_;
  std::uint32_t moved_vertex_ = 0;
  PointId moved_from_;
  std::size_t before_ = 0;
  mutable std::array<std::uint32_t, 2> met_{};  // two triangles that met last
  mutable std::uint64_t tested_pairs_ = 0;
  // What is wrong around vertices, until a change is kept.
  std::unordered_map<std::uint32_t, std::size_t> before_at_;
};

}  // namespace sectile
