#include "boolean/near/crowded_faces.h"

#include "boolean/collect.h"
#include "numbers/threshold.h"
#include "search/face_corners.h"
#include "search/hull.h"
#include "search/space_partition.h"

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
    for (const Face& f : faces_)
      hulls_.push_back(face_hull(block(f).brep(), block(f).geometry(), f.local));
  }

  FacePairs pairs(const Workspace& w) const {
    constexpr std::size_t least_cells = threshold(64, 2);
    const SpacePartition space(rods(), labels());
    const std::vector<SpacePartition::Cell> cells = space.cells(least_cells);
    return joined(collect<FacePairs>(w, cells.size(), 1, [&](std::size_t cell, FacePairs& out) {
      space.for_each_pair(cells[cell], [&](std::uint32_t i, std::uint32_t j) {
        const auto& [f, g] = std::minmax(i, j);  // those of a have the lower numbers
        if (may_meet(f, g)) out.push_back({in_solid(faces_[f]), in_solid(faces_[g])});
      });
    }));
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
  // What is in one fan is no pair; of others, those of one solid are none.
  std::vector<std::uint32_t> labels() const {
    std::vector<std::uint32_t> labels;
    labels.reserve(faces_.size());
    for (const Face& f : faces_) {
      const std::uint32_t hub = hubs_.empty() ? Hubs::none : hub_of(f);
      const std::uint32_t solid = f.solid == Operand::a ? 0 : 1;
      labels.push_back(hub == Hubs::none ? solid : 2 + hubs_.fan(f.solid, f.slot, hub));
    }
    return labels;
  }
  std::uint32_t hub_of(const Face& f) const {
    const std::vector<std::uint32_t>& of_face = block(f).tree().hubs().of_face();
    return of_face.empty() ? Hubs::none : of_face[f.local.value()];
  }

  bool may_meet(std::uint32_t f, std::uint32_t g) const {
    return faces_[f].solid != faces_[g].solid && !apart(hulls_[f], hulls_[g]);
  }

  PerOperand<const SolidData*> data_;
  const CommonHubs& hubs_;
  std::vector<Face> faces_;
  std::vector<Hull> hulls_;  // per face: some have very many corners
};

}  // namespace

FacePairs pairs_of_crowded_faces(const Workspace& w, const SolidData& a, const SolidData& b,
                                 const PerOperand<std::span<const std::uint32_t>>& slots,
                                 const CommonHubs& hubs) {
  return CrowdedFaces(a, b, slots, hubs).pairs(w);
}

}  // namespace sectile
