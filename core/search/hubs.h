// Hubs: points in which very many faces of a solid meet (the apex of a fine cone).
//
// Around a hub all boxes overlap, so boxes say nothing about which faces of two fans meet. What
// tells is the direction in which each face leaves the hub. Where very many edges run between two
// hubs (the back of a book of thin walls), walls leave their line in different directions.
#pragma once

#include <span>
#include <vector>

#include "geometry/geometry.h"
#include "numbers/threshold.h"
#include "search/edges_by_line.h"
#include "topology/brep.h"

namespace sectile {

class SeenArc;

class Hubs {
 public:
  static constexpr std::uint32_t none = 0xFFFFFFFFu;
  static constexpr std::uint32_t least_faces = threshold(16, 3);  ///< half of a small block

  /// The line between two hubs along which many edges run.
  using Spine = PointPair;
  /// Those between which there are so many edges.
  static std::vector<Spine> spines_among(std::vector<Spine> edges, std::uint32_t least);

  Hubs() = default;
  explicit Hubs(const Brep& brep);

  bool empty() const { return points_.empty(); }
  std::size_t size() const { return points_.size(); }
  PointId point(std::size_t hub) const { return points_[hub]; }
  /// The faces of its fan; a face belongs to one hub at most.
  std::span<const FaceId> faces(std::size_t hub) const {
    const std::size_t from = hub == 0 ? 0 : face_end_[hub - 1];
    return std::span(faces_).subspan(from, face_end_[hub] - from);
  }
  /// Per face: its hub, or none. Empty if there are no hubs.
  const std::vector<std::uint32_t>& of_face() const { return of_face_; }
  std::span<const Spine> spines() const { return spines_; }

 private:
  void find_spines(const Brep& brep, const std::vector<std::uint32_t>& hub_at);

  std::vector<PointId> points_;
  std::vector<std::uint32_t> of_face_, face_end_;
  std::vector<FaceId> faces_;
  std::vector<Spine> spines_;
};

/// How the faces of a fan are seen from the hub.
std::vector<SeenArc> arcs_seen_from(PointId hub, const Brep& brep, const Geometry& geometry,
                                    std::span<const FaceId> faces);

}  // namespace sectile
