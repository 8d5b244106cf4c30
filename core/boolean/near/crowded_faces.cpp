#include "boolean/near/crowded_faces.h"

#include <algorithm>

#include "boolean/collect.h"
#include "numbers/threshold.h"
#include "search/arc_partition.h"
#include "search/crossing_fans.h"
#include "search/face_corners.h"
#include "search/hull.h"
#include "search/space_partition.h"
#include "storage/geometry_loader.h"

namespace sectile {
namespace {

class CrowdedFaces {
 public:
  CrowdedFaces(const SolidData& a, const SolidData& b,
               const PerOperand<std::span<const std::uint32_t>>& slots, const CommonHubs& hubs)
      : data_{{&a, &b}}, hubs_(hubs) {
    for (const Operand s : both_operands)
      for (const std::uint32_t slot : slots[s])
        for (std::uint32_t f = 0; f < data_[s]->slot(slot).faces; ++f)
          faces_.push_back({s, slot, FaceId(f)});
    find_common_hubs();
  }

  /// From now on, what is around points through which very many edges run is no pair, if it meets
  /// there only. False: there are none.
  bool find_crossings() {
    Geometry geometry;
    const SidedPolygons polygons = sided_faces(geometry);
    crossings_ = CrossingFans(Kernel(geometry), polygons);
    return crossings_.count() > 0;
  }

  FacePairs pairs(const Workspace& w) {
    constexpr std::size_t least_cells = threshold(64, 2);
    for (const Face& f : faces_)
      hulls_.push_back(face_hull(block(f).brep(), block(f).geometry(), f.local));
    const SpacePartition space(rods(), labels());
    const std::vector<SpacePartition::Cell> cells = space.cells(least_cells);
    FacePairs pairs =
        joined(collect<FacePairs>(w, cells.size(), 1, [&](std::size_t cell, FacePairs& out) {
          space.for_each_pair(cells[cell], [&](std::uint32_t i, std::uint32_t j) {
            const auto& [f, g] = std::minmax(i, j);  // those of a have the lower numbers
            if (may_meet(f, g)) out.push_back({in_solid(faces_[f]), in_solid(faces_[g])});
          });
        }));
    for (std::size_t fan = 0; fan < crossings_.count(); ++fan) add_pairs_of_fan(fan, pairs);
    return pairs;
  }

  CrowdedCrossings crossings() const {
    CrowdedCrossings crossings;
    for (std::size_t fan = 0; fan < crossings_.count(); ++fan) {
      PerOperand<std::vector<FaceId>> faces;
      for (const std::uint32_t f : crossings_.at_point(fan))
        faces[faces_[f].solid].push_back(in_solid(faces_[f]));
      crossings.add(crossings_.geometry(), crossings_.point(fan), std::move(faces));
    }
    return crossings;
  }

 private:
  struct Face {
    Operand solid;
    std::uint32_t slot;
    FaceId local;
  };

  const Block& block(const Face& f) const { return *data_[f.solid]->slot(f.slot).block; }
  FaceId in_solid(const Face& f) const { return data_[f.solid]->face(f.slot, f.local); }

  std::vector<SpacePartition::Rod> rods() const {
    std::vector<SpacePartition::Rod> rods;
    rods.reserve(faces_.size());
    for (const Face& f : faces_)
      rods.push_back(with_outer_corners(
          block(f).brep(), block(f).geometry(), f.local,
          [](std::span<const Vec3> corners) { return SpacePartition::Rod(corners); }));
    return rods;
  }
  // Per face, the fan of a hub that both solids have.
  void find_common_hubs() {
    fan_.assign(faces_.size(), Hubs::none);
    if (hubs_.empty()) return;
    PerOperand<std::vector<std::uint32_t>> fans;
    for (std::uint32_t i = 0; i < faces_.size(); ++i) {
      const Face& f = faces_[i];
      const std::vector<std::uint32_t>& of_face = block(f).tree().hubs().of_face();
      if (of_face.empty() || of_face[f.local.value()] == Hubs::none) continue;
      fan_[i] = hubs_.fan(f.solid, f.slot, of_face[f.local.value()]);
      fans[f.solid].push_back(fan_[i]);
    }
    for (std::vector<std::uint32_t>& of_solid : fans) std::ranges::sort(of_solid);
    for (std::uint32_t i = 0; i < faces_.size(); ++i)
      if (!std::ranges::binary_search(fans[other(faces_[i].solid)], fan_[i])) fan_[i] = Hubs::none;
  }

  // What is in one fan is no pair; of others, those of one solid are none.
  std::vector<std::uint32_t> labels() const {
    constexpr std::uint32_t first_crossing = 0x80000000u;
    std::vector<std::uint32_t> labels;
    labels.reserve(faces_.size());
    for (std::uint32_t i = 0; i < faces_.size(); ++i) {
      if (const std::uint32_t crossing = crossing_of(i); crossing != CrossingFans::none)
        labels.push_back(first_crossing + crossing);
      else if (fan_[i] != Hubs::none)
        labels.push_back(2 + fan_[i]);
      else
        labels.push_back(faces_[i].solid == Operand::a ? 0 : 1);
    }
    return labels;
  }
  // Not of what is in the fan of a hub.
  std::uint32_t crossing_of(std::uint32_t face) const {
    return crossings_.count() == 0 || fan_[face] != Hubs::none ? CrossingFans::none
                                                               : crossings_.of_polygon()[face];
  }

  // With the planes beyond the edges within a block.
  SidedPolygons sided_faces(Geometry& geometry) const {
    SidedPolygons polygons;
    std::optional<GeometryLoader> loader;
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      const Face& f = faces_[i];
      const Brep& brep = block(f).brep();
      if (i == 0 || faces_[i - 1].slot != f.slot || faces_[i - 1].solid != f.solid)
        loader.emplace(block(f).geometry(), geometry, brep.vertex_count());
      for_each_in_face(brep, f.local, [&](HalfEdgeId h) {
        const bool leaves = block(f).is_border(h);
        polygons.add_side(
            loader->point(brep.point_of(brep.from(h))), loader->point(brep.point_of(brep.to(h))),
            leaves ? PlaneId() : loader->plane(brep.plane[brep.face_of(Brep::twin(h))]));
      });
      polygons.end_polygon(loader->plane(brep.plane[f.local]), f.solid == Operand::a ? 0 : 1);
    }
    return polygons;
  }

  void add_pairs_of_fan(std::size_t fan, FacePairs& pairs) const {
    PerOperand<std::vector<std::uint32_t>> faces;
    PerOperand<std::vector<SeenArc>> arcs;
    const std::span<const std::uint32_t> all = crossings_.polygons(fan);
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (crossing_of(all[i]) != fan) continue;
      faces[faces_[all[i]].solid].push_back(all[i]);
      arcs[faces_[all[i]].solid].push_back(crossings_.arcs(fan)[i]);
    }
    for_each_pair_of_arcs(arcs[Operand::a], arcs[Operand::b],
                          [&](std::uint32_t i, std::uint32_t j) {
                            const std::uint32_t f = faces[Operand::a][i], g = faces[Operand::b][j];
                            if (may_meet(f, g))
                              pairs.push_back({in_solid(faces_[f]), in_solid(faces_[g])});
                          });
  }

  bool may_meet(std::uint32_t f, std::uint32_t g) const {
    return faces_[f].solid != faces_[g].solid && !apart(hulls_[f], hulls_[g]);
  }

  PerOperand<const SolidData*> data_;
  const CommonHubs& hubs_;
  std::vector<Face> faces_;
  std::vector<std::uint32_t> fan_;
  std::vector<Hull> hulls_;  // per face: some have very many corners
  CrossingFans crossings_;
};

}  // namespace

FacePairs pairs_of_crowded_faces(const Workspace& w, const SolidData& a, const SolidData& b,
                                 const PerOperand<std::span<const std::uint32_t>>& slots,
                                 const CommonHubs& hubs) {
  return CrowdedFaces(a, b, slots, hubs).pairs(w);
}

std::optional<PairsBesideCrossings> pairs_beside_crossings(
    const Workspace& w, const SolidData& a, const SolidData& b,
    const PerOperand<std::span<const std::uint32_t>>& slots, const CommonHubs& hubs) {
  CrowdedFaces faces(a, b, slots, hubs);
  if (!faces.find_crossings()) return {};
  return PairsBesideCrossings{faces.pairs(w), faces.crossings()};
}

}  // namespace sectile
